/** The world editor: a plan of the world, a palette of objects, and the properties of each. */

import "./editor.css";

import type { Context } from "../../model/context";
import type { Island } from "../../ui/island";
import { Editor } from "./editor";

/** @param onClose is called when the user closes the editor. */
export function createWorldEditor(context: Context, onClose: () => void): Island {
  return new Editor(context, onClose);
}
