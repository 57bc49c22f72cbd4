// @vitest-environment happy-dom
/** A pupil shows a project to the teacher, or a copy of it to a classmate. */

import { signal } from "@preact/signals";
import { act, fireEvent, screen } from "@testing-library/preact";
import { expect, test, vi } from "vitest";

import { OfferNote } from "../../src/features/in-class/offer-note";
import { ShowClassmateDialog } from "../../src/features/in-class/show-classmate";
import { ShownPrograms } from "../../src/features/in-class/shown-programs";
import { InClass } from "../../src/features/share/in-class";
import { button, open } from "../dialog";

const LINK = "1.project.run";

interface Values {
  readonly role?: "pupil" | "watcher" | null;
  readonly isAllowed?: boolean;
  readonly lesson?: object | null;
  readonly link?: string;
}

function share({ role = "pupil", isAllowed = true, lesson = null, link = LINK }: Values = {}) {
  const show = vi.fn();
  const close = vi.fn();
  const showTeacher = vi.fn();
  open(
    () => <InClass link={link} />,
    () => ({
      classNews: { now: signal(role && { role, title: "7b" }) },
      dialogs: { show, close },
      lessons: { shown: signal(lesson) },
      shownPrograms: { now: signal({ allowed: isAllowed }), showTeacher },
    }),
  );
  return { show, close, showTeacher };
}

const tiles = () => screen.queryAllByRole("button").map(({ textContent }) => textContent);

test("a project is shown on the wall of the class", () => {
  const { close, showTeacher } = share();
  fireEvent.click(button("To my teacher appears on the wall of class 7b"));
  expect([close.mock.calls.length, showTeacher.mock.calls]).toEqual([1, [[]]]);
});

test("a classmate is chosen for the link of the project", () => {
  const { show } = share();
  fireEvent.click(button(/^To a classmate/));
  expect(show.mock.calls).toEqual([[{ showLink: LINK }]]);
});

test.each([
  ["outside a class", { role: null }, 0],
  ["on a teacher's page", { role: "watcher" }, 0],
  ["before the teacher allows it", { isAllowed: false }, 1],
  ["if the teacher allows it", {}, 2],
] as const)("%s, %j leads to %i ways", (_, values, count) => {
  share(values);
  expect(tiles()).toHaveLength(count);
});

test.each([
  ["without a link", { link: "" }, "who can open a copy"],
  ["in a lesson", { lesson: {} }, "not in a lesson"],
])("%s, no classmate can be chosen", (_, values, help) => {
  share(values);
  const tile = button(/^To a classmate/);
  expect([tile.disabled, tile.textContent]).toEqual([true, `To a classmate${help}`]);
});

test("the classmates who are here can be chosen", async () => {
  const close = vi.fn();
  const { connection } = open(
    () => <ShowClassmateDialog of={{ showLink: LINK }} />,
    (connection) => ({ shownPrograms: new ShownPrograms(connection.real), dialogs: { close } }),
  );
  await act(() => connection.tell({ kind: "Classmates" } as never));
  screen.getByText("None of your classmates is here at the moment.");
  await act(() => connection.tell({ kind: "Classmates", pupils: [{ id: "b", name: "Ben" }] } as never));
  fireEvent.click(button("Ben"));
  expect(close).toHaveBeenCalledOnce();
  expect(connection.sent).toEqual([{ kind: "AskViewers" }, { kind: "ShowClassmate", pupil: "b", link: LINK }]);
});

test("what classmates show is offered one after the other", async () => {
  const { connection } = open(OfferNote, (connection) => ({ shownPrograms: new ShownPrograms(connection.real) }));
  const tell = (...offers: object[]) => act(() => connection.tell({ kind: "ProgramOffers", offers } as never));
  expect(tiles()).toEqual([]);
  const [ana, ben] = [
    { pupil: "a", name: "Ana", project: "Square" },
    { pupil: "b", name: "Ben", project: "<b>Star</b>" },
  ];
  await tell(ana, ben);
  screen.getByText("Ana shows you “Square”.");
  fireEvent.click(button("Not now"));
  await tell(ben);
  screen.getByText("Ben shows you “<b>Star</b>”.");
  fireEvent.click(button("Open"));
  await tell();
  expect(tiles()).toEqual([]);
  expect(connection.sent).toEqual([
    { kind: "AnswerOffer", pupil: "a", on: false },
    { kind: "AnswerOffer", pupil: "b", on: true },
  ]);
});
