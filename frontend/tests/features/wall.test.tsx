// @vitest-environment happy-dom

import { act, fireEvent, render, screen, waitFor, within } from "@testing-library/preact";
import { expect, test, vi } from "vitest";

import { handInAt } from "../../src/features/class-page/hand-in-address";
import { ClassStream } from "../../src/features/class-page/stream";
import { WallPage } from "../../src/features/class-page/wall";
import type { FromTeacher, Wall } from "../../src/protocol/classroom";
import { button } from "../dialog";

/** A stream whose other end is the test. */
class FakeStream extends ClassStream {
  readonly sent: FromTeacher[] = [];

  override open(): void {}

  override send(message: FromTeacher): boolean {
    this.sent.push(message);
    return true;
  }
}

/** The wall of a class with these pupils, in the order in which they joined. */
function open(names: readonly string[], values: Partial<Wall> = {}): FakeStream {
  const stream = new FakeStream("wall");
  const pupils = names.map((_, index) => `p${index}`);
  const wall = {
    kind: "Wall",
    title: "7b",
    word: "koala 47",
    address: "http://a",
    open: true,
    eyes_up: false,
  } as const;
  stream.wall.value = { ...wall, more: 5, pupils, ...values };
  stream.seats.value = new Map(names.map((name, index) => [`p${index}`, { id: `p${index}`, name }]));
  render(<WallPage stream={stream} />);
  return stream;
}

test("several pupils are deleted at once, the last ones to join first", () => {
  const stream = open(["Ana", "Zoe", "Zoë"]);
  fireEvent.click(screen.getByText("Join word"));
  fireEvent.click(screen.getByText("Delete several…"));
  const dialog = within(screen.getByRole("dialog"));
  const boxes = dialog.getAllByRole("checkbox");
  expect(dialog.getAllByRole("listitem").map(({ textContent }) => textContent)).toEqual(["Zoë", "Zoe", "Ana"]);
  expect(button("Delete").disabled).toBe(true);
  fireEvent.click(boxes[0]!);
  fireEvent.click(boxes[1]!);
  fireEvent.click(button("Delete"));
  expect(stream.sent).toEqual([]);
  screen.getByText("Delete Zoë, Zoe?");
  fireEvent.click(button("Delete"));
  expect(stream.sent).toEqual([{ kind: "RemovePupils", pupils: ["p2", "p1"] }]);
});

test("the teacher lets more pupils in, or not", () => {
  const stream = open(["Ana"], { knocking: ["Leo", "Mia"] });
  screen.getByText("1 pupil has joined. Waiting for you: Leo, Mia");
  fireEvent.click(button("Let up to 5 more join"));
  fireEvent.click(button("Don't let them in"));
  expect(stream.sent).toEqual([
    { kind: "AnswerKnocking", on: true },
    { kind: "AnswerKnocking", on: false },
  ]);
});

test("the teacher reads whom a lesson has not reached", () => {
  const stream = open(["Ana", "Leo", "Mia"]);
  expect(screen.queryByText(/did not reach/)).toBeNull();
  const lacking = [...stream.seats.value].map(([id, seat]) => [id, { ...seat, lacks_lesson: id !== "p1" }] as const);
  act(() => {
    stream.seats.value = new Map(lacking);
  });
  screen.getByText(/The lesson did not reach Ana and Mia\. Hand it out/);
});

test("the teacher sees what pupils show, also to each other", async () => {
  const stream = open(["Ana", "Ben"], { shown: [{ pupil: "p1", classmate: "p0", project: "Star" }] });
  const card = within(screen.getByRole("region", { name: "Shown to classmates" }));
  card.getByText("“Star”: Ben to Ana");
  await act(() => {
    stream.seats.value = new Map([["p0", { id: "p0", name: "Ana", project: "Other", shows: "Square" }]]);
  });
  const waiting = within(screen.getByRole("region", { name: "Waiting for you" }));
  waiting.getByText("shows “Square”");
  // The project that is shown, whatever is open.
  expect(waiting.getByText("Look").getAttribute("href")).toBe("p/p0/#project=Square");
});

test("nothing is asked while no pupil waits", () => {
  open(["Ana"]);
  expect(screen.queryByText(/joined. Waiting for you/)).toBeNull();
});

test("a lesson is handed out to some pupils from a step", () => {
  const stream = open(["Ana", "Leo", "Mia"]);
  const steps = ["Predict", "Run it"];
  const lesson = { level: 1, minutes: 30, robots: [], steps };
  stream.offers.value = [{ ...lesson, name: "1-01", title: "First drive" }];
  fireEvent.click(screen.getAllByText("Hand out a lesson")[0]!);
  const dialog = within(screen.getByRole("dialog"));
  fireEvent.change(dialog.getByLabelText("Who gets the lesson"), { target: { value: "some" } });
  expect(button("Hand out").disabled).toBe(true);
  fireEvent.click(dialog.getByLabelText("Leo"));
  fireEvent.change(dialog.getByLabelText("The step to begin with"), { target: { value: "2" } });
  fireEvent.click(button("Hand out"));
  expect(stream.sent).toEqual([{ kind: "HandOut", lesson: "1-01", project: "First drive", pupils: ["p1"], step: 2 }]);
});

test("the next lesson is handed out to all who are ready, with one click", async () => {
  const stream = open(["Ana", "Leo", "Mia"]);
  const lesson = { level: 1, minutes: 30, robots: [], steps: ["Predict", "Run it"] };
  stream.offers.value = [
    { ...lesson, name: "1-01", title: "First drive" },
    { ...lesson, name: "1-02", title: "Turn a corner" },
  ];
  const all = [...stream.seats.value.values()];
  const at = (done: readonly boolean[]) => ({ lesson_name: "1-01", step: 2, begun: true, done: [...done] });
  const seats = all.map((seat, index) => ({ ...seat, ...at([true, index < 2]) }));
  await act(() => {
    stream.seats.value = new Map(seats.map((seat) => [seat.id, seat]));
  });
  fireEvent.click(screen.getByText("Turn a corner, for 2 who are ready"));
  expect(stream.sent).toEqual([{ kind: "HandOut", lesson: "1-02", project: "Turn a corner", pupils: ["p0", "p1"] }]);
  await screen.findByText("Turn a corner is open on the pages of 2 pupils.");
  // Also when it is the lesson of most pupils, and the last one.
  const moved = seats.map((seat, index) => [seat.id, index < 2 ? { ...seat, lesson_name: "1-02" } : seat] as const);
  await act(() => {
    stream.seats.value = new Map(moved);
  });
  screen.getByText("Turn a corner is open on the pages of 2 pupils.");
});

test("after the only lesson of the teacher's own is deleted, also while it is on, others can be chosen", async () => {
  vi.stubGlobal("fetch", async () => Response.json("mine"));
  const stream = open(["Ana"], { lesson: "mine" });
  const lesson = { level: 1, minutes: 30, robots: [], steps: ["Run it"] };
  const shipped = { ...lesson, name: "1-01", title: "First drive" };
  stream.offers.value = [shipped, { ...lesson, name: "mine", title: "My own", own: true }];
  fireEvent.click(await screen.findByText("My own"));
  fireEvent.click(screen.getByText("Delete…"));
  fireEvent.click(button("Delete lesson"));
  await waitFor(() => expect(screen.queryByText("Delete lesson")).toBeNull());
  await act(() => {
    stream.offers.value = [shipped];
  });
  within(screen.getByRole("radiogroup", { name: "Lessons" })).getByText("First drive");
});

test("the picture of a pupil without news from the server is grey", async () => {
  const stream = open(["Ana"]);
  const picture = () => screen.getByText("Ana").closest(".tile")!.querySelector(".small-world")!;
  const seat = { id: "p0", name: "Ana", here: true, begun: true };
  stream.seats.value = new Map([["p0", seat]]);
  await waitFor(() => expect(picture().className).not.toContain("old"));
  stream.seats.value = new Map([["p0", { ...seat, silent: 5 }]]);
  await waitFor(() => expect(picture().className).toContain("old"));
});

test("few pupils get large tiles, which a filter does not change", () => {
  open(["Ana", "Leo", "Mia", "Zoe"]);
  const grid = () => screen.getByRole("grid");
  expect(grid().getAttribute("style")).toBe("--columns: 2; --rows: 2;");
  fireEvent.click(screen.getAllByText("Not begun")[0]!);
  expect(grid().getAttribute("style")).toBe("--columns: 2; --rows: 2;");
});

test("a class of many has as many tiles in a row as there is room for", () => {
  open(Array.from({ length: 13 }, (_, index) => `Ana ${index}`));
  expect(screen.getByRole("grid").getAttribute("style")).toBeNull();
});

test("who has handed in is to be marked, also while asking for help", async () => {
  const stream = open(["Ana"]);
  const seat = { id: "p0", name: "Ana", here: true, begun: true, hand_in: "to mark" } as const;
  stream.seats.value = new Map([["p0", { ...seat, hand: true }]]);
  await waitFor(() => screen.getByText("to mark"));
  stream.seats.value = new Map([["p0", { ...seat, hand_in: "handed back" }]]);
  await waitFor(() => screen.getByText("finished"));
});

test("work that a pupil has left behind stays in the hand-ins with its lesson, and what is not shown is counted", async () => {
  const stream = open(["Ana", "Leo"]);
  const seat = { id: "p0", name: "Ana", lesson_name: "two", step: 1, all_stars: 4 };
  const left = { pupil: "p0", title: "A square", tries: 7 };
  await act(() => {
    stream.seats.value = new Map([...stream.seats.value, ["p0", seat]]);
    stream.waiting.value = {
      kind: "WaitingHandIns",
      hand_ins: [
        { ...left, lesson: "one", step: 4 },
        { ...left, lesson: "two", step: 2 },
      ],
      more: 6,
    };
  });
  const list = within(screen.getByRole("region", { name: "Hand-ins" }));
  const rows = list.getAllByRole("row").map(({ textContent }) => textContent);
  expect(rows.slice(1)).toEqual(["AnaA square, step 4–7to mark", "Anastep 20 of 47to mark"]);
  list.getByText("1 of 2");
  list.getByText("and 6 more");
});

test("a row of the hand-ins opens the hand-in of its pupil", () => {
  const stream = open(["Ana", "Leo"]);
  const [ana, leo] = [...stream.seats.value.values()];
  act(() => {
    stream.seats.value = new Map([
      ["p0", { ...ana!, lesson_name: "1-03", step: 4, hand_in: "to mark" }],
      ["p1", leo!],
    ]);
    const left = { pupil: "p1", lesson: "1-02", title: "Turn", step: 2 };
    stream.waiting.value = { kind: "WaitingHandIns", hand_ins: [left] };
  });
  const links = within(screen.getByRole("region", { name: "Hand-ins" })).getAllByRole("link", { name: /Ana|Leo/ });
  const opened = links.map((link) => handInAt(new URL(link.getAttribute("href")!, "http://a").hash));
  expect(opened).toEqual([
    { pupil: "p0", lesson: "1-03", step: 4 },
    { pupil: "p1", lesson: "1-02", step: 2 },
  ]);
});
