// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { render, screen } from "@testing-library/preact";
import { beforeEach, expect, test } from "vitest";

import { TourOffer } from "../../src/features/tour/offer";
import { type Page, PageProvider } from "../../src/model/page";
import { prefer } from "../../src/model/preferences";
import "../dialog";

beforeEach(() => prefer({ tourDone: false }));

/** Show the offer beside a program with so many blocks, in a lesson or not. */
function show({ blocks = 1, lesson = null as object | null, inClass = null as object | null } = {}) {
  const places = Array.from({ length: blocks }, (_, index) => [`block ${index}`, index]);
  const page = {
    classNews: { now: signal(inClass) },
    dialogs: { tour: signal(false) },
    lessons: { shown: signal(lesson) },
    context: { program: { state: signal({ places }) } },
  } as unknown as Page;
  render(
    <PageProvider value={page}>
      <TourOffer />
    </PageProvider>,
  );
  return screen.queryByRole("region") !== null;
}

test("a newcomer with a short program is offered the tour", () => {
  expect(show()).toBe(true);
});

test("the offer covers no lesson and no long program, and is not made in a class", () => {
  expect(show({ lesson: { name: "1-03-square" } })).toBe(false);
  expect(show({ blocks: 12 })).toBe(false);
  expect(show({ inClass: { role: "pupil" } })).toBe(false);
});
