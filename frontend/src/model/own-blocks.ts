/** The blocks that a program defines: made, and changed together with everything that uses them. */

import type { Block, Input, Workspace } from "../protocol/messages";
import { changedBlocks } from "./flat-blocks";

/** What an input begins with in a new call; its type is the kind of the input. */
export type Sample = number | string | boolean;
export type SampleKind = "number" | "text" | "truth";

export interface OwnInput {
  readonly name: string;
  readonly sample: Sample;
  /** Its place among the inputs before the change; none for a new one. */
  readonly was?: number;
}

/** A block as its dialog shows it. */
export interface OwnBlock {
  readonly name: string;
  readonly inputs: readonly OwnInput[];
}

/** What a definition stores about an input. */
export interface StoredInput {
  readonly name: string;
  readonly id: string;
  readonly sample?: Sample;
}

type Variables = Workspace["variables"];

/** The blocks of definitions: the page makes the first, Blockly has both. */
export const DEFINITIONS: readonly string[] = ["procedures_defnoreturn", "procedures_defreturn"];
/** The block of a sample value in a call, and its field. */
const SHADOWS = { number: ["math_number", "NUM"], text: ["text", "TEXT"], truth: ["lb_truth", "BOOL"] } as const;
/** Calls that fit no definition, such as those with arguments by name. */
const OTHER_CALLS = new Set(["lb_call", "lb_call_value"]);

export function kindOf(sample: Sample): SampleKind {
  if (typeof sample === "number") return "number";
  return typeof sample === "string" ? "text" : "truth";
}

/** The state of the block that shows a sample value. */
export function shadowOf(sample: Sample): { type: string; fields: Record<string, string | number> } {
  const [type, field] = SHADOWS[kindOf(sample)];
  return { type, fields: { [field]: typeof sample === "boolean" ? String(sample).toUpperCase() : sample } };
}

/** The value that a block shows; undefined if it shows none, such as a variable. */
export function sampleIn(type: string, fieldOf: (name: string) => unknown): Sample | undefined {
  if (type === "math_number") return Number(fieldOf("NUM"));
  if (type === "text") return String(fieldOf("TEXT"));
  return type === "lb_truth" || type === "logic_boolean" ? fieldOf("BOOL") === "TRUE" : undefined;
}

/** A call as Block-Text and Python write it. */
export function callInText({ name, inputs }: OwnBlock): string {
  const words = inputs.map(({ sample }) => {
    if (typeof sample === "boolean") return sample ? "True" : "False";
    return typeof sample === "string" ? JSON.stringify(sample) : String(sample);
  });
  return `${name}(${words.join(", ")})`;
}

/**
 * A program with a new definition, and its id.
 *
 * @param hasLocals whether the variables that only it uses are its own; the server takes them for local.
 */
export function withNew(
  program: Workspace,
  own: OwnBlock,
  { hasLocals = false } = {},
): { program: Workspace; id: string } {
  const fresh = freshIds(program);
  const { variables, inputs } = stored(program.variables, own.inputs, fresh);
  const id = fresh();
  const block: Block = { type: DEFINITIONS[0]!, id, fields: { NAME: own.name }, ...stateOf(inputs, hasLocals) };
  return { program: { variables, stacks: [...program.stacks, [block]] }, id };
}

/** A program with a changed definition; all its calls follow. */
export function withChanged(program: Workspace, id: string, own: OwnBlock): Workspace {
  const definition = program.stacks.map(([first]) => first).find((first) => first?.id === id);
  if (!definition) return program;
  const fresh = freshIds(program);
  const old = storedIn(definition);
  const { variables, inputs } = stored(program.variables, own.inputs, fresh);
  const renamed = new Map<string, StoredInput>();
  own.inputs.forEach(({ was }, place) => {
    if (was !== undefined && old[was]) renamed.set(old[was].id, inputs[place]!);
  });
  const uses = callChange(String(definition.fields?.NAME), old, own, fresh);
  const stacks = program.stacks.map(([first, ...below]) => {
    const stack = changedBlocks([first!, ...below], uses);
    return first!.id === id ? [redefined(stack[0]!, own.name, inputs, renamed), ...stack.slice(1)] : stack;
  });
  return { variables, stacks };
}

function redefined(
  block: Block,
  name: string,
  inputs: readonly StoredInput[],
  renamed: ReadonlyMap<string, StoredInput>,
): Block {
  const { extraState, ...definition } = changedBlocks([block], (one) => withVariables(one, renamed))[0]!;
  return { ...definition, fields: { ...definition.fields, NAME: name }, ...stateOf(inputs, isMarked(extraState)) };
}

/** A block whose variables are those of the renamed inputs. */
function withVariables(block: Block, renamed: ReadonlyMap<string, StoredInput>): Block {
  const fields = Object.entries(block.fields ?? {}).map(([name, value]) => {
    const variable =
      typeof value === "object" && value !== null ? renamed.get((value as { id: string }).id) : undefined;
    return [name, variable ? { id: variable.id } : value];
  });
  return block.fields ? { ...block, fields: Object.fromEntries(fields) } : block;
}

/** How a block changes if it calls the definition. */
function callChange(name: string, old: readonly StoredInput[], own: OwnBlock, fresh: () => string) {
  return (block: Block): Block => {
    const state = (block.extraState ?? {}) as { name?: string; keywords?: string[] };
    if (state.name !== name) return block;
    if (block.type.startsWith("procedures_call")) return fittingCall(block, own, fresh);
    if (!OTHER_CALLS.has(block.type)) return block;
    const keywords = state.keywords?.map((word) => {
      const was = old.findIndex((input) => input.name === word);
      return own.inputs.find((input) => was >= 0 && input.was === was)?.name ?? word;
    });
    const fields = "NAME" in (block.fields ?? {}) ? { fields: { ...block.fields, NAME: own.name } } : {};
    return { ...block, ...fields, extraState: { ...state, name: own.name, ...(keywords && { keywords }) } };
  };
}

function fittingCall(block: Block, own: OwnBlock, fresh: () => string): Block {
  const before = block.inputs ?? {};
  const inputs: Record<string, Input> = {};
  own.inputs.forEach(({ was, sample }, place) => {
    const kept = was === undefined ? { shadow: { id: fresh(), ...shadowOf(sample) } } : before[`ARG${was}`];
    if (kept) inputs[`ARG${place}`] = kept;
  });
  const params = own.inputs.map(({ name }) => name);
  return { ...block, inputs, extraState: { name: own.name, ...(params.length ? { params } : {}) } };
}

function stateOf(inputs: readonly StoredInput[], hasLocals: boolean): Pick<Block, "extraState"> {
  const state = { ...(inputs.length ? { params: inputs } : {}), ...(hasLocals ? { locals: true } : {}) };
  return Object.keys(state).length ? { extraState: state } : {};
}

/** Whether the state of a definition says that the variables that only it uses are its own. */
export function isMarked(state: unknown): boolean {
  return (state as { locals?: boolean } | null | undefined)?.locals === true;
}

function storedIn({ extraState }: Block): readonly StoredInput[] {
  return (extraState as { params?: readonly StoredInput[] } | null | undefined)?.params ?? [];
}

/** The inputs as variables, of which those that are missing are added. */
function stored(known: Variables, inputs: readonly OwnInput[], fresh: () => string) {
  const variables = [...known];
  const found = inputs.map(({ name, sample }) => {
    const variable = variables.find((one) => one.name === name) ?? { name, id: fresh() };
    if (!variables.includes(variable)) variables.push(variable);
    return { name, id: variable.id, sample };
  });
  return { variables, inputs: found };
}

/** Ids that the program does not use. */
function freshIds({ stacks, variables }: Workspace): () => string {
  const used = new Set(variables.map(({ id }) => id));
  const note = (block: Block) => {
    used.add(block.id);
    for (const { shadow } of Object.values(block.inputs ?? {})) if (shadow) used.add(shadow.id);
    return block;
  };
  for (const stack of stacks) changedBlocks(stack, note);
  let number = 0;
  return () => {
    do number += 1;
    while (used.has(`own${number}`));
    return `own${number}`;
  };
}
