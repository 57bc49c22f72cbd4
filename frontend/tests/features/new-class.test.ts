// @vitest-environment happy-dom

import { expect, test } from "vitest";

import { newTitle } from "../../src/features/teachers/classes";
import { speak } from "../dialog";

const SUNDAY = new Date(2026, 10, 29);

test("a class is first named after the day, with a number if there is one of that name", () => {
  expect(newTitle([], SUNDAY)).toBe("Sunday November 29");
  expect(newTitle([{ title: "Sunday November 29" }], SUNDAY)).toBe("Sunday November 29 2");
});

test("the day has the words of the page's language", async () => {
  await speak("es");
  expect(newTitle([], SUNDAY)).toBe("domingo 29 de noviembre");
});
