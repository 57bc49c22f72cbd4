/** Dragging from a button of the palette into the world. */

/** Pixels after which a press is a drag. */
const FAR = 6;

export interface Carried {
  /** The drag has begun or moved. */
  move(event: PointerEvent): void;
  /** The drag ended here. */
  drop(event: PointerEvent): void;
  /** The drag ended without a place. */
  cancel(): void;
}

/** Report drags that begin on a button; its click still works. */
export function carries(button: HTMLButtonElement, carried: Carried): void {
  let from: PointerEvent | null = null;
  let far = false;
  let ghost: HTMLElement | null = null;
  const end = (): void => {
    ghost?.remove();
    ghost = null;
    from = null;
  };
  button.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || button.disabled) return;
    [from, far] = [event, false];
    button.setPointerCapture(event.pointerId);
  });
  button.addEventListener("pointermove", (event) => {
    if (!from) return;
    far ||= Math.hypot(event.clientX - from.clientX, event.clientY - from.clientY) > FAR;
    if (!far) return;
    ghost ??= ghostOf(button);
    ghost?.style.setProperty("translate", `${event.clientX}px ${event.clientY}px`);
    carried.move(event);
  });
  button.addEventListener("pointerup", (event) => {
    if (from && far) carried.drop(event);
    end();
  });
  button.addEventListener("pointercancel", () => {
    if (from && far) carried.cancel();
    end();
    far = false;
  });
  // The click after a drag would begin to put another object.
  button.addEventListener("click", (event) => far && event.stopImmediatePropagation(), { capture: true });
}

/** A copy of the button's picture, which follows the pointer; null before it is drawn. */
function ghostOf(button: HTMLButtonElement): HTMLElement | null {
  const picture = button.querySelector("canvas");
  if (!picture) return null;
  const copy = picture.cloneNode() as HTMLCanvasElement;
  copy.getContext("2d")?.drawImage(picture, 0, 0);
  copy.className = "editor-carried";
  button.append(copy);
  return copy;
}
