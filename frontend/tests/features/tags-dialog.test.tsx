// @vitest-environment happy-dom

import { act, fireEvent, screen, waitFor, within } from "@testing-library/preact";
import { expect, test } from "vitest";

import { TagsDialog } from "../../src/features/tags/dialog";
import { TagDictionary } from "../../src/features/tags/tag-dictionary";
import { button, open as openDialog, pressEscape, speak, write } from "../dialog";

/** The dialog of a page whose server knows these names. */
function open(names: Record<string, number> = {}) {
  return openDialog(TagsDialog, (connection) => {
    const tags = new TagDictionary(connection.real);
    connection.tell({ kind: "Tags", names });
    return { tags };
  });
}

function add(name: string, number: string): void {
  fireEvent.click(screen.getByText("Add a name"));
  write(screen.getAllByLabelText("Name").at(-1)!, name);
  write(screen.getAllByRole("spinbutton").at(-1)!, number);
}

test("a new row starts with its name", () => {
  open();
  fireEvent.click(screen.getByText("Add a name"));
  expect(document.activeElement).toBe(screen.getByLabelText("Name"));
});

test("an invalid entry is reported at its line and not saved", () => {
  const { connection } = open();
  add("12", "7");
  const line = within(screen.getAllByRole("row")[1]!);
  line.getByText("A name needs at least one letter.");
  expect(button("Save").disabled).toBe(true);
  write(line.getByLabelText("Name"), "ball");
  write(line.getByRole("spinbutton"), "587");
  line.getByText(/from 0 to 586/);
  expect(button("Save").disabled).toBe(true);
  write(line.getByRole("spinbutton"), "586");
  fireEvent.click(button("Save"));
  expect(connection.sent).toEqual([{ kind: "SaveTags", names: { ball: 586 } }]);
});

test("names count as saved when the server has them", async () => {
  const { connection } = open();
  add("ball", "7");
  fireEvent.click(button("Save"));
  expect(screen.queryByText("Saved")).toBeNull();
  connection.tell({ kind: "Tags", names: { ball: 7 } });
  await screen.findByText("Saved");
});

test("the refusal of a file is shown until the dialog is closed", async () => {
  const { connection, tags, isOpen } = open();
  void tags.readFile(new File(["ball = 1000"], "tags.toml"));
  await waitFor(() => expect(connection.sent).toEqual([expect.objectContaining({ text: "ball = 1000" })]));
  await connection.refuse("tag-number-range");
  await screen.findByText("tag-number-range");
  isOpen.value = false;
  await waitFor(() => expect(screen.queryByRole("dialog")).toBeNull());
  isOpen.value = true;
  await screen.findByRole("dialog");
  await waitFor(() => expect(screen.queryByText("tag-number-range")).toBeNull());
});

test("names of a file replace those of the same name, unsaved", async () => {
  const { connection } = open({ ball: 1, door: 2 });
  connection.tell({ kind: "TagsRead", names: { ball: 7 } });
  await screen.findByDisplayValue("7");
  expect(screen.getAllByLabelText("Name").map((one) => (one as HTMLInputElement).value)).toEqual(["door", "ball"]);
  expect(button("Save").disabled).toBe(false);
});

test("Escape saves unsaved names, which can be undone", () => {
  const { connection, toasts, isOpen } = open();
  add("goal", "3");
  pressEscape();
  expect(isOpen.value).toBe(false);
  expect(connection.sent).toEqual([{ kind: "SaveTags", names: { goal: 3 } }]);
  toasts.shown.value[0]!.action!.run();
  expect(connection.sent.at(-1)).toEqual({ kind: "SaveTags", names: {} });
});

test("what another page has saved is shown", async () => {
  const { connection } = open();
  connection.tell({ kind: "Tags", names: { ball: 7 } });
  await screen.findByDisplayValue("ball");
});

test("what another page has saved does not replace unsaved edits", async () => {
  const { connection } = open();
  add("door", "1");
  await act(() => connection.tell({ kind: "Tags", names: { ball: 7 } }));
  expect(screen.getAllByLabelText("Name").map((one) => (one as HTMLInputElement).value)).toEqual(["door"]);
});

test("it speaks Spanish", async () => {
  await speak("es");
  open();
  await screen.findByText("Añadir un nombre");
});
