// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { render } from "@testing-library/preact";
import { expect, test } from "vitest";

import { ConnectionBanner } from "../../src/app/banner";
import { type Page, PageProvider } from "../../src/model/page";
import "../dialog";

/** What the banner of a page says. */
function said({ role = "pupil" as string | null, state = "open", silent = false, saved = true } = {}): string {
  const page = {
    classNews: { now: signal(role && { role }), silent: signal(silent) },
    context: { connection: { state: signal(state) }, program: { saved: signal(saved) } },
  } as unknown as Page;
  const { container } = render(
    <PageProvider value={page}>
      <ConnectionBanner />
    </PageProvider>,
  );
  return container.textContent ?? "";
}

test("a pupil learns that the class cannot be reached, even if it merely stops answering, and what is saved", () => {
  expect(said({ silent: true })).toMatch(/class doesn't answer. Everything you have made is saved/);
});

test("what is not saved yet is kept", () => {
  expect(said({ state: "lost", saved: false })).toMatch(/class doesn't answer.*kept on this device/);
});

test("outside a class, and on the teacher's pages, nothing is said of a class", () => {
  for (const role of [null, "helper"]) expect(said({ role, state: "lost" })).not.toMatch(/class/);
});

test("a class that answers is no news", () => {
  expect(said()).toBe("");
});
