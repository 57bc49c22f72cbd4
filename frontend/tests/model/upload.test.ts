import { expect, test } from "vitest";

import { originalsIn } from "../../src/features/libraries/originals";
import { uploadOf } from "../../src/model/upload";

function files(...names: string[]): File[] {
  return names.map((name) => new File([], name));
}

function kinds(...names: string[]) {
  const found = uploadOf(files(...names));
  if (found.kind === "program") return [found.file.name, ...found.libraries.map((one) => one.name)];
  return found.kind === "libraries" ? ["libraries", ...found.files.map((one) => one.name)] : [found.kind];
}

test("a program is opened, and the libraries of the original LearnBlock beside it with it", () => {
  expect(kinds("a.bt")).toEqual(["a.bt"]);
  expect(kinds("notes.txt", "step.lb", "step.py", "step.conf", "a.blockProject")).toEqual([
    "a.blockProject",
    "step.lb",
  ]);
});

test("the text of a library alone is a program, and with its other files a library", () => {
  expect(kinds("step.lb")).toEqual(["step.lb"]);
  expect(kinds("step.lb", "step.py")).toEqual(["libraries", "step.lb", "step.py"]);
  expect(kinds("dance.lblib")).toEqual(["libraries", "dance.lblib"]);
});

test("Python is a program unless it belongs to a library", () => {
  expect(kinds("a.py")).toEqual(["a.py"]);
  expect(kinds("a.py", "step.lb")).toEqual(["a.py", "step.lb"]);
});

test("endings may be in capitals", () => {
  expect(kinds("PROG.BT")).toEqual(["PROG.BT"]);
  expect(kinds("TEST.PY")).toEqual(["TEST.PY"]);
  expect(kinds("DANCE.LBLIB")).toEqual(["libraries", "DANCE.LBLIB"]);
});

test("several programs and files of other types are not opened", () => {
  expect(kinds("a.bt", "b.py")).toEqual(["several"]);
  expect(kinds("a.png")).toEqual(["unknown"]);
});

test("the files of original libraries are put together by their names", () => {
  const found = originalsIn(files("step.conf", "turn.lb", "step.lb", "turn.py"));
  const names = found.map((one) => [one.text, one.python, one.configuration].map((file) => file?.name));
  expect(names).toEqual([
    ["turn.lb", "turn.py", undefined],
    ["step.lb", undefined, "step.conf"],
  ]);
});
