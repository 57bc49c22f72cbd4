/** Dialogs of a page whose server is the test; each must leave nothing behind when it is closed. */

import { signal } from "@preact/signals";
import { cleanup, configure, fireEvent, render, screen, waitFor } from "@testing-library/preact";
import type { ComponentType } from "preact";
import { afterEach, beforeAll, expect } from "vitest";

import { language, startLanguage } from "../src/i18n";
import { type Page, PageProvider } from "../src/model/page";
import { Toasts } from "../src/ui/toasts";
import { FakeConnection } from "./fake-connection";

// A busy computer takes longer for what is awaited, which is no failure.
configure({ asyncUtilTimeout: 30_000 });

const preferred = signal("en");
let ends: (() => void)[] = [];

beforeAll(() => startLanguage(preferred));

afterEach(async () => {
  cleanup();
  for (const end of ends) end();
  ends = [];
  await speak("en");
});

/** Change the language of the page, until the end of the test. */
export async function speak(code: string): Promise<void> {
  preferred.value = code;
  await waitFor(() => expect(language.value).toBe(code));
}

/**
 * Open a dialog.
 *
 * `make` makes what the dialog uses of the page, beside its toasts and dialogs; they listen to the server from now on.
 */
export function open<Parts extends object>(Content: ComponentType, make: (connection: FakeConnection) => Parts) {
  const connection = new FakeConnection();
  const toasts = new Toasts();
  const parts = make(connection);
  const before = connection.listening;
  const isOpen = signal(true);
  const close = () => (isOpen.value = false);
  const page = { toasts, dialogs: { close }, ...parts } as unknown as Page;
  const App = () => <PageProvider value={page}>{isOpen.value && <Content />}</PageProvider>;
  render(<App />);
  ends.push(() => expect(connection.listening).toBe(before));
  return { connection, toasts, isOpen, ...parts };
}

export function write(field: Element, value: string): void {
  fireEvent.input(field, { target: { value } });
}

export function button(name: string | RegExp): HTMLButtonElement {
  return screen.getByRole("button", { name });
}

/** Press a button of the dialog. */
export function press(name: string | RegExp): void {
  fireEvent.click(button(name));
}

/** Press Escape. */
export function pressEscape(): void {
  fireEvent(screen.getByRole("dialog"), new Event("cancel"));
}
