import { describe, expect, it } from "vitest";

import { Pace, shownSpeed } from "../../src/model/pace";

/** What is measured at the end of ten pictures a second for three seconds. */
function measured(factor: number): number | null {
  const pace = new Pace();
  let found: number | null = null;
  for (let i = 0; i <= 30; i += 1) found = pace.add(factor * 0.1 * i, 0.1 * i);
  return found;
}

describe("the pace of the world", () => {
  it.each([0.5, 1, 12])("is measured as %s times real time", (factor) => {
    expect(measured(factor)).toBeCloseTo(factor);
  });

  it("is unknown at first, and again after the world began again", () => {
    const pace = new Pace();
    expect(pace.add(0, 0)).toBeNull();
    expect(pace.add(2, 2)).toBeCloseTo(1);
    expect(pace.add(0, 2.1)).toBeNull();
  });

  it("is told where it is clearly less than the chosen one, or nothing was chosen", () => {
    expect(shownSpeed(2.84, 20)).toBe(2.8);
    expect(shownSpeed(18, 20)).toBeNull();
    expect(shownSpeed(31.4, null)).toBe(31);
    expect(shownSpeed(null, 20)).toBeNull();
  });
});
