/** A joystick for finger, mouse or keys. */

import { element } from "./elements";

/** Its position, `forward` and `right` from -1 to 1. */
export interface Push {
  readonly forward: number;
  readonly right: number;
}

const KEYS: Record<string, Push> = {
  ArrowUp: { forward: 1, right: 0 },
  ArrowDown: { forward: -1, right: 0 },
  ArrowLeft: { forward: 0, right: -1 },
  ArrowRight: { forward: 0, right: 1 },
  KeyW: { forward: 1, right: 0 },
  KeyS: { forward: -1, right: 0 },
  KeyA: { forward: 0, right: -1 },
  KeyD: { forward: 0, right: 1 },
};
/** The position for a pressed key, which is all or nothing. */
const KEY_FORWARD = 0.7;
const KEY_RIGHT = 0.5;
/** The dead zone, as a fraction of its radius. */
const REST = 0.12;

function limit(value: number): number {
  return Math.min(1, Math.max(-1, value));
}

/** `change` receives its position, and null on release. */
export class Stick {
  private readonly knob = element("div", { class: "knob" });
  readonly dom = element("div", { class: "stick", role: "application", tabindex: "0" }, this.knob);
  private readonly keys = new Set<string>();
  private enabled = true;
  private held = false;

  constructor(private readonly change: (push: Push | null) => void) {
    this.dom.onpointerdown = (event) => this.grab(event);
    this.dom.onpointermove = (event) => this.drag(event);
    this.dom.onpointerup = this.dom.onpointercancel = () => this.release();
    this.dom.onkeydown = (event) => this.press(event);
    this.dom.onkeyup = (event) => this.lift(event);
    this.dom.onblur = () => this.release();
  }

  enable(on: boolean): void {
    this.enabled = on;
    this.dom.setAttribute("aria-disabled", String(!on));
    if (!on) this.release();
  }

  release(): void {
    this.keys.clear();
    if (!this.held) return;
    this.held = false;
    this.draw({ forward: 0, right: 0 });
    this.change(null);
  }

  private grab(event: PointerEvent): void {
    if (!this.enabled) return;
    this.dom.setPointerCapture(event.pointerId);
    this.drag(event);
  }

  private drag(event: PointerEvent): void {
    if (!this.enabled || !this.dom.hasPointerCapture(event.pointerId)) return;
    const box = this.dom.getBoundingClientRect();
    const across = limit(((event.clientX - box.left) / box.width) * 2 - 1);
    const up = limit(1 - ((event.clientY - box.top) / box.height) * 2);
    const isStill = Math.hypot(across, up) < REST;
    this.push(isStill ? { forward: 0, right: 0 } : { forward: up, right: across });
  }

  private press(event: KeyboardEvent): void {
    if (!this.enabled || !KEYS[event.code] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.keys.add(event.code);
    this.pushByKeys();
  }

  private lift(event: KeyboardEvent): void {
    if (!this.keys.delete(event.code)) return;
    if (this.keys.size === 0) this.release();
    else this.pushByKeys();
  }

  private pushByKeys(): void {
    const pushes = [...this.keys].map((key) => KEYS[key]).filter((push) => push !== undefined);
    const forward = limit(pushes.reduce((sum, push) => sum + push.forward, 0)) * KEY_FORWARD;
    const right = limit(pushes.reduce((sum, push) => sum + push.right, 0)) * KEY_RIGHT;
    this.push({ forward, right });
  }

  private push(push: Push): void {
    this.held = true;
    this.draw(push);
    this.change(push);
  }

  private draw({ forward, right }: Push): void {
    this.knob.style.translate = `${right * 100}% ${-forward * 100}%`;
  }
}
