import { describe, expect, it } from "vitest";
import { wrap } from "../../../src/views/world/robots/lettering";

/** Every letter is one wide. */
function lines(text: string, width: number): string[] {
  return wrap(text, width, (line) => line.length);
}

describe("wrapping", () => {
  it("breaks lines between words", () => {
    expect(lines("I see a red ball", 7)).toEqual(["I see a", "red", "ball"]);
  });

  it("keeps a text that fits on one line", () => {
    expect(lines("hello", 7)).toEqual(["hello"]);
  });

  it("cuts words that are longer than a line", () => {
    expect(lines("abcdefgh ij", 3)).toEqual(["abc", "def", "gh", "ij"]);
  });

  it("keeps the text's own lines", () => {
    expect(lines("one\ntwo", 9)).toEqual(["one", "two"]);
  });
});
