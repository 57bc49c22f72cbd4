/** Splits a large program into what is shown at once and the stacks that are added afterwards. */

import type { Block, Workspace } from "../../protocol/messages";
import type { Node } from "./flat";
import { index, shadowLinks } from "./flat";

export type Stack = Workspace["stacks"][number];

/** Up to this many new blocks are shown at once. */
export const AT_ONCE = 200;

interface Slices {
  readonly now: Workspace;
  /** The stacks to add; those without a position, which go below all others, are last. */
  readonly later: readonly Stack[];
}

/** What to show at once, and later, of a program; `shown` are the blocks that exist. */
export function slices(shown: ReadonlyMap<string, Node>, wanted: Workspace): Slices {
  const added = wanted.stacks.filter(([first]) => !shown.has(first!.id));
  const known = added.length ? new Set([...shown.keys(), ...shadowLinks(shown).keys()]) : new Set<string>();
  const ids = new Map(added.map((stack) => [stack, idsOf(stack)]));
  const later = added.filter((stack) => !ids.get(stack)!.some((id) => known.has(id)));
  const count = later.reduce((sum, stack) => sum + ids.get(stack)!.length, 0);
  if (count <= AT_ONCE) return { now: wanted, later: [] };
  const waiting = new Set(later);
  return {
    now: { ...wanted, stacks: wanted.stacks.filter((stack) => !waiting.has(stack)) },
    later: [...later.filter(isPlaced), ...later.filter((stack) => !isPlaced(stack))],
  };
}

/** Whether a stack has a position. */
export function isPlaced([first]: readonly Block[]): boolean {
  return first?.x != null && first.y != null;
}

function idsOf(stack: Stack): string[] {
  const nodes = index({ stacks: [stack], variables: [] });
  return [...nodes.keys(), ...shadowLinks(nodes).keys()];
}
