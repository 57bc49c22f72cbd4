/** A button with a menu, usable with the usual keys. */

import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";

import { Icon, type IconName } from "./icons";
import "./menu.css";

export interface MenuItem {
  readonly text: string;
  /** For one of several choices: whether it is selected. */
  readonly checked?: boolean;
  /** Starts a new group. */
  readonly separated?: boolean;
  readonly run: () => void;
}

interface Props {
  readonly label: string;
  readonly icon?: IconName;
  /** What the button shows beside the icon. */
  readonly children?: ComponentChildren;
  readonly items: readonly MenuItem[];
  /** The side of the button to which the menu is aligned. */
  readonly side?: "left" | "right";
}

export function Menu({ label, icon, children, items, side = "left" }: Props) {
  const open = useSignal(false);
  const root = useRef<HTMLDivElement>(null);
  const list = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (open.value) focusable(list.current)[0]?.focus();
  }, [open.value]);
  const left = (event: FocusEvent) => {
    if (leaves(root.current, event)) open.value = false;
  };
  const pressed = (event: KeyboardEvent) => {
    if (event.key !== "ArrowDown") return;
    open.value = true;
    event.preventDefault();
  };
  const close = () => {
    open.value = false;
    root.current?.querySelector("button")?.focus();
  };
  return (
    <div class="menu" ref={root} onFocusOut={left}>
      <button
        type="button"
        class="button"
        title={label}
        aria-label={children ? undefined : label}
        aria-haspopup="menu"
        aria-expanded={open.value}
        onClick={() => (open.value = !open.value)}
        onKeyDown={pressed}
      >
        {icon && <Icon name={icon} />}
        {children}
      </button>
      {open.value && (
        <div
          class={`menu-list ${side}`}
          role="menu"
          aria-label={label}
          ref={list}
          onKeyDown={(event) => navigate(event, close)}
        >
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
    // biome-ignore lint/a11y/useAriaPropsSupportedByRole: it is only set for the role that has it
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

/** Move in the menu by a key; return whether the key does so. */
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

/** The next item that begins with a letter; -1 if there is none. */
function letter(items: HTMLElement[], at: number, key: string): number {
  if (key.length !== 1 || key === " ") return -1;
  const begins = (index: number) => items[index]?.textContent?.toLowerCase().startsWith(key.toLowerCase());
  const order = items.map((_, step) => (at + 1 + step) % items.length);
  return order.find(begins) ?? -1;
}
