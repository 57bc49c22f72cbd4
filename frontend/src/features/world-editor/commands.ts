/** Commands on a draft, for buttons and keys. */

import type { WorldValues, XY } from "../../views/world/scenery/description";
import type { Draft } from "./drafts";
import type { Sort } from "./sorts";
import {
  added,
  allowedPlace,
  allThings,
  created,
  duplicated,
  GRID,
  key,
  moved,
  placeOf,
  type Ref,
  removed,
  replaced,
  snapped,
  thingAt,
  turned,
} from "./things";

/** Degrees by which a button or key turns. */
export const TURN = 15;

/** mm between objects that are added one after another. */
const APART = 120;
const MOST_TRIES = 20;

/** Commands return the object to select next, or null if there was nothing to do. */
export class Commands {
  constructor(private readonly draft: Draft) {}

  add(sort: Sort, [x, y]: XY): Ref | null {
    const world = this.draft.world.peek();
    if (!world) return null;
    const [changed, ref] = added(world, sort, created(world, sort, freePlace(world, sort, [snapped(x), snapped(y)])));
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

/** A position on the floor without the centre of another object. */
function freePlace(world: WorldValues, sort: Sort, wanted: XY): XY {
  const taken = new Set(allThings(world).map((ref) => String(placeOf(world, ref))));
  let place = onFloor(world, sort, wanted);
  for (let tries = 0; taken.has(String(place)) && tries < MOST_TRIES; tries++) {
    place = onFloor(world, sort, [place[0] + APART, place[1] - APART / 2]);
  }
  return place;
}

/** The position, or the middle of the floor if it is outside. */
function onFloor(world: WorldValues, sort: Sort, place: XY): XY {
  const [x, y] = allowedPlace(world, sort, place);
  return Math.abs(x) > world.floor.size[0] / 2 || Math.abs(y) > world.floor.size[1] / 2 ? [0, 0] : [x, y];
}
