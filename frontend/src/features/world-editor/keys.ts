/** The editor's keys. */

import type { Board } from "./board";
import { type Commands, LARGER, TURN } from "./commands";
import type { WorldEdit } from "./world-edit";

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
/** Comma and full stop turn too: brackets are hard to reach on some keyboards. */
const TURNS: Readonly<Record<string, number>> = { "[": -TURN, "]": TURN, ",": -TURN, ".": TURN, "{": -1, "}": 1 };
const COARSE = 100;
const FINE = 1;

export function editorKeys(draft: WorldEdit, commands: Commands, board: Board): (event: KeyboardEvent) => void {
  return (event) => {
    if (!undoing(event, draft) && !(board.focusedThing && onThing(event, draft, commands, board))) return;
    event.preventDefault();
    event.stopPropagation();
  };
}

function undoing(event: KeyboardEvent, draft: WorldEdit): boolean {
  // In a text field, undo belongs to the browser.
  if (event.target instanceof HTMLInputElement || !(event.ctrlKey || event.metaKey)) return false;
  const letter = event.key.toLowerCase();
  if (letter === "y" || (letter === "z" && event.shiftKey)) draft.redo();
  else if (letter === "z") draft.undo();
  else return false;
  return true;
}

function onThing(event: KeyboardEvent, draft: WorldEdit, commands: Commands, board: Board): boolean {
  const arrow = ARROWS[event.key];
  const turn = TURNS[event.key];
  if (arrow) commands.nudge(...arrow, event.shiftKey ? COARSE : event.altKey ? FINE : undefined);
  else if (turn) commands.turn(turn);
  else if (event.key === "+" || event.key === "-") commands.enlarge(event.key === "+" ? LARGER : 1 / LARGER);
  else if (event.key === "Delete" || event.key === "Backspace") commands.remove();
  else if (event.key.toLowerCase() === "d" && (event.ctrlKey || event.metaKey)) {
    const copy = commands.duplicate();
    if (copy) board.focus(copy);
  } else if (event.key === "Escape" && draft.selected.peek()) draft.select(null);
  else return false;
  return true;
}
