/** The definitions of own blocks and their calls, drawn without Blockly's gear, and with what their inputs begin with. */

import * as Blockly from "blockly/core";

import {
  DEFINITIONS,
  isMarked,
  type OwnBlock,
  type OwnInput,
  type Sample,
  type StoredInput,
  sampleIn,
  shadowOf,
} from "../../model/own-blocks";

type State = Blockly.serialization.blocks.State;
type Params = { params?: StoredInput[]; locals?: true };

/** What Blockly keeps in a definition. */
type Definition = Blockly.Block & {
  arguments_: string[];
  /** By the ids of the inputs' variables. */
  samples_?: Map<string, Sample>;
  /** Whether the variables that only it uses are its own. */
  hasLocals_?: boolean;
};

const CALLS = ["procedures_callnoreturn", "procedures_callreturn"];

export function isDefinition({ type }: Blockly.Block): boolean {
  return DEFINITIONS.includes(type);
}

/** The definition that a block is or calls. */
export function definitionOf(block: Blockly.Block): Blockly.Block | null {
  if (isDefinition(block)) return block;
  if (!CALLS.includes(block.type)) return null;
  const name = block.getFieldValue("NAME");
  return definitionsIn(block.workspace).find((one) => one.getFieldValue("NAME") === name) ?? null;
}

/** The definitions of a program, as they are drawn. */
export function definitionsIn(workspace: Blockly.Workspace): Blockly.Block[] {
  return workspace.getTopBlocks(true).filter(isDefinition);
}

/** A definition as its dialog shows it; inputs that come from a text begin with what a call of the program has. */
export function ownBlockOf(definition: Blockly.Block): OwnBlock {
  const { samples_ } = definition as Definition;
  const name = String(definition.getFieldValue("NAME"));
  const inputs = definition.getVarModels().map((variable, was): OwnInput => {
    const sample = samples_?.get(variable.getId()) ?? usedSample(definition, name, was) ?? 0;
    return { name: variable.getName(), sample, was };
  });
  return { name, inputs };
}

function usedSample(definition: Blockly.Block, name: string, place: number): Sample | undefined {
  const calls = CALLS.flatMap((type) => definition.workspace.getBlocksByType(type, false));
  for (const call of calls) {
    const value = call.getFieldValue("NAME") === name ? call.getInputTargetBlock(`ARG${place}`) : null;
    const sample = value ? sampleIn(value.type, (field) => value.getFieldValue(field)) : undefined;
    if (sample !== undefined) return sample;
  }
  return undefined;
}

/** A call with its usual values, as Blockly's state. */
export function callState({ name, inputs }: OwnBlock, answers: boolean): State {
  const params = inputs.map((input) => input.name);
  const values = inputs.map(({ sample }, place) => [`ARG${place}`, { shadow: shadowOf(sample) }]);
  return {
    type: CALLS[answers ? 1 : 0]!,
    extraState: { name, ...(params.length ? { params } : {}) },
    inputs: Object.fromEntries(values),
  };
}

/** A definition without content, as Blockly's state. */
export function definitionState({ name, inputs }: OwnBlock): State {
  const params = inputs.map((input) => ({ name: input.name, id: `input ${input.name}` }));
  return { type: DEFINITIONS[0]!, fields: { NAME: name }, ...(params.length ? { extraState: { params } } : {}) };
}

/** An input of a definition, in the look of a variable. */
class FieldInput extends Blockly.FieldLabel {
  override initView(): void {
    this.createBorderRect_();
    super.initView();
    if (this.fieldGroup_) Blockly.utils.dom.addClass(this.fieldGroup_, "lbOwnInput");
  }
}

function showInputs(this: Definition): void {
  const row = this.inputList[0]!;
  for (let place = 0; row.removeField(`PARAM${place}`, true); place++);
  this.arguments_.forEach((name, place) => row.appendField(new FieldInput(name), `PARAM${place}`));
}

/** Call it once, before the first block is created. */
export function drawOwnBlocks(): void {
  for (const type of DEFINITIONS) replaceDefinition(Blockly.Blocks[type]);
  for (const type of CALLS) {
    const call = Blockly.Blocks[type];
    const { init } = call;
    call.init = function (this: Blockly.Block) {
      init.call(this);
      this.setInputsInline(true);
    };
  }
}

// biome-ignore lint/suspicious/noExplicitAny: Blockly's definitions of blocks have no type
function replaceDefinition(definition: any): void {
  const { init, saveExtraState, loadExtraState } = definition;
  Object.assign(definition, {
    updateParams_: showInputs,
    init(this: Definition) {
      init.call(this);
      // The dialog takes the place of the gear, and the inputs that of their list.
      this.removeIcon(Blockly.icons.MutatorIcon.TYPE);
      this.inputList[0]!.removeField("PARAMS");
      this.samples_ = new Map();
    },
    saveExtraState(this: Definition): Params | null {
      const state = saveExtraState.call(this) as Params | null;
      const params = state?.params?.map((input) => {
        const sample = this.samples_?.get(input.id);
        return sample === undefined ? input : { ...input, sample };
      });
      const found = { ...(params && { params }), ...(this.hasLocals_ && { locals: true as const }) };
      return Object.keys(found).length ? { ...state, ...found } : state;
    },
    loadExtraState(this: Definition, state: Params) {
      loadExtraState.call(this, state);
      this.hasLocals_ = isMarked(state);
      for (const { id, sample } of state.params ?? []) if (sample !== undefined) this.samples_?.set(id, sample);
    },
  });
}
