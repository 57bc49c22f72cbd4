/** What the server knows of a block's example: a small program that ran in a small world. */

import type { Workspace } from "../../protocol/messages";
import type { WorldValues } from "../world/scenery/description";

export interface BlockHelp {
  /** Block-Text. */
  readonly program: string;
  readonly robot: string;
  readonly world: WorldValues;
  readonly workspace: Workspace;
  /** Seconds, x and y in mm, and the heading in degrees; between two places the robot went evenly. */
  readonly way: readonly (readonly [number, number, number, number])[];
  /** Seconds, a kind, and a text: of a line that ran, the id of its block. */
  readonly events: readonly (readonly [number, string, string])[];
}

const known = new Map<string, Promise<BlockHelp | null>>();

/** The example of a block, by its name in block sets; null if it has none, or if the server is away. */
export function blockHelp(name: string): Promise<BlockHelp | null> {
  const asked = known.get(name) ?? fetched(name);
  known.set(name, asked);
  return asked;
}

async function fetched(name: string): Promise<BlockHelp | null> {
  try {
    const response = await fetch(`help/${encodeURIComponent(name)}.json`);
    if (response.ok) return (await response.json()) as BlockHelp;
    if (response.status === 404) return null;
  } catch (error) {
    console.warn(error);
  }
  known.delete(name);
  return null;
}
