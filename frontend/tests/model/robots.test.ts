import { expect, test } from "vitest";

import { realOf, robotGroups, robotTitle, servingWords } from "../../src/model/robots";

const ROBOTS = [
  { name: "sim-cozmo", title: "Cozmo", simulated: true },
  { name: "coppeliasim", title: "coppeliasim", simulated: false },
  { name: "cozmo", title: "cozmo", simulated: false },
  { name: "mine", title: "mine", simulated: false },
];

test("robots are grouped into simulated and real ones", () => {
  const groups = robotGroups(ROBOTS).map(({ name, robots }) => [name, robots.map((one) => one.name)]);
  expect(groups).toEqual([
    ["simulated", ["sim-cozmo", "coppeliasim"]],
    ["real", ["cozmo", "mine"]],
  ]);
});

test("a robot is shown by the name that the user has given it", () => {
  expect(robotTitle({ ...ROBOTS[2]!, given: "Ada" })).toBe("page-bar-named-robot");
});

test.each([
  ["cozmo", "cozmo"],
  ["sim-cozmo", "cozmo"],
  ["sim-thymio", undefined],
])("the real robot of %s is %s", (name, expected) => {
  const real = ROBOTS.filter((one) => !one.simulated);
  expect(realOf(name, real)?.name).toBe(expected);
});

test("a group without robots is left out", () => {
  expect(robotGroups(ROBOTS.slice(0, 1)).map(({ name }) => name)).toEqual(["simulated"]);
});

test("a real robot's title says that it is real", () => {
  // Without words, a phrase is its code.
  const real = "page-bar-real-robot";
  expect(ROBOTS.map(robotTitle)).toEqual(["Cozmo", "coppeliasim", real, real]);
});

test("only senses that the robot has are served", () => {
  const robot = { ...ROBOTS[0]!, serves: { "black-line": "GroundSensors:line" } };
  expect(servingWords(robot, ["black-line"])).toBe("check-serving");
  expect(servingWords(robot, ["red-line", "Camera"])).toBe("");
});
