import { expect, test } from "vitest";

import type { Moment, Recording } from "../../src/features/standalone/content";
import { RecordedRun } from "../../src/features/standalone/recorded";
import { RecordedWorld } from "../../src/features/standalone/world";
import type { LookBack, Past, Scene, WhyAnswer, WhyQuestion } from "../../src/protocol/messages";

function moment(time: number, event: number, block: string, x: string, drawn = 0): Moment {
  const variables = { kind: "Variables", local: {}, shared: { x } } as const;
  const line = { kind: "RunningLine", line: event, block } as const;
  const telemetry = { kind: "Telemetry", time, robots: [] } as const;
  return { past: { kind: "Past", time, event, line, variables, telemetry: { ...telemetry, robots: [] } }, drawn };
}

const now = (ask: WhyQuestion["ask"], time: number): WhyAnswer => ({
  kind: "WhyAnswer",
  asked: { question: { ask, subject: "", time }, phrase: { code: "" }, block: null },
});
const points: [number, number][] = [
  [0, 0],
  [1, 0],
  [2, 0],
];
const recording: Recording = {
  timeline: { kind: "Timeline", end: 3, marks: [{ time: 2, sort: "print", text: "hello" }] },
  moments: [moment(0, 0, "a", "1"), moment(1, 0, "a", "1", 1), moment(2, 1, "b", "2", 2), moment(3, 2, "a", "2", 3)],
  drawing: { kind: "Drawing", fresh: true, parts: [{ stroke: 0, color: [0, 0, 0], width: 1, points }] },
  questions: { kind: "Questions", questions: [], block: "" },
  answers: [now("now", 0), now("now", 2), now("end", 3)],
};
const robot = (name: string, x: number) => ({ name, x, y: 0, heading: 0 });
const scene = { kind: "Scene", name: "empty", robots: [["ann"], ["ben"]] } as unknown as Scene;
const ben = { name: "ben", cameras: ["FRONT"], start: null };
const world = new RecordedWorld(scene, [
  [0, [robot("ann", 0), robot("ben", 1)]],
  [1, [robot("ann", 2), robot("ben", 3)]],
]);
const run = new RecordedRun(recording, (time) => world.robotsAt(time, ben));
const look = (wanted: Omit<LookBack, "kind">): Past => run.past({ kind: "LookBack", ...wanted });

test("a time shows the last moment until then, and what had been drawn", () => {
  const past = look({ time: 1.5 });
  expect(past).toMatchObject({ time: 1.5, event: 0 });
  expect(past.drawing?.parts?.[0]?.points).toEqual([[0, 0]]);
});

test.each([
  [{ time: 0, step: 1, to: "line" }, 2],
  [{ time: 3, step: -1, to: "change", subject: "x" }, 1],
  [{ time: 0, step: 1, to: "run", subject: "a" }, 3],
  [{ time: 0, step: 1, to: "mark" }, 2],
] as const)("a step %o leads to %d s", (wanted, time) => {
  expect(look(wanted).time).toBe(time);
});

test("without a further step the moment stays", () => {
  expect(look({ time: 3, step: 1, to: "line" })).toMatchObject({ time: 3, found: false });
});

test("what the robot does is answered for the nearest moment, and nothing is made up", () => {
  const ask = (question: WhyQuestion) => run.answer({ kind: "AskWhy", question });
  expect(ask({ ask: "now", subject: "", time: 1.8 })?.asked.question.time).toBe(2);
  expect(ask({ ask: "bump", subject: "", time: 1 })).toBeNull();
});

test("each robot sees itself first, in the world and where the robots were", () => {
  expect(look({ time: 1.5 }).telemetry?.robots).toEqual([robot("ben", 3), robot("ann", 2)]);
  expect(world.sceneOf(ben)).toMatchObject({ name: "empty", cameras: ["FRONT"], robots: [["ben"], ["ann"]] });
});
