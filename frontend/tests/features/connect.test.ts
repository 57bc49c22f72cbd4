import { readFileSync } from "node:fs";

import { signal } from "@preact/signals";
import { expect, test } from "vitest";
import { gauges } from "../../src/features/connect/gauges";
import { questions } from "../../src/features/connect/help";
import { startLanguage } from "../../src/i18n";
import { Connect, lists } from "../../src/model/connect";
import type { RobotConnected, RobotsNearby, Sensor } from "../../src/protocol/messages";
import { FakeConnection } from "../fake-connection";

const NONE: RobotConnected = { kind: "RobotConnected", state: "none" };
const COZMO = { id: "cozmo 172.31.1.1:5551", robot: "cozmo", way: "wifi", place: "172.31.1.1" } as const;
const NEARBY: RobotsNearby = {
  kind: "RobotsNearby",
  found: [COZMO],
  known: [{ robot: "ev3", used: true }, { robot: "cozmo", name: "Ada" }, { robot: "thymio" }],
};

function sensor(values: Partial<Sensor>): Sensor {
  return { device: "DistanceSensors", key: "ROBOT", value: 100, ...values };
}

test("robots that answer come first, then those used before, then all others", () => {
  const { found, before, others } = lists(NEARBY, NONE);
  expect(found.map((one) => [one.id, one.name])).toEqual([[COZMO.id, "Ada"]]);
  expect(before.map((one) => one.robot)).toEqual(["ev3"]);
  expect(others.map((one) => one.robot)).toEqual(["thymio"]);
});

test("a robot that is connected by its settings is listed although it was not found", () => {
  const { found, others } = lists(NEARBY, { ...NONE, state: "connected", id: "thymio", robot: "thymio" });
  expect(found.map((one) => one.robot)).toEqual(["thymio", "cozmo"]);
  expect(others).toEqual([]);
});

test("a robot without its add-on has the command that installs it", () => {
  const lacking = { command: "pip install x", ours: true };
  const { others } = lists({ kind: "RobotsNearby", known: [{ robot: "ebo", add_on: lacking }] }, NONE);
  expect(others.map((one) => one.addOn)).toEqual([lacking]);
});

test("nothing is listed before the first answer", () => {
  expect(lists(null, NONE)).toEqual({ found: [], before: [], others: [] });
});

test("closing stops the search and the robot", () => {
  const connection = new FakeConnection();
  const connect = new Connect(connection.real);
  connect.begin();
  connection.tell({ kind: "RobotConnected", state: "connected", id: COZMO.id, robot: "cozmo" });
  connect.end();
  expect(connection.sent.map((one) => one.kind)).toEqual(["FindRobots", "FindRobots", "DisconnectRobot"]);
});

test("a page without a robot does not disconnect", () => {
  const connection = new FakeConnection();
  const connect = new Connect(connection.real);
  connect.begin();
  connect.end();
  expect(connection.sent.map((one) => one.kind)).toEqual(["FindRobots", "FindRobots"]);
});

test("after the connection to the server was lost, robots are looked for again and none is connected", () => {
  const connection = new FakeConnection();
  const connect = new Connect(connection.real);
  connect.begin();
  connection.tell({ kind: "RobotConnected", state: "connected", id: COZMO.id, robot: "cozmo" });
  connect.connected();
  expect(connect.isConnected.value).toBe(false);
  expect(connection.sent.at(-1)).toEqual({ kind: "FindRobots", on: true });
});

test("values of a robot that is gone are not shown", () => {
  const connection = new FakeConnection();
  const connect = new Connect(connection.real);
  connection.tell({ kind: "RobotValues", battery: 4 });
  connection.tell({ kind: "RobotConnected", state: "lost" });
  expect(connect.values.value).toBeNull();
});

test("what says most is shown first, with a bar by its range", async () => {
  await startLanguage(signal("en"));
  const shown = gauges({
    kind: "RobotValues",
    sensors: [sensor({ device: "Accelerometer", place: "up", value: 10 }), sensor({ value: 500 })],
    joints: { CAMERA: 45 },
    speed: [50, 0],
    heading: -90,
  });
  expect(shown.map(({ name, text, part }) => [name, text, part])).toEqual([
    ["Distance", "500 mm", 0.25],
    ["Heading", "-90 °", 0.5],
    ["Driving", "50 mm/s", 0.25],
    ["Turning", "0 °\u2009/\u2009s", 0],
    ["Head", "45 °", 0.5],
    ["Accelerometer up", "10.00 m/s²", 0.75],
  ]);
});

test("a gyroscope takes the place of the odometry's heading", () => {
  const shown = gauges({ kind: "RobotValues", sensors: [sensor({ device: "Gyroscope" })], heading: 10 });
  expect(shown.map((one) => one.id)).not.toContain("heading");
});

test.each(["en", "es"])("every question has its words and what to do, in %s", (language) => {
  const words = readFileSync(`../src/learnblock/i18n/${language}/page/connect.ftl`, "utf-8");
  for (const robot of ["cozmo", "thymio", "ev3", "ebo", "rcis", "coppeliasim", "mine"]) {
    expect(questions(robot).length).toBeGreaterThan(1);
    for (const code of questions(robot)) expect(words).toMatch(new RegExp(`^${code} = .*\\n${code}-do = `, "m"));
  }
});
