import { expect, test } from "vitest";

import { type Change, changesBetween } from "../../../src/views/text/changes";
import { numbers, text } from "../../random";

function applied(before: string, changes: readonly Change[]): string {
  let after = before;
  for (const { from, to, insert } of changes.toReversed()) after = after.slice(0, from) + insert + after.slice(to);
  return after;
}

test("equal texts have no changes", () => {
  expect(changesBetween("a\nb", "a\nb")).toEqual([]);
});

test("a letter that is typed is one insertion", () => {
  expect(changesBetween("turn 9\nstop", "turn 90\nstop")).toEqual([{ from: 6, to: 6, insert: "0" }]);
});

test("a name that changes on several lines is a change on each", () => {
  const changes = changesBetween("speed = 1\nmove(speed)", "pace = 1\nmove(pace)");
  expect(changes).toHaveLength(2);
});

test("a new line is one insertion", () => {
  const [change, ...others] = changesBetween("one\nthree", "one\ntwo\nthree");
  expect(others).toEqual([]);
  expect(change).toMatchObject({ from: change?.to, insert: expect.stringMatching(/^.{4}$/s) });
});

test("the changes between any two texts make one of the other", () => {
  const random = numbers(1);
  for (let round = 0; round < 500; round++) {
    const [before, after] = [text(random), text(random)];
    expect(applied(before, changesBetween(before, after))).toBe(after);
  }
});

test("changes are sorted and do not overlap", () => {
  const random = numbers(2);
  for (let round = 0; round < 500; round++) {
    const changes = changesBetween(text(random), text(random));
    for (const [at, change] of changes.entries()) {
      expect(change.to).toBeGreaterThanOrEqual(change.from);
      expect(change.from).toBeGreaterThanOrEqual(changes[at - 1]?.to ?? 0);
    }
  }
});
