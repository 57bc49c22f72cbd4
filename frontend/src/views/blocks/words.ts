/** The words of blocks that are not drawn. */

import * as Blockly from "blockly/core";

import type { Block, Variable } from "../../protocol/messages";
import { blocksIn } from "./folds";
import { toState } from "./read";

/** ms for which the page may read words without a pause. */
const SLICE = 20;

/** Reads blocks as their sentences, without what is inside them. */
export class Words {
  /** It draws nothing. */
  private readonly workspace = new Blockly.Workspace();
  private readonly known = new WeakMap<Block, string>();
  private timer = 0;

  destroy(): void {
    clearTimeout(this.timer);
    this.workspace.dispose();
  }

  /** The words of a block. */
  of(block: Block, variables: readonly Variable[]): string {
    const known = this.known.get(block);
    if (known !== undefined) return known;
    const words = this.read(block, variables);
    this.known.set(block, words);
    return words;
  }

  /** Whether the words of a block are known already and contain these, in small letters. */
  has(block: Block, words: string): boolean {
    return this.known.get(block)?.toLowerCase().includes(words) ?? false;
  }

  /** Read all of these blocks, a few at a time, and call a function. */
  prepare(blocks: readonly Block[], variables: readonly Variable[], done: () => void): void {
    clearTimeout(this.timer);
    const end = performance.now() + SLICE;
    const left = blocks.filter((block) => !this.known.has(block));
    const rest = left.findIndex((block) => {
      this.of(block, variables);
      return performance.now() > end;
    });
    if (rest < 0) done();
    else this.timer = window.setTimeout(() => this.prepare(left.slice(rest + 1), variables, done));
  }

  private read(block: Block, variables: readonly Variable[]): string {
    const own = withoutStacks(block);
    if ([...blocksIn([own])].some(({ type }) => !Blockly.Blocks[type])) return block.type;
    Blockly.Events.disable();
    try {
      for (const { name, id } of variables) this.name(name, id);
      const built = Blockly.serialization.blocks.append(toState(own), this.workspace);
      const words = wordsOf(built);
      built.dispose(false);
      return words;
    } finally {
      Blockly.Events.enable();
    }
  }

  private name(name: string, id: string): void {
    const map = this.workspace.getVariableMap();
    const known = map.getVariableById(id);
    if (!known) map.createVariable(name, "", id);
    else if (known.getName() !== name) known.setName(name);
  }
}

/** A block as a sentence, without the statements inside it. */
export function wordsOf(block: Blockly.Block): string {
  const rows = block.inputList.filter(({ type }) => type !== Blockly.inputs.inputTypes.STATEMENT);
  return rows.map((row) => wordsIn(row)).join(" ");
}

/** The words of a row of a block, with what is plugged into it. */
function wordsIn({ fieldRow, connection }: Blockly.Input): string {
  const plugged = connection?.targetBlock()?.toString() ?? "";
  return [...fieldRow.map((field) => field.getText()), plugged].filter(Boolean).join(" ");
}

function withoutStacks(block: Block): Block {
  const inputs = Object.entries(block.inputs ?? {}).map(([name, { stack: _, ...input }]) => [name, input]);
  return { ...block, inputs: Object.fromEntries(inputs) };
}
