// @vitest-environment happy-dom
/** The examples in a lesson's text and in the docs can be opened as projects, and are drawn as blocks in the help. */

import { cleanup, fireEvent, render, screen } from "@testing-library/preact";
import { afterEach, expect, test, vi } from "vitest";

import { blocksOf } from "../../src/features/help/blocks-of";
import { Markdown } from "../../src/features/lessons/markdown";
import type { Workspace } from "../../src/protocol/messages";
import { button } from "../dialog";

// Blockly draws in a browser only.
vi.mock("../../src/features/lessons/drawn-blocks", () => ({
  DrawnBlocks: ({ workspace }: { workspace: Workspace }) => <i data-testid="drawing">{JSON.stringify(workspace)}</i>,
}));

afterEach(() => {
  cleanup();
  vi.unstubAllGlobals();
});

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

test("an example in the help has its blocks before its text", async () => {
  const workspace = { stacks: [], variables: [] };
  const asked: string[] = [];
  const answer = async (address: string) => {
    asked.push(new URL(address, "http://page/").searchParams.get("text") ?? "");
    return Response.json(workspace);
  };
  vi.stubGlobal("fetch", answer);
  render(<Markdown text={fenced("blocktext turn.bt", PROGRAM)} lesson="" drawings={{}} blocksOf={blocksOf} />);
  const drawing = await screen.findByTestId("drawing");
  expect(JSON.parse(drawing.textContent ?? "")).toEqual(workspace);
  expect(asked).toEqual([PROGRAM]);
  const text = document.querySelector("pre")!;
  expect(drawing.compareDocumentPosition(text) & Node.DOCUMENT_POSITION_FOLLOWING).toBeTruthy();
});

test.each([
  ["a text with a mistake", () => Promise.resolve(new Response(null, { status: 404 }))],
  ["a server that is away", () => Promise.reject(new TypeError("Failed to fetch"))],
])("%s leaves an example as text", async (_, answer) => {
  vi.stubGlobal("fetch", answer);
  vi.spyOn(console, "warn").mockReturnValue();
  expect(await blocksOf(PROGRAM)).toBeNull();
  render(<Markdown text={fenced("blocktext", PROGRAM)} lesson="" drawings={{}} blocksOf={async () => null} />);
  expect(document.querySelector("pre")?.textContent).toBe(PROGRAM);
  expect(screen.queryByTestId("drawing")).toBeNull();
});

test("other code is not drawn", () => {
  const ask = vi.fn();
  render(<Markdown text={fenced("python", PROGRAM)} lesson="" drawings={{}} blocksOf={ask} />);
  expect(ask).not.toHaveBeenCalled();
});

test("without a server a picture is one of those that are given, or its words", () => {
  const pictures = { "robot.svg": "data:image/svg+xml;base64,AA==" };
  const text = "![The robot](pictures/robot.svg) ![A box](box.png)";
  render(<Markdown text={text} lesson="" drawings={{}} pictures={pictures} />);
  expect(screen.getByRole("img", { name: "The robot" }).getAttribute("src")).toBe(pictures["robot.svg"]);
  expect(screen.getAllByRole("img")).toHaveLength(1);
  expect(screen.getByText("A box").tagName).toBe("EM");
});
