// @vitest-environment happy-dom
/** The examples in a lesson's text and in the docs can be opened as projects. */

import { cleanup, fireEvent, render, screen } from "@testing-library/preact";
import { afterEach, expect, test, vi } from "vitest";

import { Markdown } from "../../src/features/lessons/markdown";
import { button } from "../dialog";

afterEach(cleanup);

const fenced = (language: string, code: string) => `\`\`\`${language}\n${code}\n\`\`\``;
const PROGRAM = "main:\n    function.turn(90)\nend";
const NAME = "Open the example as a project";

test("a whole program is opened with one button", () => {
  const open = vi.fn();
  render(<Markdown text={fenced("blocktext turn.bt", PROGRAM)} lesson="" drawings={{}} open={open} />);
  fireEvent.click(button(NAME));
  expect(open.mock.calls).toEqual([[PROGRAM]]);
});

test("a program that only answers an event is one, too", () => {
  const event = "when shaken = function.is_shaken():\n    pass\nend";
  render(<Markdown text={fenced("blocktext", event)} lesson="" drawings={{}} open={vi.fn()} />);
  expect(screen.queryAllByRole("button", { name: NAME })).toHaveLength(1);
});

test.each([
  ["a part of a program", "blocktext", "x = 3"],
  ["a command", "sh", "learnblock run main.bt"],
  ["another language", "python", "main:"],
])("%s has no button", (_, language, code) => {
  render(<Markdown text={fenced(language, code)} lesson="" drawings={{}} open={vi.fn()} />);
  expect(screen.queryAllByRole("button", { name: NAME })).toHaveLength(0);
});

test("where nothing can be opened there is no button", () => {
  render(<Markdown text={fenced("blocktext", PROGRAM)} lesson="" drawings={{}} />);
  expect(screen.queryAllByRole("button")).toHaveLength(0);
});

test("without a server a picture is one of those that are given, or its words", () => {
  const pictures = { "robot.svg": "data:image/svg+xml;base64,AA==" };
  const text = "![The robot](pictures/robot.svg) ![A box](box.png)";
  render(<Markdown text={text} lesson="" drawings={{}} pictures={pictures} />);
  expect(screen.getByRole("img", { name: "The robot" }).getAttribute("src")).toBe(pictures["robot.svg"]);
  expect(screen.getAllByRole("img")).toHaveLength(1);
  expect(screen.getByText("A box").tagName).toBe("EM");
});
