// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { beforeEach, describe, expect, it } from "vitest";
import { foundInWords } from "../../../src/app/world/chip-values";
import { startLanguage } from "../../../src/i18n";
import type { Seen } from "../../../src/protocol/messages";

const seen = (sort: Seen["sort"], label: string): Seen => ({ sort, label, corners: [] });

beforeEach(() => startLanguage(signal("en")));

describe("what a program has found in the picture", () => {
  it("is listed, the same only once", () => {
    const found = [seen("tag", "3"), seen("line", "red left"), seen("object", "green"), seen("object", "green")];

    expect(foundInWords(found)).toBe("Tag 3, Line red left, Green thing");
  });

  it("is a dash if there is nothing", () => {
    expect(foundInWords([])).toBe("–");
  });

  it("is not shown of a program that has not looked", () => {
    expect(foundInWords(undefined)).toBeNull();
  });
});
