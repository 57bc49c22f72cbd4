/** The dialog in which a block of the user's own is written: code, words, a try, and what is wrong. */

import { effect, type Signal } from "@preact/signals";
import { render } from "preact";

import { PageContext, type Page } from "../chrome/page";
import type { Island } from "../island";
import { Editing } from "./editing";
import { Editor } from "./editor";
import "./ownblocks.css";

/**
 * @param name of the block, which follows what it is saved as; empty for a new one.
 * @param line of its source to go to, from 1; 0 for none.
 */
export function createOwnBlockEditor(page: Page, name: Signal<string>, line: number): Island {
  const dom = document.createElement("div");
  const editing = new Editing(page, name.peek(), line);
  dom.className = "own-block";
  dom.addEventListener("keydown", (event) => pressed(event, editing), { capture: true });
  dom.addEventListener("keydown", stayInCode);
  render(
    <PageContext.Provider value={page}>
      <Editor editing={editing} />
    </PageContext.Provider>,
    dom,
  );
  const unfollow = effect(() => {
    name.value = editing.draft.saved.value || name.peek();
  });
  const destroy = () => {
    unfollow();
    render(null, dom);
    editing.destroy();
  };
  return { dom, destroy };
}

/** Ctrl+S saves; the browser would save the page. */
function pressed(event: KeyboardEvent, { draft }: Editing): void {
  if (event.key.toLowerCase() !== "s" || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey) return;
  event.preventDefault();
  event.stopPropagation();
  draft.save();
}

/** Escape lets Tab leave the code, as in every text of the page; the dialog stays open. */
function stayInCode(event: KeyboardEvent): void {
  if (event.key === "Escape" && (event.target as Element).closest(".cm-editor")) event.preventDefault();
}
