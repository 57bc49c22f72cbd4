/** A button that opens a menu, by the usual keys. */

import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";

import { Icon, type IconName } from "./icons";
import "./menu.css";

export interface MenuItem {
  readonly text: string;
  /** Of a choice among several: whether it is the present one. */
  readonly checked?: boolean;
  /** Begins a new group. */
  readonly separated?: boolean;
  readonly run: () => void;
}

interface Props {
  readonly label: string;
  readonly icon?: IconName;
  /** What stands on the button beside the icon. */
  readonly children?: ComponentChildren;
  readonly items: readonly MenuItem[];
  /** On which side of the button the menu's edge lies. */
  readonly side?: "left" | "right";
}

export function Menu({ label, icon, children, items, side = "left" }: Props) {
  const open = useSignal(false);
  const root = useRef<HTMLDivElement>(null);
  const list = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (open.value) focusable(list.current)[0]?.focus();
  }, [open.value]);
  const close = () => {
    open.value = false;
    root.current?.querySelector("button")?.focus();
  };
  return (
    <div class="menu" ref={root} onFocusOut={(event) => leaves(root.current, event) && (open.value = false)}>
      <button
        type="button"
        class="button"
        title={label}
        aria-label={children ? undefined : label}
        aria-haspopup="menu"
        aria-expanded={open.value}
        onClick={() => (open.value = !open.value)}
        onKeyDown={(event) => event.key === "ArrowDown" && ((open.value = true), event.preventDefault())}
      >
        {icon && <Icon name={icon} />}
        {children}
      </button>
      {open.value && (
        <div class={`menu-list ${side}`} role="menu" aria-label={label} ref={list} onKeyDown={(event) => navigate(event, close)}>
          {items.map((item) => (
            <Item key={item.text} item={item} close={close} />
          ))}
        </div>
      )}
    </div>
  );
}

function Item({ item, close }: { item: MenuItem; close: () => void }) {
  const choice = item.checked !== undefined;
  return (
    <button
      type="button"
      role={choice ? "menuitemradio" : "menuitem"}
      aria-checked={choice ? item.checked : undefined}
      class={item.separated ? "separated" : undefined}
      tabIndex={-1}
      onClick={() => {
        close();
        item.run();
      }}
    >
      {item.text}
      {item.checked && <Icon name="check" />}
    </button>
  );
}

function focusable(list: HTMLElement | null): HTMLElement[] {
  return [...(list?.querySelectorAll<HTMLElement>("[role^=menuitem]") ?? [])];
}

function leaves(root: HTMLElement | null, event: FocusEvent): boolean {
  return !root?.contains(event.relatedTarget as Node | null);
}

function navigate(event: KeyboardEvent, close: () => void): void {
  if (event.key === "Escape" || event.key === "Tab") close();
  else if (!moveTo(event)) return;
  if (event.key !== "Tab") event.preventDefault();
  event.stopPropagation();
}

/** Whether the key moves within the menu, and if so, move. */
function moveTo(event: KeyboardEvent): boolean {
  const items = focusable(event.currentTarget as HTMLElement);
  const at = items.indexOf(document.activeElement as HTMLElement);
  const targets: Record<string, number> = {
    ArrowDown: (at + 1) % items.length,
    ArrowUp: (at - 1 + items.length) % items.length,
    Home: 0,
    End: items.length - 1,
  };
  const target = targets[event.key] ?? letter(items, at, event.key);
  items[target]?.focus();
  return target >= 0;
}

/** The next item that begins with a letter; -1 where there is none. */
function letter(items: HTMLElement[], at: number, key: string): number {
  if (key.length !== 1 || key === " ") return -1;
  const begins = (index: number) => items[index]?.textContent?.toLowerCase().startsWith(key.toLowerCase());
  const order = items.map((_, step) => (at + 1 + step) % items.length);
  return order.find(begins) ?? -1;
}
