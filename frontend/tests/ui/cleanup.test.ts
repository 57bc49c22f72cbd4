import { expect, test } from "vitest";

import { Cleanup } from "../../src/ui/cleanup";

test("everything ends once, in the order in which it was added", () => {
  const ended: string[] = [];
  const cleanup = new Cleanup(() => ended.push("first"));
  cleanup.add(
    () => ended.push("second"),
    () => ended.push("third"),
  );
  cleanup.dispose();
  cleanup.dispose();
  expect(ended).toEqual(["first", "second", "third"]);
});
