import { signal } from "@preact/signals";
import { expect, test, vi } from "vitest";

import { KeptRuns } from "../../src/model/kept-runs";
import { LookingBack } from "../../src/model/looking-back";
import type { Program } from "../../src/model/program";
import { Running } from "../../src/model/running";
import type { Toasts } from "../../src/ui/toasts";
import { FakeConnection } from "../fake-connection";

const [OLD, NEW, OTHER] = ["1700000000000-1", "1700000000001-1", "1700000000002-1"] as const;

function keptRuns() {
  const connection = new FakeConnection();
  const running = new Running(connection.real);
  const program = { state: signal({ blocktext: "x = 1" }) };
  const forgetQuestions = vi.fn();
  const kept = new KeptRuns(connection.real, signal("My project"), {
    program: program as unknown as Program,
    running,
    lookingBack: new LookingBack(running, connection.real),
    toasts: {} as Toasts,
    forgetQuestions,
  });
  return { kept, connection, running, program, forgetQuestions };
}

function run(id: string) {
  return { id, time: 1_700_000_000 };
}

function compared() {
  const way = [
    [0, 0, 0],
    [1, 60, 0],
    [2, 120, 5],
  ];
  const step = { phrase: { code: "why-parted" }, time: 1 };
  return { kind: "RunsCompared", together: 1, first: { id: OLD, way, step }, second: { id: NEW } } as const;
}

test("a run that is shown is shown at its end, and questions about another one are forgotten", () => {
  const { connection, running, forgetQuestions } = keptRuns();
  connection.tell({ kind: "RunShown", run: run(OLD) });
  expect(running.kept.value?.id).toBe(OLD);
  expect(connection.sent.at(-1)).toEqual({ kind: "LookBack", time: 1_000_000 });
  expect(forgetQuestions).toHaveBeenCalled();
});

test("leaving the past of a kept run leaves the run", () => {
  const { connection, running } = keptRuns();
  connection.tell({ kind: "RunShown", run: run(OLD) });
  running.leavePast();
  expect(connection.sent.at(-1)).toEqual({ kind: "CloseRun" });
});

test("an edit makes the shown run one of an older program", () => {
  const { kept, connection, program } = keptRuns();
  connection.tell({ kind: "RunShown", run: run(OLD) });
  expect(kept.changed.value).toBe(false);
  program.state.value = { blocktext: "x = 2" };
  expect(kept.changed.value).toBe(true);
  connection.tell({ kind: "RunShown", run: run(NEW) });
  expect(kept.changed.value).toBe(false);
});

test("of three chosen runs the last two are compared, the older one first", () => {
  const { kept, connection } = keptRuns();
  for (const id of [OTHER, NEW, OLD]) kept.choose(id, true);
  kept.compare();
  expect(connection.sent.slice(-2)).toEqual([
    { kind: "OpenRun", run: OLD },
    { kind: "CompareRuns", first: OLD, second: NEW },
  ]);
});

test("both ways are shown, with the place where they parted, until another run is shown", () => {
  const { kept, connection } = keptRuns();
  connection.tell(compared());
  expect(kept.ways.value.map(({ parted }) => parted)).toEqual([[60, 0], null]);
  connection.tell({ kind: "RunShown", run: run(NEW) });
  expect(kept.ways.value).toHaveLength(2);
  connection.tell({ kind: "RunShown" });
  expect(kept.ways.value).toEqual([]);
});

test("a moment of the other run is shown once that run is open", () => {
  const { kept, connection } = keptRuns();
  connection.tell({ kind: "RunShown", run: run(OLD) });
  kept.lookAt(NEW, 1.5);
  expect(connection.sent.at(-1)).toEqual({ kind: "OpenRun", run: NEW });
  connection.tell({ kind: "Past", time: 2, line: { kind: "RunningLine", line: 1 }, variables: {} });
  connection.tell({ kind: "RunShown", run: run(NEW) });
  expect(connection.sent.at(-1)).toEqual({ kind: "LookBack", time: 1.5 });
});

test("the address of a file names the project", () => {
  const { kept } = keptRuns();
  expect(kept.address(OLD)).toBe(`projects/My%20project/runs/${OLD}.why`);
});
