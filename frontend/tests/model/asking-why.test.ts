import { expect, test, vi } from "vitest";

import { AskingWhy } from "../../src/model/asking-why";
import { Running } from "../../src/model/running";
import { FakeConnection } from "../fake-connection";

function asking(): [AskingWhy, FakeConnection, ReturnType<typeof vi.fn>] {
  const connection = new FakeConnection();
  const running = new Running(connection.real);
  const show = vi.fn();
  connection.tell({
    kind: "Timeline",
    end: 4,
    marks: [
      { time: 1, sort: "print", text: "a" },
      { time: 2, sort: "print", text: "b" },
      { time: 3, sort: "print", text: "a" },
    ],
  });
  return [new AskingWhy(connection.real, running, show), connection, show];
}

function lookAt(connection: FakeConnection, time: number): void {
  connection.tell({ kind: "Past", time, line: { line: 1, block: null }, variables: {} });
}

const LINE = { question: { ask: "line", subject: "3", time: 1 }, phrase: { code: "x" } };
const NOT_LINE = { question: { ask: "not-line", subject: "3", time: 4 }, phrase: { code: "x" } };

test("the only question about a block is asked at once", () => {
  const [why, connection] = asking();
  why.aboutBlock("b3");
  connection.tell({ kind: "Questions", questions: [LINE], block: "b3" });
  expect(connection.sent.at(-1)).toEqual({ kind: "AskWhy", question: LINE.question });
});

test("of several questions about a block, the user chooses", () => {
  const [why, connection] = asking();
  why.aboutBlock("b3");
  connection.tell({ kind: "Questions", questions: [LINE, NOT_LINE], block: "b3" });
  expect(connection.sent).toEqual([{ kind: "ReadQuestions", block: "b3", time: null }]);
});

test("questions are about the moment that is looked back at", () => {
  const [why, connection, show] = asking();
  lookAt(connection, 1.5);
  why.aboutVariable("n");
  expect(connection.sent.at(-1)).toEqual({ kind: "AskWhy", question: { ask: "value", subject: "n", time: 1.5 } });
  why.aboutRobot();
  expect(connection.sent.at(-2)).toEqual({ kind: "ReadQuestions", time: 1.5 });
  expect(show).toHaveBeenCalledTimes(2);
});

test("of equal texts, the one that was clicked is asked about", () => {
  const [why, connection] = asking();
  why.aboutPrinted("a", 2);
  expect(connection.sent.at(-1)).toEqual({ kind: "AskWhy", question: { ask: "printed", subject: "a", time: 1 } });
});

test("a mark of a goal asks why it was reached, or why not", () => {
  const [why, connection] = asking();
  why.aboutMark({ time: 2, sort: "goal", text: "green: corner: reached" });
  why.aboutMark({ time: 2, sort: "goal", text: "home: failed" });
  expect(connection.sent.map((one) => one.kind === "AskWhy" && one.question)).toEqual([
    { ask: "reached", subject: "green: corner", time: 2 },
    { ask: "goal", subject: "home", time: 2 },
  ]);
});

test("another run is another matter", () => {
  const [why, connection] = asking();
  why.read();
  connection.tell({ kind: "Questions", questions: [LINE] });
  connection.tell({ kind: "RunState", state: "starting" });
  expect([why.questions.value, why.isUsed]).toEqual([null, false]);
});

test.each(["paused", "held"])("the list is read again when the run is %s", (state) => {
  const [why, connection] = asking();
  why.read();
  connection.tell({ kind: "Questions", questions: [LINE, NOT_LINE], block: "" });
  connection.tell({ kind: "RunState", state });
  expect(connection.sent).toEqual([{ kind: "ReadQuestions" }, { kind: "ReadQuestions" }]);
});

test("a pause replaces neither an answer nor the questions about a block", () => {
  const [why, connection] = asking();
  why.aboutBlock("b3");
  connection.tell({ kind: "Questions", questions: [LINE, NOT_LINE], block: "b3" });
  connection.tell({ kind: "RunState", state: "paused" });
  expect(connection.sent).toHaveLength(1);
  why.read();
  connection.tell({ kind: "WhyAnswer", question: LINE, sentences: [], more: [] });
  connection.tell({ kind: "RunState", state: "paused" });
  expect(connection.sent).toHaveLength(2);
});
