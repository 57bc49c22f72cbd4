/** The plan: the world from above, where objects are dragged, turned and bent. */

import { effect, type ReadonlySignal, untracked } from "@preact/signals";
import { t } from "../../i18n";
import { Cleanup } from "../../ui/cleanup";
import { groundOf } from "../../views/world/plan/ground";
import { shapesOf } from "../../views/world/plan/shapes";
import { allThings, key, type Ref, same, thingAt } from "../../views/world/plan/sorts";
import { set, svg } from "../../views/world/plan/svg";
import type { WorldValues, XY } from "../../views/world/scenery/description";
import { type Handle, handlesOf } from "./handles";
import type { Putting } from "./putting";
import { allowedPlace, GRID, moved, replaced, snapped } from "./things";
import { Viewport } from "./viewport";
import { thingInWords } from "./words";
import type { WorldEdit } from "./world-edit";

/** Radii of a handle in pixels: the visible one, and what a mouse or a finger hits. */
const KNOB = 7;
const HIT = { mouse: 14, finger: 22 } as const;
/** Half the length in pixels of the cross that shows where an object will be. */
const CROSS = 18;
/** mm by which the cross moves with Shift and Alt. */
const COARSE = 100;
const FINE = 1;
const ARROWS: Readonly<Record<string, XY>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
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
  readonly dom = svg("svg", { class: "plan world-plan", role: "group", tabindex: -1 });
  readonly viewport = new Viewport(this.dom, () => this.drawMarks());
  private readonly floor = svg("g", {});
  private readonly things = svg("g", {});
  private readonly knobs = svg("g", { "aria-hidden": "true" });
  private readonly cross = svg("g", { "aria-hidden": "true", class: "cross" });
  private readonly coarse = matchMedia("(pointer: coarse)");
  private readonly groups = new Map<string, SVGGElement>();
  private drag: Drag | null = null;
  private drags = 0;
  private readonly cleanup: Cleanup;
  private readonly sizes = new ResizeObserver(() => this.viewport.resized());

  /**
   * @param snaps whether positions are rounded to the grid.
   * @param putting what is about to be put on the plan.
   * @param put is called to put it at the place of `putting`; returns the new object.
   * @param unreachable why goals can't be reached, by their key.
   */
  constructor(
    private readonly draft: WorldEdit,
    private readonly snaps: () => boolean,
    private readonly putting: Putting,
    private readonly put: () => Ref | null,
    private readonly unreachable: ReadonlySignal<ReadonlyMap<string, string>>,
  ) {
    this.dom.append(this.floor, this.things, this.knobs, this.cross);
    this.cleanup = new Cleanup(
      effect(() => set(this.dom, { "aria-label": t("page-editor-plan") })),
      effect(() => this.draw(this.draft.world.value, this.draft.selected.value)),
      effect(() => this.drawCross()),
    );
    this.sizes.observe(this.dom);
    this.dom.addEventListener("pointerdown", (event) => this.down(event));
    this.dom.addEventListener("pointermove", (event) => this.move(event));
    this.dom.addEventListener("pointerup", () => (this.drag = null));
    this.dom.addEventListener("pointercancel", () => (this.drag = null));
    this.dom.addEventListener("dblclick", (event) => this.removeCorner(event));
    this.dom.addEventListener("keydown", (event) => this.key(event));
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

  /** Let the arrow keys move the cross. */
  focusCross(): void {
    this.dom.focus();
  }

  /** The place of a pointer, on the grid. */
  placeAt(event: PointerEvent): XY {
    return this.onGrid(this.viewport.at(event), event);
  }

  /** Whether a pointer is over the plan. */
  isOver({ clientX, clientY }: PointerEvent): boolean {
    const { left, right, top, bottom } = this.dom.getBoundingClientRect();
    return clientX >= left && clientX <= right && clientY >= top && clientY <= bottom;
  }

  /** Whether an object has the focus. */
  get focusedThing(): boolean {
    return this.things.contains(document.activeElement);
  }

  destroy(): void {
    this.cleanup.dispose();
    this.sizes.disconnect();
    this.dom.remove();
  }

  private draw(world: WorldValues | null, selected: Ref | null): void {
    if (!world) return;
    this.floor.replaceChildren(...groundOf(world), svg("path", { d: "M0 -60 V60 M-60 0 H60", class: "axes" }));
    const refs = allThings(world);
    this.forget(new Set(refs.map(key)));
    for (const ref of refs) this.drawThing(world, ref, same(ref, selected));
    untracked(() => this.drawHandles());
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
    const reason = this.unreachable.value.get(key(ref));
    const words = thingInWords(world, ref);
    set(group, { "aria-label": reason ? `${words}. ${reason}` : words, "aria-pressed": String(selected) });
    group.classList.toggle("unreachable", reason !== undefined);
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

  private drawMarks(): void {
    this.drawHandles();
    untracked(() => this.drawCross());
  }

  /** Where an object will be put: a cross as large as the pointer sees it. */
  private drawCross(): void {
    const [x, y] = this.putting.place.value;
    const puts = this.putting.sort.value !== null;
    this.dom.classList.toggle("puts", puts);
    set(this.dom, { role: puts ? "application" : "group" });
    const arm = CROSS * this.viewport.scale;
    const lines = `M${x - arm} ${-y} H${x + arm} M${x} ${-y - arm} V${-y + arm}`;
    const circle = svg("circle", { cx: x, cy: -y, r: arm * 0.55 });
    this.cross.replaceChildren(...(puts ? [circle, svg("path", { d: lines })] : []));
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
    const hit = circle(this.coarse.matches ? HIT.finger : HIT.mouse, "hit");
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
    if (this.putting.sort.peek()) return this.putAt(event);
    const [handle, selected] = [this.handleOf(event.target), this.draft.selected.peek()];
    if (handle && selected) this.grab(handle, selected, world);
    else this.pick(this.refOf(event.target), world, event);
  }

  /** Put the object where the pointer is; it can be dragged on. */
  private putAt(event: PointerEvent): void {
    this.putting.move(this.placeAt(event));
    const ref = this.put();
    const world = this.draft.world.peek();
    if (ref && world) this.pick(ref, world, event);
  }

  private key(event: KeyboardEvent): void {
    if (event.target !== this.dom || !this.putting.sort.peek()) return;
    const arrow = ARROWS[event.key];
    if (arrow) this.moveCross(arrow, event.shiftKey ? COARSE : event.altKey ? FINE : GRID);
    else if (event.key === "Enter" || event.key === " ") this.focusPut();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private moveCross([east, north]: XY, step: number): void {
    const [x, y] = this.putting.place.peek();
    this.putting.move([x + east * step, y + north * step]);
  }

  private focusPut(): void {
    const ref = this.put();
    if (ref) this.focus(ref);
  }

  private grab(handle: Handle, ref: Ref, world: WorldValues): void {
    this.drag = { what: "handle", handle, ref, world, merge: `drag ${++this.drags}` };
  }

  /** The pointer is captured by the plan, so its target is found by its place. */
  private removeCorner({ clientX, clientY }: MouseEvent): void {
    const handle = this.handleOf(document.elementFromPoint(clientX, clientY));
    const [world, ref] = [this.draft.world.peek(), this.draft.selected.peek()];
    if (handle?.remove && world && ref) this.draft.change(replaced(world, ref, handle.remove()));
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
    if (!drag && this.putting.sort.peek()) this.putting.move(this.placeAt(event));
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
  private onGrid([x, y]: XY, { altKey }: { readonly altKey: boolean }): XY {
    const free = altKey || !this.snaps();
    return free ? [Math.round(x), Math.round(y)] : [snapped(x), snapped(y)];
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    this.viewport.zoom(Math.exp(event.deltaY * 0.0015), this.viewport.at(event));
  }
}
