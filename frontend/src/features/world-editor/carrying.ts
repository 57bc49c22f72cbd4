/** Dragging from a button of the palette onto the plan. */

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
  button.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || button.disabled) return;
    [from, far] = [event, false];
    button.setPointerCapture(event.pointerId);
  });
  button.addEventListener("pointermove", (event) => {
    if (!from) return;
    far ||= Math.hypot(event.clientX - from.clientX, event.clientY - from.clientY) > FAR;
    if (far) carried.move(event);
  });
  button.addEventListener("pointerup", (event) => {
    if (from && far) carried.drop(event);
    from = null;
  });
  button.addEventListener("pointercancel", () => {
    if (from && far) carried.cancel();
    from = null;
    far = false;
  });
  // The click after a drag would begin to put another object.
  button.addEventListener("click", (event) => far && event.stopImmediatePropagation(), { capture: true });
}
