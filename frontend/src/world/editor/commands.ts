/** What one can do to a draft, by button or by key. */

import type { XY } from "../description";
import type { Draft } from "./drafts";
import { added, created, duplicated, GRID, key, moved, type Ref, removed, replaced, snapped, type Sort, thingAt, turned } from "./things";

/** Degrees by which a button or key turns. */
export const TURN = 15;

/** Commands return the thing to go on with, or null when there was nothing to do. */
export class Commands {
  constructor(private readonly draft: Draft) {}

  add(sort: Sort, [x, y]: XY): Ref | null {
    const world = this.draft.world.peek();
    if (!world) return null;
    const [east, north] = world.floor.size;
    const inside = ([snapped(x), snapped(y)] as const).map((value, i) => (Math.abs(value) <= (i ? north : east) / 2 ? value : 0));
    const [changed, ref] = added(world, sort, created(world, sort, inside as XY));
    this.draft.change(changed, "", ref);
    return ref;
  }

  duplicate(): Ref | null {
    const { world, ref } = this.selection();
    if (!world || !ref) return null;
    const [changed, copy] = duplicated(world, ref);
    this.draft.change(changed, "", copy);
    return copy;
  }

  remove(): void {
    const { world, ref } = this.selection();
    if (world && ref) this.draft.change(removed(world, ref), "", null);
  }

  turn(degrees: number): void {
    const { world, ref } = this.selection();
    const thing = world && ref && thingAt(world, ref);
    if (thing) this.draft.change(replaced(world, ref, turned(thing, degrees)), `turn ${key(ref)}`);
  }

  /** Move by steps of the grid, or of another length in mm. */
  nudge(east: number, north: number, step = GRID): void {
    const { world, ref } = this.selection();
    const thing = world && ref && moved(world, ref, east * step, north * step);
    if (thing) this.draft.change(replaced(world, ref, thing), `nudge ${key(ref)}`);
  }

  private selection() {
    return { world: this.draft.world.peek(), ref: this.draft.selected.peek() };
  }
}
