// @vitest-environment happy-dom

import { act, fireEvent, screen, waitFor } from "@testing-library/preact";
import { expect, test, vi } from "vitest";

import { BlockSets } from "../../src/features/block-sets/block-sets";
import { BlockSetsDialog } from "../../src/features/block-sets/dialog";
import type { LabelledTab } from "../../src/features/block-sets/labels";
import type { BlockSet } from "../../src/protocol/messages";
import { button, open as openDialog, press, pressEscape, speak, write } from "../dialog";

/** The palette, without Blockly. */
const TABS: readonly LabelledTab[] = [
  {
    category: "control",
    title: "Control",
    blocks: ["if", "wait"],
    labels: new Map([
      ["if", "if …"],
      ["wait", "wait …"],
    ]),
  },
  { category: "camera", title: "Camera", blocks: ["see"], labels: new Map([["see", "see …"]]) },
];
vi.mock("../../src/features/block-sets/labels", () => ({ labelledTabs: async () => TABS }));

const EVERYTHING: BlockSet = { name: "everything", title: { en: "Everything", es: "Todo" } };
const FIRST: BlockSet = {
  name: "first",
  title: { en: "First steps", es: "Primeros pasos" },
  show: { blocks: ["wait"] },
};

/** The dialog of a page with LearnBlock's sets and the user's own. */
async function open(...own: readonly BlockSet[]) {
  const opened = openDialog(BlockSetsDialog, (connection) => {
    const blockSets = new BlockSets(connection.real);
    connection.tell({ kind: "BlocksShown", set: EVERYTHING });
    return { blockSets };
  });
  await opened.connection.answer();
  await act(() => opened.connection.tell({ kind: "BlockSets", ours: [EVERYTHING, FIRST], own }));
  await screen.findByRole("searchbox");
  return opened;
}

function box(name: string): HTMLInputElement {
  return screen.getByRole<HTMLInputElement>("checkbox", { name });
}

function click(element: Element) {
  return act(() => void fireEvent.click(element));
}

test("a set of ours is shown, which can be undone", async () => {
  const { connection, toasts, isOpen } = await open();
  await click(screen.getByRole("radio", { name: "First steps" }));
  expect(screen.getAllByRole("status")[0]?.textContent).toBe("1 of 3 blocks shown");
  press("Show these blocks");
  expect(isOpen.value).toBe(false);
  expect(connection.sent.at(-1)).toEqual({ kind: "ChooseBlockSet", set: FIRST });
  toasts.shown.value[0]!.action!.run();
  expect(connection.sent.at(-1)).toEqual({ kind: "ChooseBlockSet", set: EVERYTHING });
});

test("single blocks and whole tabs are ticked, and saved under a name", async () => {
  const { connection } = await open();
  await click(button("Show none"));
  screen.getByText("Tick at least one block.");
  expect(button("Show these blocks").disabled).toBe(true);
  await click(box("Camera"));
  await act(() => write(screen.getByRole("searchbox"), "if"));
  await click(box("if …"));
  await act(() => write(screen.getByRole("searchbox"), ""));
  expect(box("Control").indeterminate).toBe(true);
  await click(box("Also show blocks added later"));
  await click(button("Save as…"));
  await act(() => write(screen.getByLabelText("Name"), "Our lesson"));
  fireEvent.submit(button("Save").form!);
  const set = {
    name: "Our lesson",
    title: { en: "Our lesson" },
    show: { categories: ["camera"], blocks: ["if"] },
  };
  expect(connection.sent.at(-1)).toMatchObject({ kind: "SaveBlockSet", set, replace: false });
});

test("Escape keeps the ticks, and Cancel discards them", async () => {
  const { isOpen } = await open();
  const reopen = async () => {
    await waitFor(() => expect(screen.queryByRole("dialog")).toBeNull());
    await act(() => {
      isOpen.value = true;
    });
    await screen.findByRole("searchbox");
  };
  await click(box("Camera"));
  pressEscape();
  await reopen();
  expect(screen.getAllByRole("status")[0]?.textContent).toContain("changed, not saved");
  expect(box("Camera").checked).toBe(false);
  press("Cancel");
  await reopen();
  expect(box("Camera").checked).toBe(true);
});

test("a deleted set can be restored", async () => {
  const { connection } = await open({ ...FIRST, name: "mine", title: { en: "Mine" } });
  await click(screen.getByRole("radio", { name: "Mine" }));
  press("Delete");
  expect(connection.sent.at(-1)).toEqual({ kind: "DeleteBlockSet", name: "mine" });
  await act(() => connection.answer());
  press("Undo");
  expect(connection.sent.at(-1)).toMatchObject({ kind: "SaveBlockSet", set: { name: "mine" }, replace: false });
});

test("the set of a file is looked at, and not saved", async () => {
  const { connection, blockSets } = await open();
  await act(() => blockSets.readFile(new File(["[show]"], "first.toml")));
  expect(connection.sent.at(-1)).toEqual({ kind: "ReadBlockSet", filename: "first.toml", text: "[show]" });
  await act(() => connection.tell({ kind: "BlockSetRead", set: FIRST }));
  expect(screen.getAllByRole("status")[0]?.textContent).toBe("1 of 3 blocks shown");
});

test("an invalid file is reported in the dialog", async () => {
  const { connection, blockSets } = await open();
  await act(() => blockSets.readFile(new File(["[show]\nblock = []"], "first.toml")));
  await act(() => connection.refuse("set-unknown-key"));
  expect(screen.getByRole("alert").textContent).toBe("set-unknown-key");
});

test("names that are not installed here stay ticked until they are removed", async () => {
  const { blockSets } = await open({ name: "school", show: { blocks: ["wait", "of_our_school"] } });
  await click(screen.getByRole("radio", { name: "school" }));
  expect(box("of_our_school").checked).toBe(true);
  await click(box("of_our_school"));
  expect(blockSets.ticked.value?.ticks.absent.blocks).toEqual([]);
});

test("in Spanish the sets have Spanish names", async () => {
  await speak("es");
  await open();
  await click(await screen.findByRole("radio", { name: "Primeros pasos" }));
  expect(button("Mostrar estos bloques").disabled).toBe(false);
});
