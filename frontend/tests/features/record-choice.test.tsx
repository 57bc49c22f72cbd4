// @vitest-environment happy-dom

import { cleanup, fireEvent, render, screen } from "@testing-library/preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { choiceIn, inTerm, termInWords } from "../../src/features/record/choice";
import { RecordPage } from "../../src/features/record/page";
import type { PupilRecord } from "../../src/protocol/classroom";
import { button, speak } from "../dialog";

function at(year: number, month: number, day: number, hour = 0): number {
  return new Date(year, month - 1, day, hour).getTime() / 1000;
}

const RECORD: PupilRecord = {
  name: "Mateo",
  title: "7b",
  lessons: [
    {
      name: "1-01",
      title: "First drive",
      at: at(2026, 8, 31, 23),
      stars: 5,
      hints: 4,
      aims: [{ say: "Order", standards: ["CSTA 1A-AP-10", "England KS2 computing"] }],
    },
    {
      name: "1-03",
      title: "A square",
      at: at(2026, 12, 5),
      stars: 2,
      hand_ins: [
        { step: 2, title: "Run it", at: at(2026, 9, 30, 23), marks: ["9"] },
        { step: 4, title: "Bigger", at: at(2026, 12, 5), marks: ["6"] },
      ],
    },
  ],
};
const ALWAYS = { from: "", to: "", standards: "" };

function names(record: PupilRecord): string[] {
  return (record.lessons ?? []).map(({ name }) => name);
}

beforeEach(() => {
  history.replaceState(null, "", "/p/a/record");
  vi.stubGlobal("fetch", () => Promise.resolve(new Response(JSON.stringify(RECORD))));
});

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

test("without dates everything is counted", () => {
  const all = inTerm(RECORD, ALWAYS);
  expect(names(all)).toEqual(["1-01", "1-03"]);
  expect(all.lessons?.[1]?.hand_ins).toHaveLength(2);
});

test("both days of a term belong to it, and only what was handed in then", () => {
  const september = inTerm(RECORD, { ...ALWAYS, from: "2026-09-01", to: "2026-09-30" });
  expect(names(september)).toEqual(["1-03"]);
  expect(september.lessons?.[0]?.hand_ins?.map(({ marks }) => marks)).toEqual([["9"]]);
  expect(names(inTerm(RECORD, { ...ALWAYS, to: "2026-08-31" }))).toEqual(["1-01"]);
});

test.each(["?from=2026-06-31&to=<b>", "?from=1e9&to=2026-1-1", "?from=&to=2026-13-01", "?%00"])(
  "an address that names no day limits nothing: %s",
  (search) => expect(choiceIn(search)).toEqual(ALWAYS),
);

test("a term without an end is said so", async () => {
  await speak("en");
  expect(termInWords({ ...ALWAYS, from: "2026-09-01" })).toBe("Sep 1, 2026 – …");
  expect(termInWords(ALWAYS)).toBe("");
});

test("a term that is chosen counts at once, stays in the address, and can be taken back", async () => {
  render(<RecordPage />);
  await screen.findByText("First drive");
  fireEvent.change(screen.getByLabelText("From"), { target: { value: "2026-12-01" } });
  expect(screen.queryByText("First drive")).toBeNull();
  screen.getByText("of 1 started");
  expect(location.search).toBe("?from=2026-12-01");
  expect(document.querySelector("footer")!.textContent).toContain("Dec 1, 2026 – …");
  fireEvent.click(button("All dates"));
  screen.getByText("First drive");
  expect(location.search).toBe("");
});

test("only the references of the chosen table are shown, and all aims", async () => {
  history.replaceState(null, "", "/p/a/record?standards=England");
  render(<RecordPage />);
  await screen.findByText("Order");
  screen.getByText("England KS2 computing");
  expect(screen.queryByText("CSTA 1A-AP-10")).toBeNull();
  fireEvent.change(screen.getByLabelText("Standards"), { target: { value: "" } });
  screen.getByText("CSTA 1A-AP-10");
});

test("each lesson has a bar of its hints, in proportion to the most", async () => {
  render(<RecordPage />);
  await screen.findByText("First drive");
  const bars = [...document.querySelectorAll<HTMLElement>(".record-bars i")];
  expect(bars.map((bar) => bar.style.getPropertyValue("--share"))).toEqual(["1", "0"]);
  expect(bars.map((bar) => bar.className)).toEqual(["", "none"]);
});
