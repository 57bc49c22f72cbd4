/** The world editor: a plan of the world, a palette of objects, and the properties of each. */

import "./editor.css";

import type { Context } from "../../model/context";
import type { Island } from "../../ui/island";
import { WorldEditor } from "./editor";

/** @param freeTitle returns a title for a copy of a built-in world that no world has yet. */
export function createWorldEditor(context: Context, freeTitle: (name: string) => string): Island {
  return new WorldEditor(context, freeTitle);
}
