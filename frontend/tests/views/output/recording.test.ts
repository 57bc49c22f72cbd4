import { expect, test } from "vitest";

import type { Sensor } from "../../../src/protocol/messages";
import { sensorId } from "../../../src/views/output/quantities";
import { Recording } from "../../../src/views/output/recording";

function light(value: number): Sensor {
  return { device: "GroundSensors", key: "light", value };
}

function bumper(value: boolean): Sensor {
  return { device: "Bumper", key: "bumper", value };
}

const LIGHT = sensorId(light(0));
const BUMPER = sensorId(bumper(false));

test("a sensor that comes later has no readings before that", () => {
  const recording = new Recording();
  recording.add(0, [light(100)]);
  recording.add(1, [light(90), bumper(true)]);
  expect(recording.last(10, [LIGHT, BUMPER])).toEqual({
    times: [0, 1],
    readings: [
      [100, 90],
      [null, 1],
    ],
  });
});

test("a moment that comes twice is kept once", () => {
  const recording = new Recording();
  recording.add(1, [light(5)]);
  recording.add(1, [light(6)]);
  expect(recording.last(10, [LIGHT]).readings).toEqual([[5]]);
});

test("a clock that goes back starts a new recording", () => {
  const recording = new Recording();
  recording.add(5, [light(5)]);
  recording.add(0, [light(6)]);
  expect(recording.last(10, [LIGHT])).toEqual({ times: [0], readings: [[6]] });
});

test("the last seconds leave out what is older", () => {
  const recording = new Recording();
  for (let time = 0; time <= 20; time++) recording.add(time, [light(time)]);
  expect(recording.last(3, [LIGHT]).times).toEqual([17, 18, 19, 20]);
});

test("a file has a line for each moment and a column for each sensor", () => {
  const recording = new Recording();
  recording.add(0, [light(5)]);
  recording.add(0.5, [light(6), bumper(false)]);
  expect(recording.csv()).toBe("time (s),GroundSensors light (%),Bumper bumper\r\n0,5,\r\n0.5,6,0\r\n");
});

test("half an hour is the most that is kept", () => {
  const recording = new Recording();
  for (let step = 0; step < 40_000; step++) recording.add(step / 20, [light(step)]);
  const { times } = recording.last(Number.POSITIVE_INFINITY, [LIGHT]);
  expect(times.length).toBeLessThan(36_000);
  expect(times.at(-1)).toBe(39_999 / 20);
});

test("around a moment, readings end with those of the moment, and times go on", () => {
  const recording = new Recording();
  for (let time = 0; time <= 20; time++) recording.add(time, [light(time)]);
  expect(recording.around(17.5, 4, [LIGHT], [light(99)])).toEqual({
    times: [16, 17, 17.5, 18, 19],
    readings: [[16, 17, 99, null, null]],
  });
});
