// @vitest-environment happy-dom

import { signal } from "@preact/signals";
import { act, fireEvent, screen, waitFor } from "@testing-library/preact";
import { expect, test } from "vitest";

import { Containment } from "../../src/features/containment/containment";
import { ContainmentDialog } from "../../src/features/containment/dialog";
import { Toasts } from "../../src/ui/toasts";
import { open as openDialog, speak } from "../dialog";

/** The dialog of a page with the project "weather". */
function open() {
  return openDialog(ContainmentDialog, (connection) => ({
    containment: new Containment(connection.real, new Toasts(), () => {}),
    project: { name: signal("weather") },
  }));
}

/** The box that allows the project the network, once the server has said what holds. */
async function networkBox(): Promise<HTMLInputElement> {
  return await screen.findByRole("checkbox");
}

test("each attempt is listed with its result and the reason", async () => {
  const { connection } = open();
  const read = { name: { code: "doctor-read" }, contained: true, reason: { code: "doctor-by-seccomp" } };
  connection.tell({
    kind: "Containment",
    findings: [read, { ...read, name: { code: "doctor-run" }, contained: false }],
  });
  await screen.findByText("Refused");
  screen.getByText("Allowed");
  expect(screen.getAllByRole("row")).toHaveLength(3);
});

test("a change is asked for with the key that the server gave, and is shown once it holds", async () => {
  const { connection } = open();
  connection.tell({ kind: "Network", allowed: false, key: "k" });
  fireEvent.click(await networkBox());
  expect(connection.sent.at(-1)).toEqual({ kind: "AllowNetwork", allowed: true, key: "k" });
  await act(() => connection.tell({ kind: "Network", allowed: true, key: "k" }));
  expect((await networkBox()).checked).toBe(true);
});

test("a refused change is explained and not shown as made", async () => {
  const { connection } = open();
  await connection.answer();
  connection.tell({ kind: "Network", allowed: false, key: "k" });
  const box = await networkBox();
  fireEvent.click(box);
  await act(() => connection.refuse("settings-line"));
  await waitFor(() => expect(screen.getByRole("alert").textContent).toBe("settings-line"));
  expect(box.checked).toBe(false);
});

test("a page that may not change it sees the setting, and why", async () => {
  const { connection } = open();
  connection.tell({ kind: "Network", allowed: true, reason: { code: "not-here" } });
  const box = await networkBox();
  expect([box.checked, box.disabled]).toEqual([true, true]);
  screen.getByText("not-here");
});

test("it speaks Spanish", async () => {
  await speak("es");
  const { connection } = open();
  connection.tell({ kind: "Network", allowed: false, key: "k" });
  await screen.findByText("Qué pueden hacer los programas");
  await screen.findByText(/pueden usar la red/);
});
