/** The world editor: a plan of the world, what can be put into it, and what each thing says. */

import "./editor.css";

import { Editor } from "./editor";
import type { Context } from "../../context";
import type { Island } from "../../island";

export type WorldEditorIsland = Island;

/** @param onClose is called when the user has done with it. */
export function createWorldEditor(context: Context, onClose: () => void): WorldEditorIsland {
  return new Editor(context, onClose);
}
