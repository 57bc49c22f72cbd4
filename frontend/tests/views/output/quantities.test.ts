import { expect, test } from "vitest";

import type { Sensor } from "../../../src/protocol/messages";
import { readingText } from "../../../src/views/output/quantities";

const ACCELERATION: Sensor = { device: "Accelerometer", key: "", place: "up", value: null };

test("a reading that rounds to zero has no sign", () => {
  expect(readingText(ACCELERATION, -0.001)).toBe("0.00 m/s²");
});

test("a negative reading keeps its sign", () => {
  expect(readingText(ACCELERATION, -0.01)).toBe("-0.01 m/s²");
});
