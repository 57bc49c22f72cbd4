// @vitest-environment happy-dom

import { afterEach, expect, test } from "vitest";

import { followTyping } from "../../src/ui/typing";

let stop = () => {};

afterEach(() => {
  stop();
  document.body.replaceChildren();
});

/** Show a part of a page with these elements, and follow it. */
function open(html: string): HTMLElement {
  const part = document.createElement("section");
  part.innerHTML = html;
  document.body.append(part);
  stop = followTyping(part);
  return part;
}

/** Wait until observers have reported changes. */
function changed(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}

function add(part: HTMLElement, name: string): HTMLInputElement {
  const field = Object.assign(document.createElement("input"), { name });
  part.append(field);
  return field;
}

test("the first field has the focus", () => {
  const part = open(`<button></button><input type="checkbox"><textarea></textarea><input>`);
  expect(document.activeElement).toBe(part.querySelector("textarea"));
});

test("a field that comes later has the focus", async () => {
  const field = add(open("<button></button>"), "late");
  await changed();
  expect(document.activeElement).toBe(field);
});

test.each(["button", "select"])("a %s that is chosen for the focus comes before the first field", (name) => {
  const part = open(`<${name} autofocus></${name}><textarea></textarea>`);
  expect(document.activeElement).not.toBe(part.querySelector("textarea"));
});

test("what the user does comes first", async () => {
  const part = open("<button></button>");
  part.querySelector("button")!.focus();
  part.dispatchEvent(new KeyboardEvent("keydown", { key: "Tab", bubbles: true }));
  add(part, "late");
  await changed();
  expect(document.activeElement).toBe(part.querySelector("button"));
});

test("a field that a button adds has the focus", async () => {
  const part = open(`<button></button><input name="first">`);
  const button = part.querySelector("button")!;
  button.focus();
  button.click();
  const field = add(part, "added");
  await changed();
  expect(document.activeElement).toBe(field);
});

test("a tab keeps the focus", async () => {
  const part = open(`<input><button role="tab"></button>`);
  const tab = part.querySelector("button")!;
  tab.focus();
  tab.click();
  add(part, "in the tab");
  await changed();
  expect(document.activeElement).toBe(tab);
});
