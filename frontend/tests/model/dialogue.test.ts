import { expect, test } from "vitest";

import { Dialogue } from "../../src/model/dialogue";
import { FakeConnection } from "../fake-connection";

function dialogue(): [Dialogue, FakeConnection] {
  const connection = new FakeConnection();
  return [new Dialogue(connection.real), connection];
}

test("the last line that was printed is kept, and empty lines are left out", () => {
  const [told, connection] = dialogue();
  connection.tell({ kind: "Printed", text: "one\ntwo\n" });
  connection.tell({ kind: "Printed", text: "\n" });
  expect(told.said.value).toBe("two");
  told.reset();
  expect(told.said.value).toBe("");
});

test("an answer is sent once, and the question is gone", () => {
  const [told, connection] = dialogue();
  connection.tell({ kind: "InputWanted", prompt: "Name?" });
  told.answer("Ada");
  told.answer("Ada");
  expect(connection.sent.filter(({ kind }) => kind === "Answer")).toEqual([{ kind: "Answer", text: "Ada" }]);
  expect(told.asked.value).toBeNull();
  expect(told.answered.value).toEqual({ prompt: "Name?", text: "Ada" });
});

test("a question ends with its program", () => {
  const [told, connection] = dialogue();
  connection.tell({ kind: "InputWanted", prompt: "Name?" });
  connection.tell({ kind: "Ended", ended: "stopped" });
  expect(told.asked.value).toBeNull();
});
