/** The board: the world in 3D or as a plan, with marks over it by which objects are dragged, turned and bent. */

import { effect, type ReadonlySignal, type Signal, signal, untracked } from "@preact/signals";
import { t } from "../../i18n";
import type { Running } from "../../model/running";
import { Cleanup } from "../../ui/cleanup";
import { allThings, key, type Ref, same, thingAt } from "../../views/world/plan/sorts";
import { set, svg } from "../../views/world/plan/svg";
import type { WorldValues, XY } from "../../views/world/scenery/description";
import { from } from "../../views/world/scenery/geometry";
import { type Handle, handlesOf } from "./handles";
import type { Lens } from "./lens";
import { PlanLens } from "./plan-lens";
import type { Putting } from "./putting";
import { RoomLens } from "./room-lens";
import { allowedPlace, GRID, moved, replaced, snapped } from "./things";
import { thingInWords } from "./words";
import type { WorldEdit } from "./world-edit";

/** Radii of a handle in pixels: the visible one, and what a mouse or a finger hits. */
const KNOB = 7;
const HIT = { mouse: 14, finger: 22 } as const;
/** The ring that shows where an object will be, and half the length of its cross, mm. */
const RING = 60;
const ARM = 90;
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

export class Board {
  readonly dom = document.createElement("div");
  private readonly marks = svg("svg", { class: "plan world-plan", role: "group", tabindex: -1 });
  private readonly plan = new PlanLens(this.marks, () => this.drawMarks());
  private readonly room: RoomLens | null;
  /** What shows the world now; in a browser without 3D that is always the plan. */
  private readonly lens: Signal<Lens>;
  private readonly floor = svg("g", {});
  private readonly things = svg("g", {});
  private readonly knobs = svg("g", { "aria-hidden": "true" });
  private readonly cross = svg("g", { "aria-hidden": "true", class: "cross" });
  private readonly coarse = matchMedia("(pointer: coarse)");
  private readonly groups = new Map<string, SVGGElement>();
  private drag: Drag | null = null;
  private drags = 0;
  private readonly cleanup: Cleanup;
  private readonly sizes = new ResizeObserver(() => this.resized());

  /**
   * @param snaps whether positions are rounded to the grid.
   * @param putting what is about to be put on the plan.
   * @param put is called to put it at the place of `putting`; returns the new object.
   * @param unreachable why goals can't be reached, by their key.
   * @param running has the robots that are in the world.
   */
  constructor(
    private readonly draft: WorldEdit,
    private readonly snaps: () => boolean,
    private readonly putting: Putting,
    private readonly put: () => Ref | null,
    private readonly unreachable: ReadonlySignal<ReadonlyMap<string, string>>,
    running: Running,
  ) {
    this.dom.className = "board";
    this.marks.append(this.floor, this.things, this.knobs, this.cross);
    this.room = roomOf(running, () => untracked(() => this.redraw()));
    this.lens = signal<Lens>(this.room ?? this.plan);
    this.dom.append(...(this.room ? [this.room.picture] : []), this.marks);
    this.cleanup = new Cleanup(
      effect(() => set(this.marks, { "aria-label": t("page-editor-plan") })),
      effect(() => this.changeLens(this.lens.value)),
      effect(() => this.draw(this.draft.world.value, this.draft.selected.value)),
      effect(() => this.drawCross()),
    );
    this.sizes.observe(this.dom);
    this.listen();
  }

  /** Whether the world is shown in 3D, and can be. */
  get isRoom(): boolean {
    return this.lens.value === this.room;
  }

  get hasRoom(): boolean {
    return this.room !== null;
  }

  /** Show the world in 3D, if the browser can, or its plan. */
  look(view: "room" | "plan"): void {
    this.lens.value = (view === "room" && this.room) || this.plan;
    this.fit();
  }

  zoom(factor: number): void {
    this.lens.peek().zoom(factor);
  }

  /** The middle of what is seen. */
  get centre(): XY {
    return this.lens.peek().centre;
  }

  /** Show the whole floor. */
  fit(): void {
    const world = this.draft.world.peek();
    if (world) this.lens.peek().fit(world.floor.size);
  }

  /** Focus an object. */
  focus(ref: Ref): void {
    this.groups.get(key(ref))?.focus();
  }

  /** Let the arrow keys move the cross. */
  focusCross(): void {
    this.marks.focus();
  }

  /** The place of a pointer, on the grid. */
  placeAt(event: PointerEvent): XY {
    return this.onGrid(this.lens.peek().at(event), event);
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
    this.room?.destroy();
    this.dom.remove();
  }

  /** Before the camera's listeners: dragging an object must not turn the world. */
  private listen(): void {
    const options = { capture: true };
    this.dom.addEventListener("pointerdown", (event) => this.down(event), options);
    this.dom.addEventListener("pointermove", (event) => this.move(event), options);
    this.dom.addEventListener("pointerup", () => (this.drag = null), options);
    this.dom.addEventListener("pointercancel", () => (this.drag = null), options);
    this.dom.addEventListener("dblclick", (event) => this.removeCorner(event));
    this.dom.addEventListener("keydown", (event) => this.key(event));
    this.dom.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    this.dom.addEventListener("focusin", (event) => this.focused(event.target));
  }

  private changeLens(lens: Lens): void {
    this.dom.classList.toggle("in-room", lens === this.room);
    untracked(() => this.resized());
  }

  private resized(): void {
    const { clientWidth, clientHeight } = this.dom;
    if (this.isRoom) set(this.marks, { viewBox: `0 0 ${clientWidth} ${clientHeight}` });
    this.lens.peek().resized();
    this.drawMarks();
  }

  /** The camera has moved. */
  private redraw(): void {
    this.draw(this.draft.world.peek(), this.draft.selected.peek());
    this.drawCross();
  }

  private draw(world: WorldValues | null, selected: Ref | null): void {
    if (!world) return;
    const lens = this.lens.value;
    lens.show(world);
    this.floor.replaceChildren(...lens.ground(world));
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
    group.replaceChildren(...this.lens.value.shapes(world, ref));
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

  /** Where an object will be put: a ring on the floor with a cross. */
  private drawCross(): void {
    const [x, y] = this.putting.place.value;
    const puts = this.putting.offer.value !== null;
    this.dom.classList.toggle("puts", puts);
    set(this.marks, { role: puts ? "application" : "group" });
    const chain = (places: readonly XY[]) =>
      `M${places.map((place) => this.lens.value.point(place).join(" ")).join("L")}`;
    const ring = Array.from({ length: 33 }, (_, i): XY => from({ x, y, heading: (360 * i) / 32 }, RING));
    const lines =
      chain([from({ x, y, heading: 0 }, ARM), from({ x, y, heading: 180 }, ARM)]) +
      chain([from({ x, y, heading: 90 }, ARM), from({ x, y, heading: -90 }, ARM)]);
    const shapes = [svg("path", { d: chain(ring), class: "ring" }), svg("path", { d: lines })];
    this.cross.replaceChildren(...(puts ? shapes : []));
  }

  private drawHandles(): void {
    const [world, ref] = [this.draft.world.peek(), this.draft.selected.peek()];
    const thing = world && ref && thingAt(world, ref);
    const handles = ref && thing ? handlesOf(ref.sort, thing) : [];
    this.knobs.replaceChildren(...handles.flatMap((handle, i) => this.knob(handle, i)));
  }

  private knob({ kind, at }: Handle, index: number): SVGElement[] {
    const lens = this.lens.peek();
    const [cx, cy] = lens.point(at);
    const seen = kind === "insert" ? KNOB * 0.6 : KNOB;
    const circle = (r: number, name: string): SVGElement => svg("circle", { cx, cy, r: r * lens.scale, class: name });
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
    const [handle, ref] = [this.handleOf(event.target), this.refOf(event.target)];
    // The camera takes a drag of the floor.
    if (this.isRoom && !handle && !ref && !this.putting.offer.peek()) return this.draft.select(null);
    // Without this the browser would move the focus and scroll.
    event.preventDefault();
    event.stopPropagation();
    this.dom.setPointerCapture(event.pointerId);
    const selected = this.draft.selected.peek();
    if (this.putting.offer.peek()) this.putAt(event);
    else if (handle && selected) this.grab(handle, selected, world);
    else this.pick(ref, world, event);
  }

  /** Put the object where the pointer is; it can be dragged on. */
  private putAt(event: PointerEvent): void {
    this.putting.move(this.placeAt(event));
    const ref = this.put();
    const world = this.draft.world.peek();
    if (ref && world) this.pick(ref, world, event);
  }

  private key(event: KeyboardEvent): void {
    if (event.target !== this.marks || !this.putting.offer.peek()) return;
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
      this.drag = { what: "thing", ref, world, from: this.lens.peek().at(event), merge: `drag ${++this.drags}` };
    }
  }

  private move(event: PointerEvent): void {
    const { drag } = this;
    if (!drag && this.putting.offer.peek()) this.putting.move(this.placeAt(event));
    if (!drag) return;
    if (drag.what === "pan") this.lens.peek().pan(event.movementX, event.movementY);
    else if (drag.what === "thing") this.carry(drag, event);
    else this.pull(drag, event);
  }

  private carry({ ref, world, from, merge }: Extract<Drag, { what: "thing" }>, event: PointerEvent): void {
    if (BOUND.has(ref.sort)) return;
    const [x, y] = this.lens.peek().at(event);
    const [dx, dy] = this.onGrid([x - from[0], y - from[1]], event);
    const thing = moved(world, ref, dx, dy);
    if (thing && (dx || dy || this.draft.world.peek() !== world)) this.draft.change(replaced(world, ref, thing), merge);
  }

  private pull({ handle, ref, world, merge }: Extract<Drag, { what: "handle" }>, event: PointerEvent): void {
    const place = allowedPlace(world, ref.sort, this.lens.peek().at(event));
    const exact = handle.kind === "turn" ? place : this.onGrid(place, event);
    this.draft.change(replaced(world, ref, handle.pull(exact)), merge);
  }

  /** Alt ignores the grid. */
  private onGrid([x, y]: XY, { altKey }: { readonly altKey: boolean }): XY {
    const free = altKey || !this.snaps();
    return free ? [Math.round(x), Math.round(y)] : [snapped(x), snapped(y)];
  }

  /** The camera zooms by itself where no mark is. */
  private wheel(event: WheelEvent): void {
    if (event.target instanceof HTMLCanvasElement) return;
    event.preventDefault();
    const lens = this.lens.peek();
    lens.zoom(Math.exp(event.deltaY * 0.0015), lens.at(event));
  }
}

/** The world in 3D; null in a browser that cannot draw it. */
function roomOf(running: Running, changed: () => void): RoomLens | null {
  try {
    return new RoomLens(running, changed);
  } catch (error) {
    console.warn(error);
    return null;
  }
}
