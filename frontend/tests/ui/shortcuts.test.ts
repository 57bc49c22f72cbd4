import { expect, test } from "vitest";

import { keysFor, matches, SHORTCUTS } from "../../src/ui/shortcuts";

function event(values: Partial<KeyboardEvent>): KeyboardEvent {
  return { ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...values } as KeyboardEvent;
}

test("no two shortcuts have the same keys", () => {
  const keys = SHORTCUTS.map(({ word }) => keysFor(word));
  expect(new Set(keys).size).toBe(SHORTCUTS.length);
});

test("keys are written as a person reads them", () => {
  expect([keysFor("page-bar-stop"), keysFor("page-project-open"), keysFor("page-close")]).toEqual([
    "Ctrl+Shift+Enter",
    "Ctrl+O",
    undefined,
  ]);
});

test("an event matches the shortcut of its keys alone", () => {
  const pressed = event({ key: "Enter", ctrlKey: true });
  expect(SHORTCUTS.filter((one) => matches(one, pressed)).map(({ word }) => word)).toEqual(["page-bar-run"]);
});

test("the command key counts as Ctrl, and Alt as no match", () => {
  const [run] = SHORTCUTS;
  expect(matches(run, event({ key: "Enter", metaKey: true }))).toBe(true);
  expect(matches(run, event({ key: "Enter", ctrlKey: true, altKey: true }))).toBe(false);
});
