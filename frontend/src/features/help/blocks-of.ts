/** The blocks of the examples in the docs. */

import type { Workspace } from "../../protocol/messages";

/** The blocks of a Block-Text; null if it has a mistake, or if the server is away. */
export async function blocksOf(text: string): Promise<Workspace | null> {
  try {
    const response = await fetch(`drawn.json?text=${encodeURIComponent(text)}`);
    return response.ok ? ((await response.json()) as Workspace) : null;
  } catch (error) {
    console.warn(error);
    return null;
  }
}
