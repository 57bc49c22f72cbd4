/** The workspace as it is sent, with each chain of blocks as a list: its blocks by id. */

import type { Block, Workspace } from "../../protocol/messages";

/** The parent of a block: in an input of it, or below it if `input` is empty. */
export interface Link {
  readonly parent: string;
  readonly input: string;
}

/** A block that is not a shadow, and its parent; null for the first of a stack. */
export interface Node {
  readonly block: Block;
  readonly link: Link | null;
  /** Whether it is a statement. */
  readonly statement: boolean;
}

// Why: docs/decisions.md, "A workspace travels flat"
/** All blocks except shadows by id, parents before children. */
export function index(workspace: Workspace): Map<string, Node> {
  const found = new Map<string, Node>();
  for (const stack of workspace.stacks) addChain(stack, null, found);
  return found;
}

function addChain(chain: readonly Block[], first: Link | null, found: Map<string, Node>): void {
  let link = first;
  for (const block of chain) {
    addBlock({ block, link, statement: true }, found);
    link = { parent: block.id, input: "" };
  }
}

function addBlock(node: Node, found: Map<string, Node>): void {
  found.set(node.block.id, node);
  for (const [name, input] of Object.entries(node.block.inputs ?? {})) {
    const link = { parent: node.block.id, input: name };
    if (input.block) addBlock({ block: input.block, link, statement: false }, found);
    if (input.stack) addChain(input.stack, link, found);
  }
}

/** The parent of each shadow, by the shadow's id. */
export function shadowLinks(nodes: ReadonlyMap<string, Node>): Map<string, Link> {
  const found = new Map<string, Link>();
  for (const { block } of nodes.values()) {
    for (const [input, { shadow }] of Object.entries(block.inputs ?? {})) {
      if (shadow) found.set(shadow.id, { parent: block.id, input });
    }
  }
  return found;
}

/** The shadow in an input, if there is one. */
export function shadowOf(block: Block | undefined, input: string): Block | null {
  return block?.inputs?.[input]?.shadow ?? null;
}
