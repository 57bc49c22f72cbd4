/** The editor of a custom block: code, words, test run and problems. */

import { effect, type Signal } from "@preact/signals";
import { render } from "preact";

import { type Page, PageProvider } from "../../model/page";
import type { Island } from "../../ui/island";
import { Editing } from "./editing";
import { CustomBlockEditor } from "./editor";
import "./editor.css";

/**
 * @param name The block's name, updated when the block is renamed; empty for a new block.
 * @param line The line of its source to show, from 1; 0 for none.
 */
export function createCustomBlockEditor(page: Page, name: Signal<string>, line: number): Island {
  const dom = document.createElement("div");
  const editing = new Editing(page.customBlocks, page.context, name.peek(), line);
  dom.className = "custom-block";
  dom.addEventListener("keydown", (event) => pressed(event, editing), { capture: true });
  dom.addEventListener("keydown", stayInCode);
  render(
    <PageProvider value={page}>
      <CustomBlockEditor editing={editing} />
    </PageProvider>,
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

/** Ctrl+S saves the block instead of the page. */
function pressed(event: KeyboardEvent, { draft }: Editing): void {
  if (event.key.toLowerCase() !== "s" || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey) return;
  event.preventDefault();
  event.stopPropagation();
  draft.save();
}

/** Escape lets Tab leave the code, as in every text editor of the page; the dialog stays open. */
function stayInCode(event: KeyboardEvent): void {
  if (event.key === "Escape" && (event.target as Element).closest(".cm-editor")) event.preventDefault();
}
