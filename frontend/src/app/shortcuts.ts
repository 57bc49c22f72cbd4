/** The actions of the page's keyboard shortcuts. */

import { t } from "../i18n";
import type { Page } from "../model/page";
import { INTO_BLOCKS, matches, SHORTCUTS, type ShortcutWord } from "../ui/shortcuts";
import { isTyped, takesKeys } from "../ui/typing";
import { nextRegion } from "../views/regions";

const ACTIONS: Readonly<Record<ShortcutWord, (page: Page) => unknown>> = {
  "page-bar-run": ({ controls }) => controls.run(),
  "page-bar-stop": ({ controls }) => controls.stop(),
  "page-bar-pause-or-resume": ({ controls }) => controls.pauseOrResume(),
  "page-bar-step": ({ controls }) => controls.step(false),
  "page-bar-step-over": ({ controls }) => controls.step(true),
  "page-settings-next-region": ({ views }) => nextRegion(views, 1),
  "page-settings-previous-region": ({ views }) => nextRegion(views, -1),
  "page-project-open": ({ dialogs }) => dialogs.show("open"),
  "page-settings-saves": saves,
  // On a block: its help.
  "page-help-title": ({ dialogs, views }) => views.explain() || dialogs.show("help"),
};

/** Those that need no open project. */
const ANYWHERE: ReadonlySet<ShortcutWord> = new Set([
  "page-settings-next-region",
  "page-settings-previous-region",
  "page-project-open",
  "page-help-title",
]);

/** Listen to the page's keys; call the result to stop. */
export function listen(page: Page): () => void {
  const pressed = (event: KeyboardEvent) => {
    const shortcut = SHORTCUTS.find((one) => matches(one, event));
    if (!shortcut || page.dialogs.open.value !== null) return;
    if (page.project.atStart.value && !ANYWHERE.has(shortcut.word)) return;
    event.preventDefault();
    event.stopPropagation();
    ACTIONS[shortcut.word](page);
  };
  const unclaimed = (event: KeyboardEvent) => {
    if (event.defaultPrevented || page.project.atStart.value || page.dialogs.open.value !== null) return;
    undoOrRedo(page, event);
    enterBlocks(page, event);
  };
  // Before the editors, where Ctrl+Enter starts a new line.
  addEventListener("keydown", pressed, { capture: true });
  addEventListener("keydown", unclaimed);
  return () => {
    removeEventListener("keydown", pressed, { capture: true });
    removeEventListener("keydown", unclaimed);
  };
}

/** Undo and redo also work outside the views; in a field they are those of its text, and a dialog has none. */
function undoOrRedo({ context: { program } }: Page, event: KeyboardEvent): void {
  if (isTyped(event.target) || !(event.ctrlKey || event.metaKey)) return;
  const key = event.key.toLowerCase();
  if (key === "z" && !event.shiftKey) program.undo();
  else if (key === "y" || key === "z") program.redo();
}

/** The keys that lead into the blocks work wherever the focus is; Blockly itself hears only those pressed inside. */
function enterBlocks({ views }: Page, event: KeyboardEvent): void {
  if (!views.shows("blocks") || takesKeys(event.target)) return;
  if (INTO_BLOCKS.some((one) => matches(one, event)) && views.pressInBlocks(event)) event.preventDefault();
}

function saves({ context: { program }, toasts }: Page): void {
  program.flush();
  toasts.note(t("page-project-saves-itself"));
}
