/** Puts the focus where one types next, in whatever opens. */

const TYPED = ["text", "search", "number", "url", "email", "password", "tel"];
const FIELDS = [
  "input:not([type])",
  ...TYPED.map((type) => `input[type=${type}]`),
  "textarea",
  "[contenteditable=true]",
].join();
/** What may be chosen for the focus instead of a field. */
const CHOSEN = "button[autofocus], select[autofocus]";
/** What finds its own entries by their letters. */
const SPELT = "select, dialog, [role=menu], [role=listbox], [role=grid]";
/** Buttons that open nothing: the focus stays on them. */
const STAYING = "[role=tab], [role=radio], [role=switch], [aria-pressed]";

/** Whether letters are typed into an element. */
export function isTyped(element: EventTarget | null): boolean {
  return element instanceof HTMLElement && (element.isContentEditable || element.matches(FIELDS));
}

/** Whether keys have a meaning of their own in an element: what is typed there is never a shortcut. */
export function takesKeys(element: EventTarget | null): boolean {
  return isTyped(element) || (element instanceof Element && element.closest(SPELT) !== null);
}

/**
 * Focus the first field of what has just opened, and later the first field that a button in it adds, also if the field
 * comes some time after. What the user has focused or typed meanwhile comes first. Call the result to stop.
 */
export function followTyping(part: HTMLElement): () => void {
  // On a touch screen the keyboard would cover half of it: there only `autofocus` chooses a field, or anywhere what is
  // not typed into.
  const isChosen = matchMedia("(pointer: coarse)").matches || part.querySelector(CHOSEN) !== null;
  let known: ReadonlySet<Element> | null = isChosen ? null : new Set();
  const fields = () => [...part.querySelectorAll<HTMLElement>(FIELDS)];
  const look = () => {
    if (known === null || isTyped(document.activeElement)) return;
    if (fields().some((field) => !known?.has(field) && takesFocus(field, part))) known = null;
  };
  const acted = () => (known = null);
  const pressed = ({ target }: Event) => {
    const button = (target as Element).closest("button");
    if (button && !button.matches(STAYING)) known = new Set(fields());
  };
  const listening = new AbortController();
  const { signal } = listening;
  part.addEventListener("pointerdown", acted, { signal, capture: true });
  part.addEventListener("keydown", acted, { signal, capture: true });
  part.addEventListener("click", pressed, { signal, capture: true });
  const changes = new MutationObserver(look);
  changes.observe(part, { subtree: true, childList: true });
  look();
  return () => {
    listening.abort();
    changes.disconnect();
  };
}

/** Focus a field, unless it is hidden or beyond the edge of what has opened; return whether it has the focus. */
function takesFocus(field: HTMLElement, part: HTMLElement): boolean {
  const [inner, outer] = [field.getBoundingClientRect(), part.getBoundingClientRect()];
  if (inner.top < outer.top || inner.top > outer.bottom) return false;
  field.focus({ preventScroll: true });
  return document.activeElement === field;
}
