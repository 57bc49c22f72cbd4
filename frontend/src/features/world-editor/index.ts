/** The world editor: the world in 3D or as a plan, a palette of objects, and the properties of each. */

import "./editor.css";

import type { Context } from "../../model/context";
import type { Island } from "../../ui/island";
import { WorldEditor } from "./editor";

/**
 * @param freeTitle returns a title for a copy of a built-in world that no world has yet.
 * @param leave is called with the title of the world that was saved.
 * @param first the world that is edited; empty for the one that is used.
 */
export function createWorldEditor(
  context: Context,
  freeTitle: (name: string) => string,
  leave: (title: string) => void,
  first = "",
): Island {
  return new WorldEditor(context, freeTitle, leave, first);
}
