/** Blocks with several shapes: `extraState` defines their inputs. */

import * as Blockly from "blockly/core";

import { registerPython } from "./python-mutator";
import { stepButton } from "./step-button";
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
    const { name, arguments: count = 0, keywords = [] } = state;
    const [words, ...between] = keywords.length ? [] : sentenceOf(name, count);
    if (name !== undefined) setName(this, name, words ?? name);
    resize(this, "ARG", count + keywords.length);
    between.forEach((text, place) => label(this, `ARG${place + 1}`, text));
    keywords.forEach((keyword, place) => label(this, `ARG${count + place}`, `${keyword} =`));
  },
};

/** The words before each value of a call of Python's that has a sentence; none for any other. */
function sentenceOf(name = "", count: number): string[] {
  const sentence = Blockly.Msg[`LB_CALL_${name.toUpperCase()}_${count}`];
  return sentence
    ? sentence
        .split(/%\d/)
        .slice(0, count)
        .map((words) => words.trim())
    : [];
}

function setName(block: Blockly.Block, name: string, words: string): void {
  if (block.getField("NAME")) block.setFieldValue(words, "NAME");
  else block.getInput("PLACE")?.appendField(words, "NAME");
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

interface DictionaryState {
  items: number;
}
type Dictionary = Blockly.Block & { items_: number };

/** Dictionaries: the inputs `KEY0`, `VALUE0`, `KEY1`..., a row for each entry. */
const DICTIONARY = {
  saveExtraState(this: Dictionary): DictionaryState {
    return { items: this.items_ };
  },
  loadExtraState(this: Dictionary, { items }: DictionaryState): void {
    this.items_ = items;
    for (let place = 0; place < items; place++) addEntry(this, place);
    for (let place = items; this.getInput(`KEY${place}`); place++) {
      for (const part of ["KEY", "VALUE", "ROW"]) this.removeInput(`${part}${place}`);
    }
  },
};

function addEntry(block: Blockly.Block, place: number): void {
  if (block.getInput(`KEY${place}`)) return;
  block.appendEndRowInput(`ROW${place}`);
  block.appendValueInput(`KEY${place}`);
  block.appendValueInput(`VALUE${place}`).appendField(":");
}

function addStepButtons(block: Dictionary): void {
  const step = (by: number) => () => DICTIONARY.loadExtraState.call(block, { items: Math.max(0, block.items_ + by) });
  block
    .getInput("PLACE")
    ?.appendField(stepButton("+", Blockly.Msg.LB_DICTIONARY_ADD ?? "", step(1)), "ADD")
    .appendField(stepButton("−", Blockly.Msg.LB_DICTIONARY_REMOVE_LAST ?? "", step(-1)), "REMOVE");
}

interface UnpackingState {
  variables: number;
}
type Unpacking = Blockly.Block & { variables_: number };

const FEWEST_VARIABLES = 2;
/** What a variable is called that the user adds. */
const NEW_VARIABLE = "z";

/** Loops that take values apart: the fields `VAR`, `VAR1`..., a comma before each but the first. */
const UNPACKING = {
  saveExtraState(this: Unpacking): UnpackingState {
    return { variables: this.variables_ };
  },
  loadExtraState(this: Unpacking, { variables }: UnpackingState): void {
    this.variables_ = Math.max(FEWEST_VARIABLES, variables);
    const input = this.getInput("PLACE");
    for (let place = 0; place < this.variables_; place++) {
      if (!input || this.getField(variableField(place))) continue;
      if (place > 0) input.appendField(",", `COMMA${place}`);
      input.appendField(new Blockly.FieldVariable(NEW_VARIABLE), variableField(place));
    }
    for (let place = this.variables_; this.getField(variableField(place)); place++) {
      input?.removeField(`COMMA${place}`);
      input?.removeField(variableField(place));
    }
  },
};

function variableField(place: number): string {
  return place === 0 ? "VAR" : `VAR${place}`;
}

function addVariableButtons(block: Unpacking): void {
  const step = (by: number) => () => UNPACKING.loadExtraState.call(block, { variables: block.variables_ + by });
  block
    .getInput("PLACE")
    ?.appendField(stepButton("+", Blockly.Msg.LB_UNPACKING_ADD ?? "", step(1)), "ADD")
    .appendField(stepButton("−", Blockly.Msg.LB_UNPACKING_REMOVE_LAST ?? "", step(-1)), "REMOVE");
}

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

/** Blockly's own extension unplugs values whose type it does not expect, such as text added to text. */
function keepValuesOfConditionals(): void {
  Blockly.Extensions.unregister("logic_ternary");
  Blockly.Extensions.register("logic_ternary", () => {});
}

export function registerMutators(): void {
  keepValuesOfConditionals();
  Blockly.Extensions.registerMutator("lb_arguments_mutator", ARGUMENTS, function (this: WithArguments) {
    this.arguments_ = {};
  });
  registerPython();
  Blockly.Extensions.registerMutator("lb_compare_mutator", CHAIN, function (this: Chain) {
    CHAIN.loadExtraState.call(this, { operators: ["<", "<"] });
  });
  Blockly.Extensions.registerMutator("lb_dictionary_mutator", DICTIONARY, function (this: Dictionary) {
    addStepButtons(this);
    DICTIONARY.loadExtraState.call(this, { items: 0 });
  });
  Blockly.Extensions.registerMutator("lb_unpacking_mutator", UNPACKING, function (this: Unpacking) {
    addVariableButtons(this);
    UNPACKING.loadExtraState.call(this, { variables: FEWEST_VARIABLES });
  });
}
