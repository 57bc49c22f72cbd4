/** What the user is about to put into the world, and where. */

import { signal } from "@preact/signals";

import { PLACELESS, type Sort } from "../../views/world/plan/sorts";
import type { XY } from "../../views/world/scenery/description";
import type { Offer } from "./offers";

/** Goals without a place of their own are added at once. */
const AT_ONCE: ReadonlySet<Sort> = new Set(["follow", "visit", ...PLACELESS]);

export function hasPlace({ sort }: Offer): boolean {
  return !AT_ONCE.has(sort);
}

export class Putting {
  readonly offer = signal<Offer | null>(null);
  readonly place = signal<XY>([0, 0]);

  begin(offer: Offer, place: XY): void {
    this.place.value = place;
    this.offer.value = offer;
  }

  move(place: XY): void {
    this.place.value = place;
  }

  /** End it; return what is to be put, and where. */
  end(): { readonly offer: Offer; readonly place: XY } | null {
    const offer = this.offer.peek();
    this.offer.value = null;
    return offer && { offer, place: this.place.peek() };
  }
}
