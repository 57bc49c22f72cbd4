// @vitest-environment happy-dom

import { cleanup, fireEvent, render, screen, within } from "@testing-library/preact";
import { afterEach, beforeAll, beforeEach, expect, test, vi } from "vitest";

import { HandInTable } from "../../src/features/hand-ins/list";
import { ShownWork } from "../../src/features/hand-ins/shown";
import { HandInStream } from "../../src/features/hand-ins/stream";
import type { FromTeacher, HandInLine, ShownHandIn } from "../../src/protocol/classroom";
import { button } from "../dialog";
import { emptyWorld } from "../worlds";

// Blockly draws in a browser only.
vi.mock("../../src/features/lessons/drawn-blocks", () => ({
  DrawnBlocks: ({ marked, pick }: { marked: string | null; pick?: (block: string) => void }) => (
    <button type="button" data-testid="drawing" data-marked={marked ?? ""} onClick={() => pick?.("r")} />
  ),
}));

const PROGRAM = "main:\n    repeat 3:\n        function.turn(90)\n    end\nend\n";
const PLACE = { lesson: "1-03-square", step: 4 };
const LINE: HandInLine = { pupil: "a", name: "Mateo", state: "marked", at: 1, note: "Count them.", mark: "8 of 10" };
const SHOWN: ShownHandIn = {
  kind: "ShownHandIn",
  ...PLACE,
  line: LINE,
  program: { text: PROGRAM },
  blocktext: PROGRAM,
  world: null,
};

class Played extends HandInStream {
  readonly sent: FromTeacher[] = [];

  override send(message: FromTeacher): boolean {
    this.sent.push(message);
    return true;
  }
}

let stream: Played;

beforeAll(() => {
  // happy-dom has no dialogs.
  HTMLDialogElement.prototype.showModal ??= () => {};
});

beforeEach(() => {
  stream = new Played();
  stream.place.value = PLACE;
});

afterEach(cleanup);

function show(line: Partial<HandInLine> = {}, more: Partial<ShownHandIn> = {}): void {
  stream.pupil.value = "a";
  stream.shown.value = { ...SHOWN, line: { ...LINE, ...line }, ...more };
  render(<ShownWork stream={stream} />);
}

test("what is shown to the class has the program, and neither name nor note nor mark", () => {
  show();
  fireEvent.click(button("Show without name"));
  const dialog = screen.getByRole("dialog");
  expect(dialog.textContent).toContain("repeat 3:");
  expect(document.body.innerHTML).toContain("Mateo");
  expect(dialog.outerHTML).not.toContain("Mateo");
  for (const own of ["Count them.", "8 of 10"]) {
    screen.getByDisplayValue(own);
    expect(within(dialog).queryByDisplayValue(own)).toBeNull();
    expect(dialog.outerHTML).not.toContain(own);
  }
});

test("a note is tied to a line with the keyboard, and to the whole program again", () => {
  show();
  const about = screen.getByLabelText<HTMLSelectElement>("About");
  fireEvent.change(about, { target: { value: "2" } });
  const sent = { kind: "MarkHandIn", pupil: "a", note: "Count them.", mark: "8 of 10", ...PLACE };
  expect(stream.sent.at(-1)).toEqual({ ...sent, line: { number: 2, text: "repeat 3:" } });
});

test("a line without a note changes nothing that was handed back", () => {
  show({ state: "handed back", note: "", mark: "8" });
  fireEvent.change(screen.getByLabelText("About"), { target: { value: "2" } });
  expect(stream.sent).toEqual([]);
});

test("the line of a note that the program lacks now is still named", () => {
  show({ line: { number: 2, text: "while true:" } });
  const about = screen.getByLabelText<HTMLSelectElement>("About");
  expect(about.selectedOptions[0]?.textContent).toBe("while true: (not in this program)");
  expect(stream.sent).toEqual([]);
});

test("the run is loaded when it is asked for, and then for each hand-in", () => {
  show({}, { world: { ...emptyWorld() } });
  expect(document.querySelector("iframe")).toBeNull();
  fireEvent.click(button("Show the run"));
  const address = document.querySelector("iframe")?.getAttribute("src");
  expect(address).toBe("p/hand-ins/?pupil=a&lesson=1-03-square&step=4");
  fireEvent.click(button("From above"));
  expect(document.querySelector("iframe")).toBeNull();
});

function drawn(): void {
  show({}, { world: emptyWorld() as never, blocks: { stacks: [], variables: [] }, lines: { m: 1, r: 2, t: 3 } });
}

function marked(): string | undefined {
  return screen.getByTestId("drawing").dataset.marked;
}

test("a click on a block ties the note to its line, and marks it", () => {
  drawn();
  fireEvent.click(screen.getByTestId("drawing"));
  expect(stream.sent.at(-1)).toMatchObject({ line: { number: 2, text: "repeat 3:" } });
  expect(marked()).toBe("r");
});

test("the block that an answer about the run names is marked, until another one is chosen", () => {
  drawn();
  fireEvent.click(button("Show the run"));
  const frame = document.querySelector("iframe")!;
  Object.defineProperty(frame, "contentWindow", { value: window });
  const say = (source: Window | null, data: unknown) =>
    fireEvent(window, new MessageEvent("message", { data, source }));
  say(null, { showLine: 3 });
  say(window, "nonsense");
  say(window, null);
  expect(marked()).toBe("");
  say(window, { showLine: 3 });
  expect(marked()).toBe("t");
  fireEvent.change(screen.getByLabelText("About"), { target: { value: "1" } });
  expect(marked()).toBe("m");
});

test("Enter in the list goes to the note, and Escape from there back to the list", () => {
  stream.list.value = {
    kind: "HandInList",
    ...PLACE,
    title: "Square",
    step_title: "Bigger",
    starts: 4,
    lines: [LINE, { ...LINE, pupil: "b", name: "Ana" }],
  };
  stream.staysInList = true;
  show();
  render(<HandInTable stream={stream} />);
  const rows = ["Mateo", "Ana"].map((name) => screen.getByRole("button", { name: new RegExp(`^${name}`) }));
  expect(rows.map((row) => row.tabIndex)).toEqual([0, -1]);
  fireEvent.click(rows[0]!);
  const note = screen.getByLabelText(/Note to/);
  expect(document.activeElement).toBe(note);
  fireEvent.keyDown(note, { key: "Escape" });
  expect(document.activeElement).toBe(rows[0]);
  fireEvent.keyDown(rows[0]!, { key: "End" });
  expect(stream.pupil.value).toBe("b");
});
