/** The workspace as it travels: each chain of blocks as a list. What hangs where, by the blocks' ids. */

import type { Block, Workspace } from "../messages";

/** Where a block hangs: in an input of a block, or below it where `input` is empty. */
export interface Link {
  readonly parent: string;
  readonly input: string;
}

/** A block that is no shadow, and where it hangs; null for the first of a stack. */
export interface Node {
  readonly block: Block;
  readonly link: Link | null;
  /** Whether it stands among statements. */
  readonly statement: boolean;
}

/** Every block that is no shadow by its id, parents before children. */
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

/** Where each shadow stands, by its id. */
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
