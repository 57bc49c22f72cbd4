/** What the palette offers, in groups. */

import type { Sort } from "../../views/world/plan/sorts";
import type { PropKind } from "../../views/world/scenery/description";

/** A sort of object; of decoration, its kind. */
export interface Offer {
  readonly sort: Sort;
  readonly kind?: PropKind;
}

const KINDS: readonly PropKind[] = [
  "tree",
  "flowers",
  "house",
  "lamp",
  "cone",
  "ball",
  "block",
  "pile",
  "crate",
  "barrel",
  "post",
  "planet",
  "rocket",
];

/** In the order in which worlds are usually built. */
export const GROUPS: Readonly<Record<string, readonly Offer[]>> = {
  build: [{ sort: "wall" }, { sort: "box" }, { sort: "cylinder" }],
  floor: [{ sort: "line" }, { sort: "start" }],
  look: [{ sort: "tag" }, { sort: "face" }, { sort: "light" }],
  goals: [
    { sort: "reach" },
    { sort: "tour" },
    { sort: "stop" },
    { sort: "follow" },
    { sort: "visit" },
    { sort: "show" },
    { sort: "avoid" },
  ],
  around: KINDS.map((kind) => ({ sort: "prop", kind })),
};

/** The code of an offer's name. */
export function wordOf({ sort, kind }: Offer): string {
  return kind ? `page-world-kind-${kind}` : `page-editor-sort-${sort}`;
}

export function isSameOffer(a: Offer | null, b: Offer | null): boolean {
  return a?.sort === b?.sort && a?.kind === b?.kind;
}
