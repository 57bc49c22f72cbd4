import { expect, test } from "vitest";

import { Trail } from "../../../src/views/world/trail";

const CORNERS = 6;

test("a piece of the trail is as wide after a sharp bend as before", () => {
  const trail = new Trail();
  for (const [x, y] of [
    [0, 0],
    [100, 0],
    [100, 100],
  ] as const)
    trail.extend(x, y);
  const places = trail.mesh.geometry.getAttribute("position");
  const corner = (piece: number, at: number) => [places.getX(piece * CORNERS + at), places.getY(piece * CORNERS + at)];
  expect([corner(0, 0), corner(0, 5)]).toEqual([
    [-5, -5],
    [-5, 5],
  ]);
  expect([corner(1, 0), corner(1, 1), corner(1, 2), corner(1, 5)]).toEqual([
    [105, -5],
    [105, 100],
    [95, 100],
    [95, -5],
  ]);
});
