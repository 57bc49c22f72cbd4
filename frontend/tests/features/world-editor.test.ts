import { expect, test } from "vitest";
import { bodiesOf, chainOf } from "../../src/features/world-editor/bodies";
import { created, missing, ofKind } from "../../src/features/world-editor/creating";
import { boundsOf, defaultsOf, fieldsOf } from "../../src/features/world-editor/fields";
import { handlesOf } from "../../src/features/world-editor/handles";
import { hull } from "../../src/features/world-editor/hull";
import { GROUPS, wordOf } from "../../src/features/world-editor/offers";
import {
  added,
  duplicated,
  emptied,
  enlarged,
  moved,
  removed,
  replaced,
  snapped,
  turned,
} from "../../src/features/world-editor/things";
import { WorldEdit } from "../../src/features/world-editor/world-edit";
import { allThings, SORTS, type Sort, type Thing, thingAt } from "../../src/views/world/plan/sorts";
import { colourIn, written } from "../../src/views/world/scenery/colours";
import type { Colour, WorldValues, XY } from "../../src/views/world/scenery/description";
import { wrapped } from "../../src/views/world/scenery/geometry";
import { emptyWorld } from "../worlds";

/** A world with all that others name, so that every sort can be made. */
function furnished(): WorldValues {
  const needed = ["line", "tag", "door", "collectable", "gate"] as const;
  return needed.reduce((world, sort) => added(world, sort, created(world, sort, [0, 0]))[0], emptyWorld());
}

test.each([
  ["follow", "line"],
  ["visit", "tag"],
  ["switch", "door"],
  ["collect", "collectable"],
  ["gates", "gate"],
] as const)("a %s needs a %s in the world", (sort, needed) => {
  expect(missing(emptyWorld(), sort)).toBe(needed);
});

test("a world that has all that others name lacks nothing", () => {
  expect(SORTS.filter((sort) => missing(furnished(), sort))).toEqual([]);
});

test.each(SORTS)("adding and removing a %s leaves the world as it was", (sort) => {
  const before = furnished();
  const [after, ref] = added(before, sort, created(before, sort, [10, 20]));
  expect(thingAt(after, ref)).toBeDefined();
  expect(removed(after, ref)).toEqual(before);
});

test.each(SORTS)("a %s that was made fits the schema's defaults", (sort) => {
  const thing = created(furnished(), sort, [0, 0]);
  expect(Object.keys(thing)).toEqual(expect.arrayContaining(Object.keys(defaultsOf(sort))));
});

test("a thing that moves there and back is where it was", () => {
  for (const sort of ["wall", "box", "cylinder", "face", "light", "line"] as const) {
    const [there, ref] = added(emptyWorld(), sort, created(emptyWorld(), sort, [0, 0]));
    const away = replaced(there, ref, moved(there, ref, 120, -80) as Thing);
    expect(moved(away, ref, -120, 80)).toEqual(thingAt(there, ref));
  }
});

test("what moves by itself takes its way along", () => {
  const bug = { ...created(emptyWorld(), "collectable", [0, 0]), path: [[100, 0]] };
  const [there, ref] = added(emptyWorld(), "collectable", bug);
  expect(moved(there, ref, 50, -20)).toMatchObject({ x: 50, y: -20, path: [[150, -20]] });
});

test("a bug takes a life, and a star gives a point", () => {
  const thing = created(emptyWorld(), "collectable", [0, 0]);
  expect(ofKind(thing, "bug")).toMatchObject({ kind: "bug", score: 0, lives: -1 });
  expect(ofKind(thing, "star")).toMatchObject({ kind: "star", score: 1, lives: 0 });
});

test("a thing stays on the floor", () => {
  const [there, ref] = added(emptyWorld(), "box", created(emptyWorld(), "box", [0, 0]));
  expect(moved(there, ref, 9999, 9999)).toMatchObject({ x: 1000, y: 500 });
});

test("four quarter turns leave a thing as it was", () => {
  const wall = { points: [[-200, 0] as const, [200, 0] as const] };
  for (const thing of [{ heading: 30 }, wall] as Thing[]) {
    const after = [90, 90, 90, 90].reduce((one: Thing, degrees) => turned(one, degrees), thing);
    expect(JSON.parse(JSON.stringify(after).replaceAll("-0,", "0,"))).toEqual(thing);
  }
});

/** A world whose variants move a box called "crate". */
function withCrate(): WorldValues {
  const [there, ref] = added(emptyWorld(), "box", { ...created(emptyWorld(), "box", [0, 0]), name: "crate" });
  expect(ref.index).toBe(0);
  return {
    ...there,
    vary: { start: 0, heading: 0, light: 0, noise: 0, slip: 0, thing: [{ name: "crate", distance: 50 }] },
  };
}

test.each(["box", "cylinder", "prop", "tag", "reach", "wall"] as const)(
  "a %s grows, and stays in its bounds",
  (sort) => {
    const thing = created(furnished(), sort, [0, 0]);
    const keys = (grown: Thing) =>
      Object.keys(thing).filter((key) => JSON.stringify(grown[key]) !== JSON.stringify(thing[key]));
    expect(keys(enlarged(sort, thing, 1.25)).length).toBeGreaterThan(0);
    const huge = Array.from({ length: 40 }).reduce((now: Thing) => enlarged(sort, now, 1.25), thing);
    for (const key of keys(huge).filter((name) => name !== "points")) {
      expect(huge[key]).toBe(boundsOf(sort, key)[1]);
    }
  },
);

test.each(SORTS)("a handle of a %s that is pulled to where it is changes nothing", (sort) => {
  const thing = created(furnished(), sort, [100, 50]);
  const pulled = handlesOf(sort, thing).filter(({ kind }) => kind !== "insert");
  // Half a turn to the left is half a turn to the right.
  const facing = (shown: Thing) => ({ ...shown, heading: "heading" in shown ? wrapped(Number(shown.heading)) : null });
  for (const { at, pull } of pulled) expect(facing(pull(at))).toEqual(facing(thing));
});

test("a start has no size", () => {
  const start = created(emptyWorld(), "start", [0, 0]);
  expect(enlarged("start", start, 1.25)).toEqual(start);
});

test("an emptied world has no objects and keeps its floor", () => {
  const after = emptied(furnished());
  expect([allThings(after), after.floor]).toEqual([[], emptyWorld().floor]);
});

test("everything that can be in a world is offered once", () => {
  const offers = Object.values(GROUPS).flat();
  expect(new Set(offers.map(({ sort }) => sort))).toEqual(new Set(SORTS));
  expect(new Set(offers.map(wordOf)).size).toBe(offers.length);
  const kinds = (["prop", "collectable"] as const).flatMap((sort) => {
    const shape = fieldsOf(sort).find(({ key }) => key === "kind")?.shape;
    return shape?.kind === "choice" ? shape.options : [];
  });
  expect(new Set(offers.flatMap(({ kind }) => kind ?? []))).toEqual(new Set(kinds));
});

test.each(SORTS)("a %s can be pointed at in 3D", (sort) => {
  const [world, ref] = added(furnished(), sort, created(furnished(), sort, [100, 50]));
  const chain = chainOf(world, ref);
  const outlines = bodiesOf(world, ref).flatMap(({ outline }) => outline);
  expect(chain.length + outlines.length).toBeGreaterThan(1);
});

test("the hull of points is the corners around them", () => {
  const points: XY[] = [
    [0, 0],
    [4, 0],
    [2, 1],
    [4, 3],
    [0, 3],
    [2, 3],
  ];
  expect(new Set(hull(points).map(String))).toEqual(new Set(["0,0", "4,0", "4,3", "0,3"]));
});

test.each(["white", [1, 2, 255]] as const)("the colour %s is the same after it was a field's value", (colour) => {
  expect(colourIn(written(colour as Colour))).toEqual(colour);
});

test("a renamed thing still moves in the variants of its world", () => {
  const there = withCrate();
  const ref = { sort: "box", index: 0 } as const;
  const after = replaced(there, ref, { ...thingAt(there, ref), name: "chest" });
  expect(after.vary?.thing).toEqual([{ name: "chest", distance: 50 }]);
});

test("a removed thing leaves no bound behind", () => {
  expect(removed(withCrate(), { sort: "box", index: 0 }).vary?.thing).toEqual([]);
});

test("a copy of a named thing has a name of its own", () => {
  const before = furnished();
  const [after] = duplicated(before, { sort: "line", index: 0 });
  expect(new Set(after.line.map(({ name }) => name)).size).toBe(2);
});

test("a copy of a tag has a free number", () => {
  const [after] = duplicated(furnished(), { sort: "tag", index: 0 });
  expect(after.tag.map(({ id }) => id)).toEqual([1, 2]);
});

test("the grid is 10 mm", () => {
  expect([snapped(14), snapped(16), snapped(-4)].map((value) => value + 0)).toEqual([10, 20, 0]);
});

test.each(["world", "floor", "part", ...SORTS] as const)("the schema has fields for a %s", (table) => {
  expect(fieldsOf(table).length).toBeGreaterThan(0);
});

test("bounds come from the schema", () => {
  const [least, most] = boundsOf("part", "radius");
  expect(least).toBeLessThan(most);
});

function drafted(): WorldEdit {
  const draft = new WorldEdit();
  draft.open(emptyWorld());
  return draft;
}

function titled(draft: WorldEdit, title: string, merge = ""): void {
  draft.change({ ...(draft.world.peek() as WorldValues), title }, merge);
}

test("undo and redo pass through every change", () => {
  const draft = drafted();
  for (const title of ["a", "b", "c"]) titled(draft, title);
  const titles: (string | undefined)[] = [];
  for (; draft.canUndo.value; draft.undo()) titles.push(draft.world.value?.title);
  for (; draft.canRedo.value; draft.redo()) titles.push(draft.world.value?.title);
  expect([...titles, draft.world.value?.title]).toEqual(["c", "b", "a", "", "a", "b", "c"]);
});

test("changes of one name are undone together", () => {
  const draft = drafted();
  for (const title of ["a", "ab", "abc"]) titled(draft, title, "typing");
  draft.undo();
  expect(draft.world.value?.title).toBe("");
});

test("a change after an undo ends the way forward", () => {
  const draft = drafted();
  titled(draft, "a");
  draft.undo();
  titled(draft, "b");
  expect(draft.canRedo.value).toBe(false);
});

test("selecting is not a change", () => {
  const draft = drafted();
  draft.select({ sort: "box" as Sort, index: 0 });
  expect(draft.canUndo.value).toBe(false);
});
