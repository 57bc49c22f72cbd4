import { expect, test } from "vitest";
import { boundsOf, defaultsOf, fieldsOf } from "../../src/features/world-editor/fields";
import {
  added,
  created,
  duplicated,
  missing,
  moved,
  removed,
  replaced,
  snapped,
  turned,
} from "../../src/features/world-editor/things";
import { WorldEdit } from "../../src/features/world-editor/world-edit";
import { SORTS, type Sort, type Thing, thingAt } from "../../src/views/world/plan/sorts";
import type { WorldValues } from "../../src/views/world/scenery/description";
import { emptyWorld } from "../worlds";

/** A world with a line and a tag, so that every sort can be made. */
function furnished(): WorldValues {
  const [withLine] = added(emptyWorld(), "line", created(emptyWorld(), "line", [0, 0]));
  return added(withLine, "tag", created(withLine, "tag", [0, 0]))[0];
}

test("goals need the line or tag that they name", () => {
  expect(missing(emptyWorld(), "follow")).toBe("line");
  expect(missing(emptyWorld(), "visit")).toBe("tag");
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
