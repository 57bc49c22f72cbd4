import { expect, test } from "vitest";

import type { Telemetry } from "../../../src/protocol/messages";
import { Motion } from "../../../src/views/world/motion";

function telemetry(x: number, heading = 0): Telemetry {
  return { kind: "Telemetry", robots: [{ x, y: 0, heading }] } as unknown as Telemetry;
}

test("a robot moves evenly from one message to the next", () => {
  const motion = new Motion();
  motion.receive(telemetry(0), 0);
  motion.receive(telemetry(0), 50);
  motion.receive(telemetry(100), 100);
  const places = [100, 110, 120, 130, 160].map((now) => motion.at(now).robots[0]?.x ?? 0);
  expect(places[0]).toBeCloseTo(0);
  expect(places.at(-1)).toBe(100);
  expect(places).toEqual(places.toSorted((a, b) => a - b));
});

test("a robot turns the shorter way", () => {
  const motion = new Motion();
  motion.receive(telemetry(0, 170), 0);
  motion.receive(telemetry(0, 170), 50);
  motion.receive(telemetry(0, -170), 100);
  const heading = motion.at(115).robots[0]?.heading ?? 0;
  expect(Math.abs(heading)).toBeGreaterThanOrEqual(170);
});

test("nothing moves once the newest message has been reached", () => {
  const motion = new Motion();
  motion.receive(telemetry(0), 0);
  motion.receive(telemetry(5), 50);
  expect([motion.moving(60), motion.moving(500)]).toEqual([true, false]);
});

test("a robot that joins is drawn where it is", () => {
  const motion = new Motion();
  motion.receive(telemetry(0), 0);
  const two = { ...telemetry(0), robots: [...telemetry(0).robots, ...telemetry(300).robots] } as Telemetry;
  motion.receive(two, 50);
  expect(motion.at(51).robots[1]?.x).toBe(300);
});
