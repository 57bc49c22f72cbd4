import { Box3, Vector3 } from "three";
import { expect, it } from "vitest";
import { PROP_SIZES } from "../../../src/protocol/world";
import type { PropKind } from "../../../src/views/world/scenery/description";
import { NAMED } from "../../../src/views/world/scenery/props";
import { Parts } from "../../../src/views/world/scenery/solids";

/** These are wider above, where no robot bumps into them. */
const WIDER_ABOVE: readonly PropKind[] = ["lamp", "planet", "post", "tree"];
const KINDS = Object.keys(NAMED) as PropKind[];

it.each(KINDS.filter((kind) => !WIDER_ABOVE.includes(kind)))("a %s is drawn as wide as its body", (kind) => {
  const parts = new Parts();
  NAMED[kind](parts, 0, 0, 0, 1);
  const drawn = new Box3().setFromObject(parts.mesh()).getSize(new Vector3());
  const size = PROP_SIZES[kind];
  const [length, width] = typeof size === "number" ? [2 * size, 2 * size] : size;
  // A round prop has as many sides as a good picture needs, and flowers are no circle.
  const round = typeof size === "number" ? 5 : 1;
  expect(Math.abs(drawn.x - length)).toBeLessThan(round);
  expect(Math.abs(drawn.y - width)).toBeLessThan(round);
});
