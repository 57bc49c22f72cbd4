import { expect, test } from "vitest";

import { Odometer } from "../../src/model/odometer";
import type { Telemetry } from "../../src/protocol/messages";

function at(time: number, x: number, y = 0, located = true): Telemetry {
  return { time, robots: [{ name: "robot", x, y, heading: 0, located }] } as unknown as Telemetry;
}

test("the way adds up, there and back", () => {
  const odometer = new Odometer();
  expect(odometer.read(at(0, 0))).toBe(0);
  expect(odometer.read(at(0.1, 30, 40))).toBe(50);
  expect(odometer.read(at(0.2, 0, 0))).toBe(100);
});

test("a robot that is placed has not driven", () => {
  const odometer = new Odometer();
  odometer.read(at(0, 0));
  expect(odometer.read(at(0, 150))).toBe(0);
  expect(odometer.read(at(0.1, 900))).toBe(0);
});

test("a new run begins at zero", () => {
  const odometer = new Odometer();
  odometer.read(at(5, 0));
  expect(odometer.read(at(5.1, 50))).toBe(50);
  expect(odometer.read(at(0, 0))).toBe(0);
});

test("nothing is told of a robot whose place is not known", () => {
  const odometer = new Odometer();
  expect(odometer.read(null)).toBe(null);
  expect(odometer.read(at(0, 0, 0, false))).toBe(null);
});
