/** Blocks with several shapes: `extraState` defines their inputs. */

import * as Blockly from "blockly/core";
import { styleCall } from "./styles";

interface ArgumentsState {
  name?: string;
  arguments?: number;
  keywords?: string[];
}
type WithArguments = Blockly.Block & { arguments_: ArgumentsState };

/** Calls: `ARG0`..., positional arguments first, then keyword arguments. */
const ARGUMENTS = {
  saveExtraState(this: WithArguments): ArgumentsState | null {
    return this.arguments_;
  },
  loadExtraState(this: WithArguments, state: ArgumentsState): void {
    this.arguments_ = state;
    if (state.name !== undefined) setName(this, state.name);
    const { arguments: count = 0, keywords = [] } = state;
    resize(this, "ARG", count + keywords.length);
    keywords.forEach((keyword, place) => label(this, `ARG${count + place}`, `${keyword} =`));
  },
};

function setName(block: Blockly.Block, name: string): void {
  if (block.getField("NAME")) block.setFieldValue(name, "NAME");
  else block.getInput("PLACE")?.appendField(name, "NAME");
  styleCall(block, name);
}

interface ChainState {
  operators: string[];
}
type Chain = Blockly.Block & { operators_: string[] };

/** `0 < x < 10`: operands `A0`..., an operator before each but the first. */
const CHAIN = {
  saveExtraState(this: Chain): ChainState {
    return { operators: this.operators_ };
  },
  loadExtraState(this: Chain, { operators }: ChainState): void {
    this.operators_ = operators;
    resize(this, "A", operators.length + 1);
    operators.forEach((operator, place) => label(this, `A${place + 1}`, sign(operator)));
  },
};

function sign(operator: string): string {
  return { "==": "=", "!=": "≠", "<=": "≤", ">=": "≥" }[operator] ?? operator;
}

function resize(block: Blockly.Block, prefix: string, count: number): void {
  for (let place = 0; place < count; place++) {
    const name = `${prefix}${place}`;
    if (!block.getInput(name)) block.appendValueInput(name);
  }
  for (let place = count; block.getInput(`${prefix}${place}`); place++) {
    block.removeInput(`${prefix}${place}`);
  }
}

function label(block: Blockly.Block, input: string, text: string): void {
  const name = `${input}_LABEL`;
  if (block.getField(name)) block.setFieldValue(text, name);
  else block.getInput(input)?.appendField(text, name);
}

export function registerMutators(): void {
  Blockly.Extensions.registerMutator("lb_arguments_mutator", ARGUMENTS, function (this: WithArguments) {
    this.arguments_ = {};
  });
  Blockly.Extensions.registerMutator("lb_compare_mutator", CHAIN, function (this: Chain) {
    CHAIN.loadExtraState.call(this, { operators: ["<", "<"] });
  });
}
