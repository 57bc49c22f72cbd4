/** The sort of object that the user is about to put on the plan, and where. */

import { signal } from "@preact/signals";
import type { Sort } from "../../views/world/plan/sorts";
import type { XY } from "../../views/world/scenery/description";

/** Goals without a place of their own are added at once. */
const PLACELESS: ReadonlySet<Sort> = new Set(["follow", "visit", "avoid"]);

export function hasPlace(sort: Sort): boolean {
  return !PLACELESS.has(sort);
}

export class Putting {
  readonly sort = signal<Sort | null>(null);
  readonly place = signal<XY>([0, 0]);

  begin(sort: Sort, place: XY): void {
    this.place.value = place;
    this.sort.value = sort;
  }

  move(place: XY): void {
    this.place.value = place;
  }

  /** End it; return what is to be put, and where. */
  end(): { readonly sort: Sort; readonly place: XY } | null {
    const sort = this.sort.peek();
    this.sort.value = null;
    return sort && { sort, place: this.place.peek() };
  }
}
