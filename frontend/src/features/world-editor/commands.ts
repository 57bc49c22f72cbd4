/** Commands on a draft, for buttons and keys. */

import { key, type Ref, thingAt } from "../../views/world/plan/sorts";
import type { XY } from "../../views/world/scenery/description";
import { created, ofKind } from "./creating";
import type { Offer } from "./offers";
import { added, allowedPlace, duplicated, enlarged, GRID, moved, removed, replaced, turned } from "./things";
import type { WorldEdit } from "./world-edit";

/** The factor by which a button or key enlarges. */
export const LARGER = 1.25;
/** Degrees by which a button or key turns. */
export const TURN = 15;

/** Commands return the object to select next, or null if there was nothing to do. */
export class Commands {
  constructor(private readonly draft: WorldEdit) {}

  /** Add an object at a place, or as near to it as the floor allows. */
  add({ sort, kind }: Offer, place: XY): Ref | null {
    const world = this.draft.world.peek();
    if (!world) return null;
    const thing = created(world, sort, allowedPlace(world, sort, place));
    const [changed, ref] = added(world, sort, ofKind(thing, kind));
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

  enlarge(factor: number): void {
    const { world, ref } = this.selection();
    const thing = world && ref && thingAt(world, ref);
    if (thing) this.draft.change(replaced(world, ref, enlarged(ref.sort, thing, factor)), `enlarge ${key(ref)}`);
  }

  /** Move by grid steps, or by a different distance in mm. */
  nudge(east: number, north: number, step = GRID): void {
    const { world, ref } = this.selection();
    const thing = world && ref && moved(world, ref, east * step, north * step);
    if (thing) this.draft.change(replaced(world, ref, thing), `nudge ${key(ref)}`);
  }

  private selection() {
    return { world: this.draft.world.peek(), ref: this.draft.selected.peek() };
  }
}
