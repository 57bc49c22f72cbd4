// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { act, fireEvent, screen } from "@testing-library/preact";
import { expect, test } from "vitest";

import { PerceptionDialog, RobotSettingsDialog } from "../../src/features/robot-settings/dialogs";
import { RobotSettings } from "../../src/features/robot-settings/robot-settings";
import { Connect } from "../../src/model/connect";
import type { Setting } from "../../src/protocol/messages";
import { button, open, press, speak, write } from "../dialog";

const ROBOTS = ["ebo", "cozmo"].map((name) => ({ name, title: name, simulated: false }));

function setting(values: Partial<Setting>): Setting {
  return { name: "port", sort: "text", value: "", default: "", allowed: { code: "" }, ...values };
}

const VOLUME = setting({ name: "volume", sort: "whole", value: 50, default: 100, least: 0, most: 100 });
const EMOTIONS = setting({ name: "emotions_on_cameras", sort: "boolean", value: false, default: false });
const WEBCAM = setting({ name: "webcam", sort: "whole", value: 1, default: "none", choices: ["none"] });

/** The dialog for robots, of which EBO is chosen in the project. */
async function openRobots(settings: readonly Setting[]) {
  const opened = open(RobotSettingsDialog, (connection) => ({
    robotSettings: new RobotSettings(connection.real),
    connect: new Connect(connection.real),
    context: { running: { robot: signal("ebo") } },
    project: { welcome: signal({ robots: ROBOTS }) },
  }));
  await act(() => opened.connection.tell({ kind: "SettingsTable", robot: "ebo", settings }));
  return opened;
}

/** The dialog for camera recognition. */
async function openPerception(settings: readonly Setting[]) {
  const opened = open(PerceptionDialog, (connection) => ({ robotSettings: new RobotSettings(connection.real) }));
  await act(() => opened.connection.tell({ kind: "SettingsTable", robot: "", settings }));
  return opened;
}

test("a value that the server refuses is reported at its field until it is another one", async () => {
  const { connection } = await openRobots([VOLUME]);
  write(screen.getByLabelText("Volume"), "500");
  press("Save");
  expect(connection.sent.at(-1)).toEqual({
    kind: "ChangeSettings",
    robot: "ebo",
    values: { volume: 500 },
    agreed: false,
  });
  const wrong = { volume: { code: "too-much" } };
  await act(() => connection.tell({ kind: "SettingsTable", robot: "ebo", settings: [VOLUME], wrong }));
  const field = screen.getByLabelText<HTMLInputElement>("Volume");
  expect([field.value, field.getAttribute("aria-invalid")]).toEqual(["500", "true"]);
  screen.getByText("too-much");
});

test("a saved value can be reset to the default", async () => {
  const { connection } = await openRobots([VOLUME]);
  await act(() => press("Default"));
  press("Save");
  expect(connection.sent.at(-1)).toMatchObject({ values: { volume: 100 } });
  await act(() => connection.tell({ kind: "SettingsTable", robot: "ebo", settings: [{ ...VOLUME, value: 100 }] }));
  screen.getByText("Saved");
});

test("the settings of another robot are asked for when it is chosen", async () => {
  const { connection } = await openRobots([VOLUME]);
  await act(() => void fireEvent.change(screen.getByLabelText("Robot"), { target: { value: "cozmo" } }));
  expect(connection.sent.at(-1)).toEqual({ kind: "ReadSettings", robot: "cozmo" });
  expect(screen.queryByLabelText("Volume")).toBeNull();
});

test("only saved settings can be tested, since programs use these", async () => {
  await openRobots([VOLUME]);
  expect(button("Test").disabled).toBe(false);
  await act(() => write(screen.getByLabelText("Volume"), "60"));
  expect(button("Test").disabled).toBe(true);
});

test("emotions on cameras are switched on only after agreement", async () => {
  const { connection } = await openPerception([EMOTIONS]);
  expect(screen.getByText(/Article 5\(1\)\(f\)/)).toBeDefined();
  await act(() => void fireEvent.click(screen.getByLabelText("Recognise emotions on real cameras")));
  expect(button("Save").disabled).toBe(true);
  await act(() => void fireEvent.click(screen.getByLabelText(/^I am an adult/)));
  press("Save");
  expect(connection.sent.at(-1)).toMatchObject({ values: { emotions_on_cameras: true }, agreed: true });
});

test("an emptied number field means the setting's word for none", async () => {
  const { connection } = await openPerception([WEBCAM]);
  await act(() => write(screen.getByLabelText("Webcam"), ""));
  press("Save");
  expect(connection.sent.at(-1)).toMatchObject({ values: { webcam: "none" } });
});

test("what is typed in the moment in which a field appears is kept", async () => {
  const { connection } = open(PerceptionDialog, (connection) => ({
    robotSettings: new RobotSettings(connection.real),
  }));
  const typed = new Promise<void>((resolve) => {
    new MutationObserver((_, watcher) => {
      const field = screen.queryByLabelText("Video");
      if (!field) return;
      watcher.disconnect();
      write(field, "walk.avi");
      resolve();
    }).observe(document, { subtree: true, childList: true });
  });
  connection.tell({ kind: "SettingsTable", robot: "", settings: [setting({ name: "video" }), WEBCAM] });
  await typed;
  await act(() => write(screen.getByLabelText("Webcam"), "2"));
  press("Save");
  expect(connection.sent.at(-1)).toMatchObject({ values: { video: "walk.avi", webcam: 2 } });
});

test("it speaks Spanish", async () => {
  await speak("es");
  await openRobots([VOLUME]);
  await screen.findByLabelText("Volumen");
});
