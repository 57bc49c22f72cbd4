// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { render, screen } from "@testing-library/preact";
import { expect, test } from "vitest";

import { Puzzle } from "../../src/features/lessons/puzzle";
import { type Page, PageProvider } from "../../src/model/page";
import "../dialog";

test("a moved piece has the focus before anything else can be used", async () => {
  const lessons = { puzzle: signal(null), answerPuzzle: () => {} };
  render(
    <PageProvider value={{ lessons } as unknown as Page}>
      <Puzzle puzzle={{ pieces: ["first", "second"] }} drawings={{}} />
    </PageProvider>,
  );
  // Without the library's own click, which waits for what would come later in a browser.
  screen.getByRole("button", { name: "Add first" }).click();
  await new Promise<void>((resolve) => queueMicrotask(() => queueMicrotask(resolve)));
  expect(document.activeElement?.closest("[data-piece]")?.getAttribute("data-piece")).toBe("0");
});
