/** The plan: the world from above, where objects are dragged, turned and bent. */

import { effect, untracked } from "@preact/signals";
import { t } from "../../i18n";
import { css } from "../../views/world/scenery/colours";
import type { WorldValues, XY } from "../../views/world/scenery/description";
import type { Draft } from "./drafts";
import { type Handle, handlesOf } from "./handles";
import { shapesOf } from "./shapes";
import { set, svg } from "./svg";
import { allowedPlace, allThings, key, moved, type Ref, replaced, same, snapped, thingAt } from "./things";
import { Viewport } from "./viewport";
import { thingInWords } from "./words";

/** Radii of a handle in pixels: the visible one and the touch target. */
const KNOB = 7;
const TOUCH = 20;
/** Goals that are drawn at the object they refer to. */
const BOUND = new Set(["follow", "visit"]);

type Drag =
  | { readonly what: "pan" }
  | {
      readonly what: "thing";
      readonly ref: Ref;
      readonly world: WorldValues;
      readonly from: XY;
      readonly merge: string;
    }
  | {
      readonly what: "handle";
      readonly handle: Handle;
      readonly ref: Ref;
      readonly world: WorldValues;
      readonly merge: string;
    };

export class Plan {
  readonly dom = svg("svg", { class: "plan", role: "group" });
  readonly viewport = new Viewport(this.dom, () => this.drawHandles());
  private readonly floor = svg("g", {});
  private readonly things = svg("g", {});
  private readonly knobs = svg("g", { "aria-hidden": "true" });
  private readonly groups = new Map<string, SVGGElement>();
  private drag: Drag | null = null;
  private drags = 0;
  private readonly endings: (() => void)[];
  private readonly sizes = new ResizeObserver(() => this.viewport.apply());

  /** @param snaps whether positions are rounded to the grid. */
  constructor(
    private readonly draft: Draft,
    private readonly snaps: () => boolean,
  ) {
    this.dom.append(this.floor, this.things, this.knobs);
    this.endings = [
      effect(() => set(this.dom, { "aria-label": t("page-editor-plan") })),
      effect(() => this.draw(this.draft.world.value, this.draft.selected.value)),
    ];
    this.sizes.observe(this.dom);
    this.dom.addEventListener("pointerdown", (event) => this.down(event));
    this.dom.addEventListener("pointermove", (event) => this.move(event));
    this.dom.addEventListener("pointerup", () => (this.drag = null));
    this.dom.addEventListener("pointercancel", () => (this.drag = null));
    this.dom.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    this.dom.addEventListener("focusin", (event) => this.focused(event.target));
  }

  /** Show the whole floor. */
  fit(): void {
    const world = this.draft.world.peek();
    if (world) this.viewport.fit(world.floor.size);
  }

  /** Focus an object. */
  focus(ref: Ref): void {
    this.groups.get(key(ref))?.focus();
  }

  /** Whether an object has the focus. */
  get focusedThing(): boolean {
    return this.things.contains(document.activeElement);
  }

  destroy(): void {
    for (const end of this.endings) end();
    this.sizes.disconnect();
    this.dom.remove();
  }

  private draw(world: WorldValues | null, selected: Ref | null): void {
    if (!world) return;
    this.drawFloor(world);
    const refs = allThings(world);
    this.forget(new Set(refs.map(key)));
    for (const ref of refs) this.drawThing(world, ref, same(ref, selected));
    untracked(() => this.drawHandles());
  }

  private drawFloor({ floor }: WorldValues): void {
    const [width, height] = floor.size;
    const place = { x: -width / 2, y: -height / 2, width, height };
    const border = svg("rect", { ...place, class: floor.border > 0 ? "border" : "edge" });
    const axes = svg("path", { d: "M0 -60 V60 M-60 0 H60", class: "axes" });
    this.floor.replaceChildren(svg("rect", { ...place, fill: css(floor.colour) }), border, axes);
  }

  private forget(known: ReadonlySet<string>): void {
    for (const [name, group] of this.groups) {
      if (known.has(name)) continue;
      group.remove();
      this.groups.delete(name);
    }
  }

  /** Each object keeps its element, so it keeps the focus. */
  private drawThing(world: WorldValues, ref: Ref, selected: boolean): void {
    const group =
      this.groups.get(key(ref)) ?? svg("g", { tabindex: 0, role: "button", class: "thing", "data-thing": key(ref) });
    this.groups.set(key(ref), group);
    set(group, { "aria-label": thingInWords(world, ref), "aria-pressed": String(selected) });
    group.classList.toggle("selected", selected);
    group.replaceChildren(...shapesOf(world, ref));
    this.inOrder(group, ref);
  }

  /** Later sorts are drawn over earlier ones. */
  private inOrder(group: SVGGElement, ref: Ref): void {
    const world = this.draft.world.peek();
    if (group.isConnected || !world) return;
    const order = allThings(world).map(key);
    const next = order.slice(order.indexOf(key(ref)) + 1).find((name) => this.groups.get(name)?.isConnected);
    this.things.insertBefore(group, next ? (this.groups.get(next) ?? null) : null);
  }

  private drawHandles(): void {
    const [world, ref] = [this.draft.world.peek(), this.draft.selected.peek()];
    const thing = world && ref && thingAt(world, ref);
    const handles = ref && thing ? handlesOf(ref.sort, thing) : [];
    this.knobs.replaceChildren(...handles.flatMap((handle, i) => this.knob(handle, i)));
  }

  private knob({ kind, at: [x, y] }: Handle, index: number): SVGElement[] {
    const seen = kind === "insert" ? KNOB * 0.6 : KNOB;
    const circle = (r: number, name: string): SVGElement =>
      svg("circle", { cx: x, cy: -y, r: r * this.viewport.scale, class: name });
    const hit = circle(kind === "insert" ? TOUCH * 0.6 : TOUCH, "hit");
    set(hit, { "data-handle": index });
    return [hit, circle(seen, `knob ${kind}`)];
  }

  private focused(target: EventTarget | null): void {
    const ref = this.refOf(target);
    if (ref && !same(ref, this.draft.selected.peek())) this.draft.select(ref);
  }

  private refOf(target: EventTarget | null): Ref | null {
    const name = target instanceof Element ? target.closest<SVGGElement>("[data-thing]")?.dataset.thing : undefined;
    const world = this.draft.world.peek();
    return (world && allThings(world).find((ref) => key(ref) === name)) ?? null;
  }

  private handleOf(target: EventTarget | null): Handle | null {
    const index = target instanceof SVGElement ? target.dataset.handle : undefined;
    const [world, ref] = [this.draft.world.peek(), this.draft.selected.peek()];
    const thing = world && ref && thingAt(world, ref);
    return index !== undefined && ref && thing ? (handlesOf(ref.sort, thing)[Number(index)] ?? null) : null;
  }

  private down(event: PointerEvent): void {
    const world = this.draft.world.peek();
    if (!world || event.button !== 0) return;
    // Without this the browser would move the focus and scroll.
    event.preventDefault();
    this.dom.setPointerCapture(event.pointerId);
    const [handle, selected] = [this.handleOf(event.target), this.draft.selected.peek()];
    if (handle && selected) this.grab(handle, selected, world, event.detail);
    else this.pick(this.refOf(event.target), world, event);
  }

  private grab(handle: Handle, ref: Ref, world: WorldValues, clicks: number): void {
    if (clicks > 1 && handle.remove) this.draft.change(replaced(world, ref, handle.remove()));
    else this.drag = { what: "handle", handle, ref, world, merge: `drag ${++this.drags}` };
  }

  private pick(ref: Ref | null, world: WorldValues, event: PointerEvent): void {
    this.draft.select(ref);
    if (!ref) this.drag = { what: "pan" };
    else {
      this.focus(ref);
      this.drag = { what: "thing", ref, world, from: this.viewport.at(event), merge: `drag ${++this.drags}` };
    }
  }

  private move(event: PointerEvent): void {
    const { drag } = this;
    if (!drag) return;
    if (drag.what === "pan") this.viewport.pan(event.movementX, event.movementY);
    else if (drag.what === "thing") this.carry(drag, event);
    else this.pull(drag, event);
  }

  private carry({ ref, world, from, merge }: Extract<Drag, { what: "thing" }>, event: PointerEvent): void {
    if (BOUND.has(ref.sort)) return;
    const [x, y] = this.viewport.at(event);
    const [dx, dy] = this.onGrid([x - from[0], y - from[1]], event);
    const thing = moved(world, ref, dx, dy);
    if (thing && (dx || dy || this.draft.world.peek() !== world)) this.draft.change(replaced(world, ref, thing), merge);
  }

  private pull({ handle, ref, world, merge }: Extract<Drag, { what: "handle" }>, event: PointerEvent): void {
    const place = allowedPlace(world, ref.sort, this.viewport.at(event));
    const exact = handle.kind === "turn" ? place : this.onGrid(place, event);
    this.draft.change(replaced(world, ref, handle.pull(exact)), merge);
  }

  /** Alt ignores the grid. */
  private onGrid([x, y]: XY, { altKey }: PointerEvent): XY {
    const free = altKey || !this.snaps();
    return free ? [Math.round(x), Math.round(y)] : [snapped(x), snapped(y)];
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    this.viewport.zoom(Math.exp(event.deltaY * 0.0015), this.viewport.at(event));
  }
}
