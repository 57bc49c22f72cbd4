// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { fireEvent, render, screen } from "@testing-library/preact";
import { expect, test } from "vitest";

import { Presses } from "../../src/features/lesson-editor/presses";
import { type KeyPressContent, NEW_STEP } from "../../src/features/lessons/lesson-edit";
import { type Page, PageProvider } from "../../src/model/page";
import "../dialog";

/** The form of a step's keys; the values that it gives are shown again. */
function form(first: readonly KeyPressContent[] = []) {
  const keys = signal<readonly KeyPressContent[] | undefined>(first);
  const editStep = (_index: number, change: { keys?: readonly KeyPressContent[] }) => (keys.value = change.keys);
  const page = { lessonMaking: { editStep } } as unknown as Page;
  const Shown = () => <Presses step={{ ...NEW_STEP, ...(keys.value && { keys: keys.value }) }} index={0} />;
  render(
    <PageProvider value={page}>
      <Shown />
    </PageProvider>,
  );
  return keys;
}

test("a press is added, and the next one follows a second after the last", async () => {
  const keys = form();
  screen.getByRole("button", { name: "Add a press" }).click();
  expect(keys.value).toEqual([{ key: "up", at: 1 }]);
  fireEvent.change(await screen.findByLabelText("Key"), { target: { value: "right" } });
  expect(keys.value).toEqual([{ key: "right", at: 1 }]);
  fireEvent.input(screen.getByLabelText("How many times"), { target: { value: "3" } });
  await expect.poll(() => keys.value).toEqual([{ key: "right", at: 1, times: 3 }]);
  screen.getByRole("button", { name: "Add a press" }).click();
  expect(keys.value?.at(-1)).toEqual({ key: "right", at: 4 });
});

test("what a file leaves out is shown as it is meant", () => {
  form([{ key: "space", at: 2 }]);
  const shown = ["First at (seconds)", "Held for (seconds)", "How many times", "Seconds from one to the next"];
  expect(shown.map((label) => (screen.getByLabelText(label) as HTMLInputElement).value)).toEqual([
    "2",
    "0.2",
    "1",
    "1",
  ]);
  expect((screen.getByLabelText("Key") as HTMLSelectElement).value).toBe("space");
});

test("without its last press, a step has no keys", () => {
  const keys = form([{ key: "up", at: 1 }]);
  screen.getByRole("button", { name: "Delete: Press 1" }).click();
  expect(keys.value).toBeUndefined();
});
