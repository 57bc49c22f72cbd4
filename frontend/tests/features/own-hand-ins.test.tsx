// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { fireEvent, render, screen } from "@testing-library/preact";
import { expect, test } from "vitest";

import { OwnHandIns } from "../../src/features/start/hand-ins";
import { type Page, PageProvider } from "../../src/model/page";
import type { OwnHandIn } from "../../src/protocol/classroom";
import "../dialog";

const SQUARE = { name: "1-03-square", title: "A square" };

function show(...all: OwnHandIn[]) {
  const started: unknown[][] = [];
  const start = (...how: unknown[]) => started.push(how);
  const lessons = { choices: signal([SQUARE]), start };
  const page = { handIns: { all: signal(all) }, lessons } as unknown as Page;
  render(
    <PageProvider value={page}>
      <OwnHandIns />
    </PageProvider>,
  );
  return started;
}

test("what is back comes first, with note and mark, and opens its step", () => {
  const back = { at: 150, note: "Count the corners.", mark: "8" };
  const started = show(
    { lesson: SQUARE.name, step: 2, at: 200, waits: true },
    { lesson: SQUARE.name, step: 4, at: 100, back },
  );
  const [first, second] = screen.getAllByRole("listitem");
  expect(first!.textContent).toBe("A square · step 4Your work is backCount the corners.8");
  expect(second!.textContent).toBe("A square · step 2Handed in. Your teacher looks at it.");
  fireEvent.click(screen.getAllByRole("button")[0]!);
  expect(started).toEqual([[SQUARE, false, 4]]);
});

test("a note that was replaced by a new hand-in is not shown", () => {
  show({ lesson: SQUARE.name, step: 4, at: 200, waits: true, back: { at: 150, note: "Old", mark: "5" } });
  expect(screen.getByRole("listitem").textContent).not.toMatch(/Old|5/);
});

test("without hand-ins it says what will be there", () => {
  show();
  expect(screen.getByText(/it appears here/)).toBeTruthy();
});
