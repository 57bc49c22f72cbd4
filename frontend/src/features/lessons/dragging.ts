/** Dragging the pieces of a puzzle with a mouse; for the keyboard and for fingers there are buttons. */

/** px before a press becomes a drag. */
const FAR = 5;
/** px around the program in which a piece still falls into it. */
const NEAR = 24;

/** Takes a piece and its new place in the program; null for none. */
type Drop = (piece: number, at: number | null) => void;

/** Let the pieces in a puzzle be dragged; call the result to end that. */
export function draggable(root: HTMLElement, drop: Drop): () => void {
  const begin = (event: PointerEvent) => {
    const target = event.target as Element;
    const item = target.closest<HTMLElement>("li[data-piece]");
    const isTool = target.closest("button:not(.lesson-piece)") !== null;
    if (item && !isTool && event.pointerType === "mouse" && event.button === 0) drag(event, { root, item, drop });
  };
  root.addEventListener("pointerdown", begin);
  return () => root.removeEventListener("pointerdown", begin);
}

interface Dragged {
  readonly root: HTMLElement;
  readonly item: HTMLElement;
  readonly drop: Drop;
}

function drag(start: PointerEvent, { root, item, drop }: Dragged): void {
  const ends = new AbortController();
  const { signal } = ends;
  let isMoving = false;
  const move = (event: PointerEvent) => {
    const [x, y] = [event.clientX - start.clientX, event.clientY - start.clientY];
    isMoving ||= Math.hypot(x, y) >= FAR;
    if (!isMoving) return;
    item.classList.add("dragged");
    item.style.translate = `${x}px ${y}px`;
  };
  const end = (event: PointerEvent) => {
    ends.abort();
    item.classList.remove("dragged");
    item.style.translate = "";
    if (!isMoving) return;
    swallowClick();
    if (event.type === "pointerup") drop(Number(item.dataset.piece), placeAt(root, item, event));
  };
  window.addEventListener("pointermove", move, { signal });
  window.addEventListener("pointerup", end, { signal });
  window.addEventListener("pointercancel", end, { signal });
}

/** The place in the program at which a piece is let go; null beside the program. */
function placeAt(root: HTMLElement, item: HTMLElement, { clientX, clientY }: PointerEvent): number | null {
  const list = root.querySelector(".lesson-order");
  if (!list) return null;
  const { left, right, top, bottom } = list.getBoundingClientRect();
  const isInside = clientX > left - NEAR && clientX < right + NEAR && clientY > top - NEAR && clientY < bottom + NEAR;
  if (!isInside) return null;
  const others = [...list.querySelectorAll("li")].filter((one) => one !== item);
  return others.filter((one) => middleOf(one) < clientY).length;
}

function middleOf(element: Element): number {
  const { top, bottom } = element.getBoundingClientRect();
  return (top + bottom) / 2;
}

/** The browser may send a click after a drag, which must not add the piece. */
function swallowClick(): void {
  const swallow = (event: Event) => event.stopPropagation();
  window.addEventListener("click", swallow, { capture: true, once: true });
  setTimeout(() => window.removeEventListener("click", swallow, { capture: true }));
}
