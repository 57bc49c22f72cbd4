import { beforeEach, expect, test, vi } from "vitest";

import { HandInStream, inOrder } from "../../src/features/hand-ins/stream";
import type { FromTeacher, HandInLine, ToTeacher } from "../../src/protocol/classroom";

const PLACE = { lesson: "1-03-square", step: 4 };

class Played extends HandInStream {
  readonly sent: FromTeacher[] = [];

  override send(message: FromTeacher): boolean {
    this.sent.push(message);
    return true;
  }

  hear(message: ToTeacher): void {
    this.received(message);
  }
}

function line(pupil: string, state: HandInLine["state"]): HandInLine {
  return { pupil, name: pupil, state, at: 1 };
}

function steps(revision: number): ToTeacher {
  const step = { ...PLACE, title: "A square", step_title: "A bigger square" };
  return {
    kind: "HandInSteps",
    revision,
    steps: [
      { ...step, step: 2, count: 9 },
      { ...step, to_mark: 1, count: 1 },
    ],
  };
}

function list(...lines: HandInLine[]): ToTeacher {
  return { kind: "HandInList", ...PLACE, title: "", step_title: "", starts: 4, lines };
}

let stream: Played;

beforeEach(() => {
  vi.stubGlobal("location", { href: "http://localhost/hand-ins" });
  stream = new Played();
});

test("what is to be checked comes first, and what is improved last", () => {
  const lines = [line("a", "improving"), line("b", "marked"), line("c", "to check")];
  expect(inOrder(lines).map(({ pupil }) => pupil)).toEqual(["c", "b", "a"]);
});

test("the step in which something waits for the teacher is listed first", () => {
  stream.hear(steps(1));
  expect(stream.sent).toEqual([{ kind: "ReadHandIns", ...PLACE }]);
});

test("the hand-in of the page's address is shown first", () => {
  stream = new Played({ ...PLACE, step: 2, pupil: "b" });
  stream.hear(steps(1));
  stream.hear({ ...list(line("a", "to mark"), line("b", "to mark")), step: 2 } as ToTeacher);
  expect(stream.sent.at(-1)).toEqual({ kind: "ReadHandIn", pupil: "b", ...PLACE, step: 2 });
});

test("without the hand-in of the page's address, the first one in most need of the teacher is shown", () => {
  stream = new Played({ ...PLACE, step: 5, pupil: "b" });
  stream.hear(steps(1));
  stream.hear(list(line("a", "to mark"), line("b", "to mark")));
  expect(stream.sent.at(-1)).toEqual({ kind: "ReadHandIn", pupil: "a", ...PLACE });
});

test("a hand-in elsewhere has the list read again, and the one that is shown stays", () => {
  stream.hear(steps(1));
  stream.hear(list(line("a", "to mark"), line("b", "to mark")));
  stream.show("b");
  stream.hear(steps(2));
  stream.hear(list(line("a", "to check"), line("b", "to mark")));
  expect(stream.pupil.value).toBe("b");
});

test("the next one is the next of the list, and the last one stays", () => {
  stream.hear(steps(1));
  stream.hear(list(line("a", "to mark"), line("b", "to check")));
  expect(stream.pupil.value).toBe("b");
  stream.move(1);
  expect(stream.pupil.value).toBe("a");
  stream.move(1);
  expect(stream.pupil.value).toBe("a");
});

test("after one that is handed back comes the next without a mark, wherever the list has put it", () => {
  stream.hear(steps(1));
  stream.hear(list(line("a", "handed back"), line("b", "to mark"), line("c", "to check"), line("d", "to mark")));
  stream.show("b");
  // Its mark was kept when the field was left, so it is below the others already.
  stream.hear(list(line("a", "handed back"), line("b", "marked"), line("c", "to check"), line("d", "to mark")));
  for (const next of ["d", "c", "c"]) {
    stream.moveOn();
    const shown = stream.pupil.value;
    expect(shown).toBe(next);
    stream.hear(list(line("a", "handed back"), line("b", "marked"), line("c", "to check"), line("d", "handed back")));
  }
});

test("the list of another step that arrives late is not shown", () => {
  stream.hear(steps(1));
  stream.hear({ kind: "HandInList", lesson: "other", step: 1, title: "", step_title: "", starts: 1 });
  expect(stream.list.value).toBe(null);
});
