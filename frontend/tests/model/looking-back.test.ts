import { expect, test } from "vitest";

import { LookingBack } from "../../src/model/looking-back";
import { Running } from "../../src/model/running";
import type { Past } from "../../src/protocol/messages";
import { FakeConnection } from "../fake-connection";

function lookingBack(): [LookingBack, Running, FakeConnection] {
  const connection = new FakeConnection();
  const running = new Running(connection.real);
  return [new LookingBack(running, connection.real), running, connection];
}

function past(time: number): Past {
  return {
    kind: "Past",
    time,
    event: 3,
    line: { kind: "RunningLine", line: 3, block: "b3" },
    variables: { kind: "Variables", local: {}, shared: { x: `${time}` } },
  };
}

test("while one moment is awaited, only the last of the others is asked for", () => {
  const [looking, , connection] = lookingBack();
  for (const time of [1, 2, 3]) looking.look(time);
  expect(connection.sent).toEqual([{ kind: "LookBack", time: 1 }]);
  connection.tell({ ...past(1) });
  expect(connection.sent.at(-1)).toEqual({ kind: "LookBack", time: 3 });
  connection.tell({ ...past(3) });
  expect(connection.sent).toHaveLength(2);
});

test("the line of an event is the next one behind what happened before it", () => {
  const [looking, , connection] = lookingBack();
  looking.look(3, 7);
  expect(connection.sent).toEqual([{ kind: "LookBack", time: 3, event: 6, step: 1, to: "line" }]);
});

test("steps pressed quickly are all made, each from where the one before arrived", () => {
  const [looking, , connection] = lookingBack();
  looking.look(3);
  looking.step(-1);
  looking.step(-1);
  connection.tell({ ...past(3), event: 9 });
  connection.tell({ ...past(3), event: 7 });
  const step = { kind: "LookBack", time: 3, step: -1, to: "line", subject: "" };
  expect(connection.sent.slice(1)).toEqual([
    { ...step, event: 9 },
    { ...step, event: 7 },
  ]);
});

test("the steps of a held key do not go on for long", () => {
  const [looking, , connection] = lookingBack();
  for (let press = 0; press < 100; press++) looking.step(1);
  for (let answer = 0; answer < 100; answer++) connection.tell({ ...past(answer) });
  expect(connection.sent).toHaveLength(9);
});

test("steps that wait are forgotten when the user goes back to now", () => {
  const [looking, running, connection] = lookingBack();
  connection.tell({ ...past(3) });
  for (const by of [-1, -1, -1] as const) looking.step(by);
  running.leavePast();
  connection.tell({ ...past(2) });
  expect(connection.sent).toHaveLength(1);
});

test("what arrives meanwhile is shown once the user comes back", () => {
  const [, running, connection] = lookingBack();
  connection.tell({ ...past(1) });
  connection.tell({ kind: "Variables", local: {}, shared: { x: "9" } });
  expect(running.variables.value?.shared).toEqual({ x: "1" });
  expect(running.block.value).toBe("b3");
  running.leavePast();
  expect(running.variables.value?.shared).toEqual({ x: "9" });
  expect(running.block.value).toBeNull();
});

test("steps and jumps start at the event that is shown", () => {
  const [looking, , connection] = lookingBack();
  connection.tell({ kind: "Timeline", end: 5 });
  looking.toMark(-1);
  connection.tell({ ...past(4), event: 7 });
  looking.stepTo.value = "turn";
  looking.step(1);
  connection.tell({ ...past(5), event: 9 });
  looking.toChange(-1, "x");
  connection.tell({ ...past(3), event: 5 });
  looking.toRun(1, "b3");
  expect(connection.sent).toEqual([
    { kind: "LookBack", time: 5, event: null, step: -1, to: "mark", subject: "" },
    { kind: "LookBack", time: 4, event: 7, step: 1, to: "turn", subject: "" },
    { kind: "LookBack", time: 5, event: 9, step: -1, to: "change", subject: "x" },
    { kind: "LookBack", time: 3, event: 5, step: 1, to: "run", subject: "b3" },
  ]);
});

test("a run that rests is asked for its timeline, and a paused one for its values", () => {
  const [, , connection] = lookingBack();
  connection.tell({ kind: "RunState", state: "running" });
  expect(connection.sent).toEqual([]);
  connection.tell({ kind: "RunState", state: "held" });
  expect(connection.sent).toEqual([{ kind: "ReadTimeline" }, { kind: "ReadValues" }]);
  connection.tell({ kind: "RunState", state: "ended" });
  expect(connection.sent.at(-1)).toEqual({ kind: "ReadTimeline" });
});

test("a new run leaves the past", () => {
  const [, running, connection] = lookingBack();
  connection.tell({ ...past(1) });
  connection.tell({ kind: "RunState", state: "starting" });
  expect([running.past.value, running.timeline.value]).toEqual([null, null]);
});

test("who goes back to now stays there when a moment that was asked for comes late", () => {
  const [looking, running, connection] = lookingBack();
  looking.look(1);
  connection.tell({ ...past(1) });
  looking.look(2);
  looking.look(3);
  looking.leave();
  connection.tell({ ...past(2) });
  expect(running.past.value).toBe(null);
  expect(connection.sent).toHaveLength(2);
  looking.look(1);
  connection.tell({ ...past(1) });
  expect(running.past.value?.time).toBe(1);
});
