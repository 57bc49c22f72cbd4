// @vitest-environment happy-dom

import { act, fireEvent, screen } from "@testing-library/preact";
import { expect, test, vi } from "vitest";

import { LibrariesDialog } from "../../src/features/libraries/dialog";
import { Libraries } from "../../src/features/libraries/libraries";
import type { Exportable, InstalledLibrary, LibraryRead } from "../../src/protocol/messages";
import { button, open as openDialog, press, speak, write } from "../dialog";

const DANCE = { name: "dance", version: "1.0.0", skills: ["waltz", "sway"] };

/** The dialog of a page whose server has these libraries. */
async function open(...libraries: readonly InstalledLibrary[]) {
  const opened = openDialog(LibrariesDialog, (connection) => ({
    libraries: new Libraries(connection.real),
    context: { program: { flush: vi.fn() } },
  }));
  await opened.connection.answer();
  await act(() => opened.connection.tell({ kind: "Libraries", libraries }));
  return opened;
}

/** Choose files, which the server reads. */
async function choose({ connection, libraries }: Awaited<ReturnType<typeof open>>, ...files: readonly LibraryRead[]) {
  await act(() => libraries.take(files.map(({ filename }) => new File(["zip"], filename))));
  await connection.answer();
  await act(() => connection.tell({ kind: "LibrariesRead", files }));
}

/** Open the form for a new library of a program with these functions. */
async function make({ connection }: Awaited<ReturnType<typeof open>>, functions: Exportable["functions"]) {
  await act(() => press("Create library…"));
  await connection.answer();
  await act(() => connection.tell({ kind: "Exportable", functions, own: [] }));
}

function aboutOf(field: HTMLElement): string {
  return document.getElementById(field.getAttribute("aria-describedby")!)!.textContent ?? "";
}

test("a function that can't be exported says why, and one that can what it includes", async () => {
  await make(await open(), [
    { name: "late", parameters: [], problem: { code: "uses-speed" } },
    { name: "waltz", parameters: ["times"], takes_along: ["sway"] },
  ]);
  const late = screen.getByLabelText<HTMLInputElement>("late()");
  expect([late.disabled, aboutOf(late)]).toEqual([true, "uses-speed"]);
  const waltz = screen.getByLabelText<HTMLInputElement>("waltz(times)");
  expect([waltz.disabled, aboutOf(waltz)]).toEqual([false, "includes sway"]);
});

test("a library is made of the ticked functions, from what is written last", async () => {
  const opened = await open();
  await make(opened, [{ name: "waltz", parameters: ["times"] }]);
  expect(opened.context.program.flush).toHaveBeenCalled();
  await act(() => write(screen.getByLabelText("Name"), " dance "));
  await act(() => write(screen.getByLabelText("Tab name"), "Ball room"));
  expect(button("Create and download").disabled).toBe(true);
  await act(() => void fireEvent.click(screen.getByLabelText("waltz(times)")));
  fireEvent.submit(button("Create and download").form!);
  expect(opened.connection.sent.at(-1)).toEqual({
    kind: "MakeLibrary",
    name: "dance",
    version: "1.0.0",
    title: { en: "Ball room" },
    functions: ["waltz"],
    own: [],
  });
});

test("a version that isn't newer is installed only when ticked", async () => {
  const opened = await open(DANCE);
  await choose(opened, { filename: "dance.lblib", library: DANCE, installed: "1.0.0", is_newer: false });
  screen.getByText(/^Version 1.0.0 is already installed/);
  expect(button("Import").disabled).toBe(true);
  await act(() => void fireEvent.click(screen.getByLabelText("Replace dance")));
  press("Import");
  expect(opened.connection.sent.at(-1)).toMatchObject({ kind: "ImportLibraries", replace: true });
  await act(() => opened.connection.answer());
  screen.getByText("Imported: dance.");
});

test("a file that isn't a library is reported and can be skipped", async () => {
  const opened = await open();
  const dance = { filename: "dance.lblib", library: DANCE };
  await choose(opened, dance, { filename: "none.lblib", problem: { code: "damaged" } });
  expect(screen.getByRole("alert").textContent).toContain("damaged");
  expect(button("Import").disabled).toBe(true);
  press("Skip none.lblib");
  await act(() => opened.connection.tell({ kind: "LibrariesRead", files: [dance] }));
  expect(button("Import").disabled).toBe(false);
});

test("a skill whose name is taken gets a new one, which must be free too", async () => {
  const opened = await open();
  const place = { code: "place" };
  const file = { filename: "dance.lblib", library: DANCE, clashes: [{ skill: "waltz", place }] };
  await choose(opened, file);
  const field = screen.getByLabelText<HTMLInputElement>("New name for waltz");
  expect(field.value).toBe("dance_waltz");
  write(field, "sway");
  expect(opened.connection.sent.at(-1)).toMatchObject({ files: [{ renames: { waltz: "sway" } }] });
  await act(() =>
    opened.connection.tell({ kind: "LibrariesRead", files: [{ ...file, clashes: [{ skill: "sway", place }] }] }),
  );
  expect([field.getAttribute("aria-invalid"), button("Import").disabled]).toEqual(["true", true]);
  write(field, "slow_waltz");
  await act(() => opened.connection.tell({ kind: "LibrariesRead", files: [{ ...file, clashes: [] }] }));
  expect(button("Import").disabled).toBe(false);
});

test("a library is removed after confirmation", async () => {
  const { connection } = await open(DANCE);
  await act(() => press("Remove dance"));
  expect(document.activeElement).toBe(button("Keep"));
  await act(() => press("Keep"));
  expect(connection.sent.some(({ kind }) => kind === "RemoveLibrary")).toBe(false);
  await act(() => press("Remove dance"));
  press("Remove");
  expect(connection.sent.at(-1)).toEqual({ kind: "RemoveLibrary", name: "dance" });
  await act(() => connection.tell({ kind: "Libraries", libraries: [] }));
  await act(() => connection.answer());
  screen.getByText("dance removed.");
  screen.getByText("No libraries installed yet.");
});

test("files that were not imported are forgotten when the dialog is closed", async () => {
  const opened = await open();
  await choose(opened, { filename: "dance.lblib", library: DANCE });
  await act(() => press("Close"));
  expect(opened.libraries.incoming.value).toEqual([]);
});

test("it speaks Spanish", async () => {
  await speak("es");
  const opened = await open();
  await screen.findByText("Aún no hay bibliotecas instaladas.");
  await act(() => opened.libraries.take([new File([""], "none.txt")]));
  expect(screen.getByRole("alert").textContent).toContain("none.txt");
});
