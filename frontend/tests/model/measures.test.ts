import { describe, expect, it } from "vitest";
import { lengthOf, measures, measuresOf, motionOf, readingsOf } from "../../src/model/measures";
import { Odometer } from "../../src/model/odometer";
import type { Sensor, Telemetry } from "../../src/protocol/messages";

const AHEAD: Sensor = { device: "DistanceSensors", key: "ROBOT", value: 300, place: "front", number: 1 };
const BESIDE: Sensor = { ...AHEAD, place: "left" };

function at(time: number, x: number, heading: number): Telemetry {
  return { kind: "Telemetry", time, robots: [{ name: "robot", x, y: 0, heading }], sensors: [AHEAD] };
}

describe("the readings of a robot", () => {
  it("are those of its sensors, its heading and the way driven", () => {
    const odometer = new Odometer();
    readingsOf(at(0, 0, 0), odometer);

    const readings = readingsOf(at(0.1, 30, -90), odometer);

    expect(readings.map(({ device, value }) => [device, value])).toEqual([
      ["DistanceSensors", 300],
      ["Heading", -90],
      ["Driven", 30],
    ]);
  });

  it("are those of its sensors alone if its place is not known", () => {
    const lost: Telemetry = { ...at(0, 0, 0), robots: [{ name: "robot", x: 0, y: 0, heading: 0, located: false }] };

    expect(readingsOf(lost, new Odometer())).toEqual([AHEAD]);
  });
});

describe("the measures of a program", () => {
  it("are what its questions need, then how the robot moves", () => {
    expect(measuresOf(["GroundSensors:line", "Camera", "DistanceSensors:left"])).toEqual([
      "GroundSensors",
      "Camera",
      "DistanceSensors:left",
      "Heading",
      "Driven",
    ]);
  });

  it("are the usual ones if it asks for nothing but the robot's own movement", () => {
    expect(measuresOf(["Gyroscope:Z_AXIS", "Base", "Display"])).toEqual(["DistanceSensors:front", "Heading", "Driven"]);
  });

  it("are five at most", () => {
    const sides = ["front", "left", "right", "back"].map((side) => `DistanceSensors:${side}`);

    expect(measuresOf([...sides, "Bumper", "Accelerometer"])).toEqual([...sides, "Bumper"]);
  });
});

it("a measure is given by its own sensors only", () => {
  const all = [AHEAD, BESIDE, ...motionOf(10, 20)];
  const given = ["DistanceSensors:front", "Heading", "Driven"].map((one) =>
    all.filter((sensor) => measures(one, sensor)),
  );

  expect(given).toEqual([[AHEAD], [all[2]], [all[3]]]);
});

it("the length of a way is the sum of its parts", () => {
  expect(
    lengthOf([
      [0, 0],
      [30, 40],
      [30, 50],
    ]),
  ).toBe(60);
});
