import { expect, test } from "vitest";

import { drawnAt, paced, placeAt, shownAt, timeAt, type Waypoint } from "../../../src/views/blocks/playback";

const WAY: readonly Waypoint[] = [
  [0, 0, 0, 0],
  [2, 100, 0, 0],
  [3, 100, 0, 90],
];

test("steps of the same moment follow each other slowly enough to be seen", () => {
  const frames = paced(
    [
      [0, "line", "a"],
      [0, "line", "b"],
      [0, "line", "c"],
    ],
    0,
  );
  expect(frames.map(({ at }) => at)).toEqual([0, 0.45, 0.9, 1.35]);
});

test("a step that takes longer is played as long as it took", () => {
  const frames = paced(
    [
      [0, "line", "a"],
      [2, "line", "b"],
    ],
    3,
  );
  expect(frames.map(({ at }) => at)).toEqual([0, 2, 3]);
  expect(timeAt(frames, 1.5)).toBe(1.5);
});

test("the robot goes evenly between two places, and turns the short way round", () => {
  expect(placeAt(WAY, 1)).toEqual([1, 50, 0, 0]);
  expect(placeAt(WAY, 2.5)).toEqual([2.5, 100, 0, 45]);
  expect(placeAt(WAY, 9)).toEqual([3, 100, 0, 90]);
  const [, , , heading] =
    placeAt(
      [
        [0, 0, 0, 170],
        [1, 0, 0, -170],
      ],
      0.5,
    ) ?? [];
  expect(heading).toBe(180);
});

test("the picture marks the block that runs and shows the last lines printed", () => {
  const frames = paced(
    [
      [0, "line", "a"],
      [0, "print", "1"],
      [0, "line", "b"],
      [0, "print", "2"],
    ],
    1,
  );
  expect(shownAt(frames, 0.5)).toMatchObject({ block: "a", printed: ["1"] });
  expect(shownAt(frames, 1.4)).toMatchObject({ block: "b", printed: ["1", "2"] });
  expect(shownAt(frames, 99)).toMatchObject({ block: "", printed: ["1", "2"] });
});

test("faces, lamps and signs are those of the last command", () => {
  const frames = paced(
    [
      [0, "Display.show_emotion", "joy"],
      [0, "RGBLed.set_color", "255 0 0"],
      [0, "Speaker.tone", "440.0 1.0"],
    ],
    1,
  );
  expect(shownAt(frames, 1)).toMatchObject({ face: "joy", light: "rgb(255 0 0)", sign: "♪ 440 Hz" });
});

test("the pen draws where the robot was while it was down", () => {
  const frames = paced(
    [
      [0.5, "Pen.set", "True"],
      [1, "Pen.set", "False"],
    ],
    3,
  );
  const [line, ...others] = drawnAt(frames, WAY, 3);
  expect(others).toEqual([]);
  expect(line?.places.map(([, x]) => x)).toEqual([25, 50]);
});

test("an erased drawing is gone", () => {
  const frames = paced(
    [
      [0, "Pen.set", "True"],
      [1, "Pen.set", "False"],
      [2, "Pen.clear", ""],
    ],
    3,
  );
  expect(drawnAt(frames, WAY, 3)).toEqual([]);
});
