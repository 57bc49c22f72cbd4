/** What the palette offers, in groups. */

import type { Sort } from "../../views/world/plan/sorts";
import type { CollectableKind, PropKind } from "../../views/world/scenery/description";

/** A sort of object; of decoration and of what is collected, its kind. */
export interface Offer {
  readonly sort: Sort;
  readonly kind?: PropKind | CollectableKind;
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

const COLLECTABLES: readonly CollectableKind[] = [
  "star",
  "coin",
  "gem",
  "heart",
  "cherry",
  "battery",
  "key",
  "flag",
  "bug",
  "ghost",
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
  game: [
    ...COLLECTABLES.map((kind) => ({ sort: "collectable" as const, kind })),
    { sort: "zone" },
    { sort: "gate" },
    { sort: "mover" },
    { sort: "door" },
    { sort: "switch" },
    { sort: "score" },
    { sort: "collect" },
    { sort: "gates" },
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
