// @vitest-environment happy-dom

import { act, screen } from "@testing-library/preact";
import { expect, test, vi } from "vitest";

import { NewRobotDialog } from "../../src/features/new-robot/dialog";
import { RobotMaker } from "../../src/features/new-robot/robot-maker";
import { open as openDialog, press, pressEscape, speak, write } from "../dialog";

const TEMPLATE = "[wheels]\nradius = 33\n";
const WRONG = "[wheels]\nradius = -1\n";

/** The dialog after the server has sent its template. */
async function open() {
  const opened = openDialog(NewRobotDialog, (connection) => ({
    robotMaker: new RobotMaker(connection.real),
    controls: { chooseRobot: vi.fn() },
  }));
  await opened.connection.answer({ kind: "RobotBegun", description: TEMPLATE });
  await act(() => opened.connection.tell({ kind: "RobotBegun", description: TEMPLATE }));
  return opened;
}

function description(): HTMLTextAreaElement {
  return screen.getByLabelText<HTMLTextAreaElement>(/^(Description|Descripción)/);
}

function selected({ value, selectionStart, selectionEnd }: HTMLTextAreaElement): string {
  return value.slice(selectionStart, selectionEnd);
}

test("a mistake in a description is reported at its line", async () => {
  const { connection } = await open();
  write(description(), WRONG);
  write(screen.getByLabelText(/^Name/), " rover ");
  press("Create robot");
  expect(connection.sent.at(-1)).toEqual({ kind: "MakeRobot", name: "rover", description: WRONG });
  const problems = [{ message: { code: "wheels.radius" }, line: 2 }];
  await act(() => connection.tell({ kind: "RobotMade", problems }));
  expect(screen.getByRole("alert").textContent).toContain("wheels.radius");
  press("Line 2");
  expect(document.activeElement).toBe(description());
  expect(selected(description())).toBe("radius = -1");
});

test("the text is kept after Escape", async () => {
  const { connection, isOpen } = await open();
  await act(() => write(description(), WRONG));
  await act(pressEscape);
  expect(isOpen.value).toBe(false);
  await act(() => {
    isOpen.value = true;
  });
  expect(description().value).toBe(WRONG);
  expect(connection.sent.map(({ kind }) => kind)).toEqual(["BeginRobot"]);
});

test("a name that the server refuses is reported", async () => {
  const { connection } = await open();
  write(screen.getByLabelText(/^Name/), "cozmo");
  press("Create robot");
  await act(() => connection.refuse("robot-taken"));
  expect(screen.getByRole("alert").textContent).toBe("robot-taken");
});

test("a robot that was made can be used, and the next one starts anew", async () => {
  const { connection, controls, robotMaker, isOpen } = await open();
  write(screen.getByLabelText(/^Name/), "rover");
  press("Create robot");
  await act(() => connection.tell({ kind: "RobotMade", name: "rover", files: ["sim_rover.py"] }));
  screen.getByText("sim_rover.py");
  expect(document.activeElement?.textContent).toBe("Use the twin");
  press("Use the twin");
  expect(controls.chooseRobot).toHaveBeenCalledWith("sim-rover");
  expect(isOpen.value).toBe(false);
  expect([robotMaker.name.value, robotMaker.description.value]).toEqual(["", ""]);
});

test("it speaks Spanish", async () => {
  await speak("es");
  await open();
  await screen.findByText("Robot nuevo");
  expect(description().value).toBe(TEMPLATE);
});
