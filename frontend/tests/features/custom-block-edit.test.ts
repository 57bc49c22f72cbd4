import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { CustomBlockEdit } from "../../src/features/custom-blocks/custom-block-edit";
import { FakeConnection } from "../fake-connection";

const SOURCE = "def hop(robot):\n";
const MISTAKE = { message: { code: "custom-block-syntax" }, line: 2 };

beforeEach(() => {
  // The next check waits: it is no part of these tests.
  vi.useFakeTimers();
  vi.stubGlobal("window", globalThis);
  const kept = new Map<string, string>();
  vi.stubGlobal("sessionStorage", {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => kept.set(key, value),
  });
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

/** A new block with a name, whose first check the server has answered. */
async function begin() {
  const connection = new FakeConnection();
  const draft = new CustomBlockEdit(connection.real);
  draft.create(SOURCE);
  await connection.answer({ kind: "CustomBlockChecked", problems: [] });
  draft.change({ name: "hop" });
  draft.save();
  expect(connection.sent.at(-1)).toMatchObject({ kind: "SaveCustomBlock", name: "hop", source: SOURCE });
  return { connection, draft };
}

test("a block with mistakes is not saved, and its mistakes are listed", async () => {
  const { connection, draft } = await begin();
  await connection.answer({ kind: "CustomBlockChecked", problems: [MISTAKE] });
  expect(draft.outcome.value).toEqual({ refused: "" });
  expect(draft.problems.value).toEqual([MISTAKE]);
  expect(draft.saved.value).toBe("");
  draft.destroy();
});

test("a block is not saved before its own request is answered", async () => {
  const { connection, draft } = await begin();
  connection.tell({ kind: "CustomBlockSaved", name: "of another page" });
  expect(draft.outcome.value).toBeNull();
  await connection.answer();
  expect(draft.outcome.value).toEqual({ saved: "hop" });
  draft.destroy();
});

test("the reason of a refusal is shown until the block is changed", async () => {
  const { connection, draft } = await begin();
  await connection.refuse("file-disk-full");
  expect(draft.outcome.value).toEqual({ refused: { code: "file-disk-full" } });
  draft.change({ name: "jump" });
  expect(draft.outcome.value).toBeNull();
  draft.destroy();
});
