import { expect, test } from "vitest";

import { beyond, changes, formatValue, parseValue, valuesOf } from "../../src/features/robot-settings/robot-settings";
import type { Setting } from "../../src/protocol/messages";

function setting(values: Partial<Setting>): Setting {
  return { name: "port", sort: "text", value: "", default: "", ...values } as Setting;
}

test.each<[Partial<Setting>, unknown]>([
  [{ sort: "number" }, 12.5],
  [{ sort: "whole" }, 40],
  [{ sort: "text" }, "ev3dev.local"],
  [{ sort: "list", value: [1] }, [3, 4.5]],
  [{ sort: "list", value: ["a"] }, ["left", "right"]],
  [{ sort: "number", choices: ["none"] }, "none"],
])("what a field of %o shows for a value means that value", (values, value) => {
  const one = setting(values);
  expect(parseValue(one, formatValue(one, value))).toEqual(value);
});

test("text that is not a number is left for the server to refuse", () => {
  expect(parseValue(setting({ sort: "number" }), "fast")).toBe("fast");
});

test("an empty number is the setting's word for none", () => {
  expect(parseValue(setting({ sort: "number", choices: ["none"] }), " ")).toBe("none");
});

test.each([
  ["Recognise emotions", "recognise emotions; the law may forbid it", "the law may forbid it"],
  ["Timeout", "timeout in seconds", "in seconds"],
  ["Port", "port", ""],
  ["Port", "ports, from left to right", "ports, from left to right"],
  ["Front", "distance sensors", "distance sensors"],
])("below the label %s, the description %s says %s", (label, description, said) => {
  expect(beyond(label, description)).toBe(said);
});

test("only values that differ are changes", () => {
  const settings = [setting({ name: "a", value: [1, 2] }), setting({ name: "b", value: "x" })];
  expect(changes(settings, valuesOf(settings))).toEqual({});
  expect(changes(settings, { a: [1, 2], b: "y" })).toEqual({ b: "y" });
});
