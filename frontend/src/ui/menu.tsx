/** A button with a menu, usable with the usual keys. */

import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { Icon, type IconName } from "./icons";
import "./menu.css";

export interface MenuItem {
  readonly text: string;
  readonly icon?: IconName;
  /** The address of a picture that shows what it chooses. */
  readonly picture?: string | undefined;
  /** For one of several choices: whether it is selected. */
  readonly checked?: boolean;
  /** For a switch: whether it is on. */
  readonly on?: boolean;
  /** It is shown, but can't be chosen now. */
  readonly off?: boolean;
  /** A key that does the same. */
  readonly key?: string;
  readonly run: () => void;
}

/** Items that belong together. */
export interface MenuGroup {
  readonly title?: string;
  readonly items: readonly MenuItem[];
}

/** px between a menu and the edge of the window. */
const MARGIN = 8;
/** px between a menu and its button. */
const GAP = 6;

type Side = "left" | "right";

interface Props {
  readonly label: string;
  readonly icon?: IconName;
  /** What the button shows beside the icon. */
  readonly children?: ComponentChildren;
  readonly groups: readonly MenuGroup[];
  /** A class of the button. */
  readonly look?: string;
  /** Of the button: -1 where other keys lead to it. */
  readonly tabIndex?: number;
  /** The side of the button to which the menu is aligned. */
  readonly side?: Side;
  /** Called when it has been opened or closed. */
  readonly toggled?: (isOpen: boolean) => void;
}

export function Menu({ label, icon, children, groups, look, tabIndex, side = "left", toggled }: Props) {
  const open = useSignal(false);
  const root = useRef<HTMLDivElement>(null);
  const list = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    return open.value && list.current && root.current ? show(list.current, root.current, side) : undefined;
  }, [open.value]);
  useEffect(() => {
    if (!open.value) return;
    toggled?.(true);
    return () => toggled?.(false);
  }, [open.value]);
  const left = (event: FocusEvent) => {
    if (leaves(root.current, event)) open.value = false;
  };
  const pressed = (event: KeyboardEvent) => {
    // Escape may come before the focus has moved into the menu.
    if (event.key !== "ArrowDown" && !(event.key === "Escape" && open.value)) return;
    open.value = event.key === "ArrowDown";
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
        class={look ? `button ${look}` : "button"}
        title={label}
        tabIndex={tabIndex}
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
          class="menu-list"
          role="menu"
          popover="manual"
          aria-label={label}
          ref={list}
          onKeyDown={(event) => navigate(event, close)}
        >
          {/* It scrolls in a box without a background of its own: Chromium would leave out what an opaque one
              could cover if it were not cut, such as the world above the menu. */}
          <div class="menu-items">
            {groups.map((group, index) => (
              <Group key={index} group={group} close={close} />
            ))}
          </div>
        </div>
      )}
    </div>
  );
}

function Group({ group: { title, items }, close }: { group: MenuGroup; close: () => void }) {
  if (items.length === 0) return null;
  return (
    <div role="group" class="menu-group" aria-label={title}>
      {title && (
        <p class="menu-title" aria-hidden="true">
          {title}
        </p>
      )}
      {items.map((item) => (
        <Item key={item.text} item={item} close={close} />
      ))}
    </div>
  );
}

function Item({ item, close }: { item: MenuItem; close: () => void }) {
  const { text, icon, picture, checked, on, off, key, run } = item;
  return (
    // biome-ignore lint/a11y/useAriaPropsSupportedByRole: it is only set for the roles that have it
    <button
      type="button"
      role={roleOf(item)}
      aria-checked={checked ?? on}
      aria-label={text}
      aria-keyshortcuts={key}
      aria-disabled={off ? "true" : undefined}
      tabIndex={-1}
      onClick={() => {
        if (off) return;
        close();
        run();
      }}
    >
      {icon && <Icon name={icon} />}
      {picture && <img class="menu-picture" src={picture} alt="" width={400} height={200} />}
      <span class="menu-text">{text}</span>
      {/* The style sheet shows it: as text, it would have to be part of the name. */}
      {key && <kbd data-key={key} />}
      {(checked || on) && <Icon name="check" />}
    </button>
  );
}

function roleOf({ checked, on }: MenuItem) {
  if (checked !== undefined) return "menuitemradio";
  return on === undefined ? "menuitem" : "menuitemcheckbox";
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

/** Show a menu above everything else, so that no pane cuts it; return what stops following its button. */
function show(list: HTMLElement, button: HTMLElement, side: Side): () => void {
  const follow = () => place(list, button.getBoundingClientRect(), side);
  const stop = new AbortController();
  const { signal } = stop;
  // It may grow while it is open, such as that of the robots nearby.
  const sizes = new ResizeObserver(follow);
  list.showPopover();
  follow();
  // At once: later it would take the focus back from what is used next.
  focusable(list)[0]?.focus();
  sizes.observe(list);
  window.addEventListener("resize", follow, { signal });
  window.addEventListener("scroll", follow, { signal, capture: true });
  return () => {
    sizes.disconnect();
    stop.abort();
  };
}

/** Place a menu below its button, or above it where there is more room, inside the window. */
function place(list: HTMLElement, button: DOMRect, side: Side): void {
  const space = GAP + MARGIN;
  const [above, below] = [button.top - space, window.innerHeight - button.bottom - space];
  const isUp = list.offsetHeight > below && above > below;
  const wanted = side === "left" ? button.left : button.right - list.offsetWidth;
  const rightmost = window.innerWidth - MARGIN - list.offsetWidth;
  list.style.left = `${Math.max(MARGIN, Math.min(wanted, rightmost))}px`;
  list.style.top = isUp ? "auto" : `${button.bottom + GAP}px`;
  list.style.bottom = isUp ? `${window.innerHeight - button.top + GAP}px` : "auto";
  list.style.setProperty("--room", `${isUp ? above : below}px`);
}
