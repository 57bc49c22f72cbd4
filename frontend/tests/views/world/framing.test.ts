import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { FIELD, frame, INNER, type Subject } from "../../../src/views/world/framing";
import { isHidden, type Screen } from "../../../src/views/world/hiding";
import type { XY } from "../../../src/views/world/scenery/description";

const EBO: Subject = { x: -400, y: 0, heading: 0, reach: 75, height: 120, goal: [410, 0], screens: [] };
const SMALL: Subject = { x: -100, y: 100, heading: 0, reach: 55, height: 75, goal: [900, -800], screens: [] };
const SQUARE: Subject = {
  ...{ x: 0, y: 0, heading: 0, reach: 70, height: 60, screens: [] },
  ...{
    goal: [300, 0],
    others: [
      [300, -300],
      [0, -300],
    ],
  },
};
const LONELY: Subject = { x: 0, y: 0, heading: 90, reach: 75, height: 120, goal: null, screens: [] };

function cameraFor(subject: Subject, aspect: number, free = 1): PerspectiveCamera {
  const { place, target } = frame(subject, aspect, free);
  const camera = new PerspectiveCamera(FIELD, aspect, 20, 40_000);
  camera.up.set(0, 0, 1);
  camera.position.copy(place);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  return camera;
}

function shareOf({ x, y, height }: Subject, camera: PerspectiveCamera): number {
  const [foot, head] = [0, height].map((z) => new Vector3(x, y, z).project(camera).y) as [number, number];
  return (head - foot) / 2;
}

describe.each([
  ["a wide picture", 2.2],
  ["a usual picture", 1.3],
  ["a tall picture", 0.7],
])("in %s", (_, aspect) => {
  it.each([
    ["with a goal ahead", EBO],
    ["with a goal far to the side", SMALL],
    ["without a goal", LONELY],
  ])("a robot %s is large enough", (_, subject) => {
    // The height alone, without the body's depth.
    expect(shareOf(subject, cameraFor(subject, aspect))).toBeGreaterThan(0.05);
  });

  it.each([
    ["ahead", EBO],
    ["far to the side", SMALL],
  ])("robot and a goal %s are in the inner part", (_, subject) => {
    const camera = cameraFor(subject, aspect);
    for (const [x, y] of [[subject.x, subject.y], subject.goal ?? [0, 0]] as const) {
      const seen = new Vector3(x, y, 0).project(camera);
      expect(Math.max(Math.abs(seen.x), Math.abs(seen.y))).toBeLessThan(INNER);
    }
  });

  it("all goals that are near are in the inner part", () => {
    const camera = cameraFor(SQUARE, aspect);
    for (const [x, y] of [[0, 0], SQUARE.goal ?? [0, 0], ...(SQUARE.others ?? [])] as const) {
      const seen = new Vector3(x, y, 0).project(camera);
      expect(Math.max(Math.abs(seen.x), Math.abs(seen.y))).toBeLessThan(INNER);
    }
  });

  it("a goal that is far away does not make the robot tiny", () => {
    const camera = cameraFor({ ...SQUARE, others: [[4000, 4000]] }, aspect);
    expect(shareOf(SQUARE, camera)).toBeGreaterThan(0.05);
  });

  it("the camera looks down by 25 to 35 degrees", () => {
    const { place, target } = frame(EBO, aspect);
    const down = Math.atan2(place.z, Math.hypot(place.x - target.x, place.y - target.y));
    expect((down * 180) / Math.PI).toBeGreaterThanOrEqual(25);
    expect((down * 180) / Math.PI).toBeLessThanOrEqual(35);
  });
});

it("where half of the picture is covered, a robot is shown larger in the rest, if need be without all of its goals", () => {
  const [goal, ...others]: XY[] = [
    [-700, 350],
    [0, 300],
    [400, -400],
    [1000, -400],
  ];
  const maze: Subject = {
    x: -1000,
    y: -300,
    heading: 0,
    reach: 60,
    height: 80,
    goal: goal ?? null,
    others,
    screens: [],
  };
  const alone = shareOf(maze, cameraFor(maze, 2.1));
  const beside = shareOf(maze, cameraFor(maze, 2.1, 0.5));

  expect(beside).toBeGreaterThan(1.5 * alone);
});

describe.each([
  ["a tall picture", 0.86],
  ["a usual picture", 1.36],
])("without a goal, in %s", (_, aspect) => {
  it.each([
    ["to the right", 0, -0.25],
    ["to the left", 180, 0.25],
  ])("a robot that looks %s leaves room ahead of it", (_, heading, side) => {
    const seen = new Vector3(0, 0, 0).project(cameraFor({ ...LONELY, heading }, aspect));

    expect(Math.sign(side) * seen.x).toBeGreaterThan(Math.abs(side));
    expect(seen.y).toBeLessThan(-0.1);
  });

  it("it takes a quarter of the width, and not much more", () => {
    const camera = cameraFor({ ...LONELY, heading: 0 }, aspect);
    const [left, right] = [-LONELY.reach, LONELY.reach].map((x) => new Vector3(x, 0, 0).project(camera).x);

    expect(((right ?? 0) - (left ?? 0)) / 2).toBeGreaterThan(0.22);
    expect(((right ?? 0) - (left ?? 0)) / 2).toBeLessThan(0.32);
  });
});

/** A wall with its corners, mm, standing on the floor. */
function wall(west: number, south: number, east: number, north: number, bottom = 0, top = 200): Screen {
  const outline: XY[] = [
    [west, south],
    [east, south],
    [east, north],
    [west, north],
  ];
  return { outline, bottom, top };
}

describe("obstacles around a robot", () => {
  it.each([
    ["to the south", [wall(-600, -220, 600, -200)]],
    ["on three sides", [wall(-220, -220, 220, -200), wall(-220, -220, -200, 220), wall(200, -220, 220, 220)]],
  ])("does not hide it when it is %s", (_, screens) => {
    const { place } = frame({ ...LONELY, screens }, 1.3);

    expect(isHidden([place.x, place.y, place.z], [0, 0, LONELY.height / 2], screens)).toBe(false);
  });

  it("does not fill a third of the picture", () => {
    const beside = [wall(-500, -910, -60, -900, 0, 700)];
    const camera = cameraFor({ ...LONELY, screens: beside }, 1.3);
    const { x, y, z } = camera.position;
    const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0).multiplyScalar(300);

    expect(isHidden([x, y, z], [right.x, right.y, 100], beside)).toBe(false);
    expect(isHidden([x, y, z], [-right.x, -right.y, 100], beside)).toBe(false);
  });

  it("does not change a picture that it is not in", () => {
    const behind = [wall(-600, 400, 600, 420)];

    expect(frame({ ...EBO, screens: behind }, 1.3)).toEqual(frame(EBO, 1.3));
  });
});

describe("a view", () => {
  const board = [wall(-50, 90, 50, 110, 50, 150)];

  it.each([
    ["through a board is hidden", 100, 100, true],
    ["over it is not", 200, 160, false],
    ["under it is not", 40, 40, false],
    ["that enters its top and leaves its back is", 180, 120, true],
  ])("%s", (_, from, to, hidden) => {
    expect(isHidden([0, 0, from], [0, 200, to], board)).toBe(hidden);
  });

  it("past a board is not hidden", () => {
    expect(isHidden([60, 0, 100], [60, 200, 100], board)).toBe(false);
  });

  it("that ends before a board is not hidden", () => {
    expect(isHidden([0, 0, 100], [0, 80, 100], board)).toBe(false);
  });
});
