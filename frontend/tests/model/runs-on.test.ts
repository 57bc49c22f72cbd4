// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { expect, test } from "vitest";

import type { Program } from "../../src/model/program";
import { RunsOn } from "../../src/model/runs-on";
import { FakeConnection } from "../fake-connection";

test("the server is asked which robots can run the program only while the answers are shown", () => {
  const connection = new FakeConnection();
  const program = { state: signal({}) } as unknown as Program;
  const isShown = signal(false);
  const stop = new RunsOn(connection.real, program, signal("square")).watch(() => isShown.value);
  expect(connection.sent).toEqual([]);
  isShown.value = true;
  expect(connection.sent).toEqual([{ kind: "ReadRunsOn" }]);
  stop();
});
