import { expect, test, vi } from "vitest";

import type { Program } from "../../src/model/program";
import { RobotTabs } from "../../src/model/robot-tabs";
import { FakeConnection } from "../fake-connection";

function robotTabs() {
  const connection = new FakeConnection();
  const program = { leave: vi.fn(), flush: vi.fn() };
  const tabs = new RobotTabs(connection.real, program as unknown as Program);
  return { tabs, connection };
}

/** A swarm of two in the given states, and a robot of its own; the page shows the first of the swarm. */
function told(first: string, second: string) {
  const { tabs, connection } = robotTabs();
  const robots = [
    { name: "ant-1", state: first },
    { name: "ant-2", state: second },
  ];
  const all = [
    { name: "ant", robot: "sim-ebo", state: first, robots },
    { name: "bee", robot: "sim-thymio", state: "running" },
  ];
  connection.tell({ kind: "Tabs", tabs: all, open: "ant", shows: "ant-1" });
  return { tabs, connection };
}

test("robots that share a program have the colour of its tab", () => {
  const { tabs } = told("idle", "idle");
  expect(tabs.colorOf("ant-2")).toBe(tabs.colorOf("ant"));
  expect(tabs.colorOf("bee")).not.toBe(tabs.colorOf("ant"));
});

test("every robot of a shared program counts", () => {
  const { tabs } = told("idle", "idle");
  expect([tabs.count.value, tabs.countOf("ant"), tabs.countOf("bee")]).toEqual([3, 2, 1]);
});

test("without tabs there is one robot", () => {
  const { tabs } = robotTabs();
  expect([tabs.count.value, tabs.countOf("")]).toEqual([1, 1]);
});

test.each(["held", "input"])("the page goes to a robot whose program is in the state %s", (state) => {
  const { connection } = told("running", state);
  expect(connection.sent).toEqual([{ kind: "OpenTab", name: "ant", robot: "ant-2" }]);
});

test.each(["held", "paused", "input"])("the page stays with a robot whose program is in the state %s", (state) => {
  expect(told(state, "held").connection.sent).toEqual([]);
});

test("the page stays while the robots run", () => {
  expect(told("running", "running").connection.sent).toEqual([]);
});
