import { expect, test } from "vitest";

import { beginAnew } from "../../src/model/beginning-anew";
import { Running } from "../../src/model/running";
import { FakeConnection } from "../fake-connection";

function running(): [Running, FakeConnection] {
  const connection = new FakeConnection();
  const run = new Running(connection.real);
  beginAnew(connection.real, { connected: [], reset: [run] });
  return [run, connection];
}

test.each([
  ["idle", false],
  ["starting", true],
  ["running", true],
  ["paused", true],
  ["held", true],
  ["ended", false],
])("a run that is %s is active: %s", (state, active) => {
  const [run, connection] = running();
  connection.tell({ kind: "RunState", state });
  expect(run.active.value).toBe(active);
});

test.each([
  ["running", false],
  ["paused", true],
  ["held", true],
  ["input", false],
  ["ended", false],
])("a run that is %s waits for the user of the debugger: %s", (state, waits) => {
  const [run, connection] = running();
  connection.tell({ kind: "RunState", state });
  expect(run.waits.value).toBe(waits);
});

test("the place of a missed goal is marked until the next run begins", () => {
  const [run, connection] = running();
  const words = { code: "miss-near", values: { gap: { code: "miss-gap-short", values: { mm: 80 } } } };
  connection.tell({ kind: "Timeline", end: 3, missed: { words, place: [200, 0], nearest: [120, 0] } });
  // Without the words of a language, a message is its code.
  expect(run.missed.value).toEqual([{ place: [200, 0], nearest: [120, 0], words: "miss-gap-short" }]);
  connection.tell({ kind: "RunState", state: "starting" });
  expect(run.missed.value).toEqual([]);
});

test("no block runs once the run has ended", () => {
  const [run, connection] = running();
  connection.tell({ kind: "RunState", state: "paused", block: "b1" });
  expect(run.block.value).toBe("b1");
  connection.tell({ kind: "RunState", state: "ended", block: "b1" });
  expect(run.block.value).toBeNull();
});

test("a start clears the variables and the end of the run before", () => {
  const [run, connection] = running();
  connection.tell({ kind: "Ended", ended: "finished" });
  connection.tell({ kind: "Variables" });
  connection.tell({ kind: "RunState", state: "starting" });
  expect([run.ended.value, run.variables.value]).toEqual([null, null]);
});

test("a custom block that was tried does not count as a run", () => {
  const [run, connection] = running();
  connection.tell({ kind: "Ended", ended: "finished", tried: true });
  expect(run.ended.value).toBeNull();
});

test("toggling a breakpoint twice leaves none and tells the server each time", () => {
  const [run, connection] = running();
  run.toggleBreakpoint("b1");
  expect([...run.breakpoints.value]).toEqual(["b1"]);
  run.toggleBreakpoint("b1");
  expect([...run.breakpoints.value]).toEqual([]);
  expect(connection.sent).toEqual([
    { kind: "SetBreakpoints", blocks: ["b1"] },
    { kind: "SetBreakpoints", blocks: [] },
  ]);
});

test("a project that opens brings its robot, world and breakpoints", () => {
  const [run, connection] = running();
  connection.tell({ kind: "RunState", state: "running" });
  connection.tell({ kind: "Opened", name: "square", robot: "sim-ev3", world: "line", breakpoints: ["b2"] });
  expect(run.robot.value).toBe("sim-ev3");
  expect(run.world.value).toBe("line");
  expect([...run.breakpoints.value]).toEqual(["b2"]);
  expect(run.active.value).toBe(false);
});

test("another world clears the variables and the end of the run before", () => {
  const [run, connection] = running();
  connection.tell({ kind: "Ended", ended: "finished" });
  connection.tell({ kind: "Variables" });
  connection.tell({ kind: "RunState", state: "idle" });
  expect([run.ended.value, run.variables.value, run.state.value.state]).toEqual([null, null, "idle"]);
});

test("a bump is shown for three seconds of the robot's time, and until the next run starts", () => {
  const [run, connection] = running();
  const bumped = { kind: "Bumped", time: 2, thing: { code: "why-name", values: {} } } as const;
  const at = (time: number) => connection.tell({ kind: "Telemetry", time, robots: [] });
  at(2);
  connection.tell(bumped);
  expect(run.bump.value).toMatchObject({ time: 2 });
  at(5.1);
  expect(run.bump.value).toBeNull();
  connection.tell({ ...bumped, time: 5 });
  connection.tell({ kind: "RunState", state: "starting" });
  expect(run.bump.value).toBeNull();
});
