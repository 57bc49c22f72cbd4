// @vitest-environment happy-dom

import { render, screen, within } from "@testing-library/preact";
import { afterEach, expect, test, vi } from "vitest";

import { RecordPage } from "../../src/features/record/page";
import { aimsOf } from "../../src/features/record/record";
import type { PupilRecord } from "../../src/protocol/classroom";
import { button } from "../dialog";

const RECORD: PupilRecord = {
  name: "Mateo",
  title: "7b",
  lessons: [
    {
      name: "1-01",
      title: "First drive",
      done: true,
      aims: [{ say: "Order", reached: true }],
      hand_ins: [{ step: 4, title: "Modify", at: 1, marks: ["7", "7", "9"], note: "Well driven!", improved: 2 }],
    },
    { name: "1-03", title: "A square", step: 4, steps: 5, aims: [{ say: "Loops", standards: ["CSTA 1B-AP-10"] }] },
  ],
};

afterEach(() => vi.unstubAllGlobals());

function answer(body: unknown, status = 200): void {
  vi.stubGlobal("fetch", () => Promise.resolve(new Response(JSON.stringify(body), { status })));
}

test("what is in progress comes before what is reached", () => {
  expect(aimsOf(RECORD).map(({ aim }) => aim.say)).toEqual(["Loops", "Order"]);
});

test("a pupil sees lessons, marks that changed, notes and standards, and nothing to delete", async () => {
  answer(RECORD);
  render(<RecordPage />);
  const first = within((await screen.findByText("First drive")).closest("tr")!);
  first.getByText("7 → 9");
  first.getByText("“Well driven!”");
  screen.getByText("step 4 of 5");
  screen.getByText("CSTA 1B-AP-10");
  button("Print");
  expect(screen.queryByText("Delete…")).toBeNull();
});

test("the teacher can download and delete the record", async () => {
  answer({ ...RECORD, teaches: true });
  render(<RecordPage />);
  await screen.findByText("Delete…");
  screen.getByText("Download the work");
});

test("everybody else reads that only the pupil and the teacher can see it", async () => {
  answer("", 403);
  render(<RecordPage />);
  await screen.findByText(/Only the pupil and the teacher/);
});
