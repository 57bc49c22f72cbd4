/** Leaves most of a large program undrawn: bodies of functions, and pieces of long lists of statements. */

import { DEFINITIONS } from "../../model/own-blocks";
import { WHENS } from "../../model/whens";
import type { Block, Workspace } from "../../protocol/messages";

/** The type of the placeholder of statements that are not drawn. */
export const REST = "lb_rest";
/** Programs up to this many statements are drawn as a whole. */
export const LARGE = 300;
/** The most statements of a piece. */
const PIECE = 40;
/** One in this many statements ends a piece. */
const ENDS = 16;
/** Shorter bodies of functions are always drawn. */
const SHORT = 3;
const HEADS = new Set([...WHENS, ...DEFINITIONS]);

type Chain = readonly Block[];

/** Statements that are not drawn, as the extra state of their placeholder. */
export interface Rest {
  /** Each of them is drawn as a whole, or not at all. */
  readonly pieces: readonly Chain[];
  /** Whether they are the folded body of a function, which the user opens; others are drawn once they are in sight. */
  readonly folded: boolean;
  /** How many statements they are, with those inside. */
  readonly count: number;
}

/** Whether a list of statements is to be drawn. */
export type IsOpen = (blocks: Chain, folded: boolean) => boolean;

/** The program with a block for each list of statements that is not to be drawn; a small one is drawn as a whole. */
export function fold(program: Workspace, isOpen: IsOpen): Workspace {
  const count = program.stacks.reduce((sum, stack) => sum + countOf(stack), 0);
  if (count <= LARGE) return program;
  return { ...program, stacks: program.stacks.map((stack) => foldStack(stack, isOpen)) };
}

/** Statements for a block that the user has copied, with other ids. */
export type Copy = (rest: Rest, id: string) => readonly Block[];

/** The program with all statements again. */
export function unfold(program: Workspace, copy: Copy): Workspace {
  return { ...program, stacks: program.stacks.map((stack) => unfoldChain(stack, copy)) };
}

/** The statements that a placeholder hides; null for all other blocks. */
export function restOf({ type, extraState }: Block): Rest | null {
  return type === REST ? (extraState as Rest) : null;
}

/** All statements that a placeholder hides. */
export function blocksOf({ pieces }: Rest): Block[] {
  return pieces.flat();
}

/** The piece in which a block is. */
export function pieceWith(id: string, { pieces }: Rest): Chain | null {
  return pieces.find((piece) => [...blocksIn(piece)].some((block) => block.id === id)) ?? null;
}

/** The number of statements, with those inside them. */
export function countOf(chain: Chain): number {
  let count = 0;
  for (const block of chain) count += statementsIn(block);
  return count;
}

/** The id of the placeholder of each hidden block, by the id of that block. */
export function hiddenIn(program: Workspace): Map<string, string> {
  const found = new Map<string, string>();
  for (const block of blocksIn(program.stacks.flat())) {
    const rest = restOf(block);
    for (const hidden of blocksIn(rest ? blocksOf(rest) : [])) found.set(hidden.id, block.id);
  }
  return found;
}

/** Blocks with all blocks inside them, except shadows. */
export function* blocksIn(chain: Chain): Generator<Block> {
  for (const block of chain) {
    yield block;
    for (const input of Object.values(block.inputs ?? {})) {
      if (input.block) yield* blocksIn([input.block]);
      if (input.stack) yield* blocksIn(input.stack);
    }
  }
}

function foldStack(stack: Chain, isOpen: IsOpen): Block[] {
  const [head, ...others] = stack;
  if (!head || !HEADS.has(head.type)) return cut(stack, isOpen);
  return [withStacks(head, (body) => foldBody(body, isOpen)), ...cut(others, isOpen)];
}

function foldBody(body: Chain, isOpen: IsOpen): Block[] {
  const drawn = countOf(body) <= SHORT || isOpen(body, true);
  return drawn ? cut(body, isOpen) : [restFor([body], true)];
}

/** A list of statements with a block for neighbouring pieces that are not to be drawn. */
function cut(chain: Chain, isOpen: IsOpen): Block[] {
  if (countOf(chain) <= PIECE) return [...chain];
  const found: Block[] = [];
  let closed: Chain[] = [];
  const close = () => {
    if (closed.length) found.push(restFor(closed, false));
    closed = [];
  };
  for (const piece of piecesOf(chain)) {
    const drawn = drawnPiece(piece, isOpen);
    if (!drawn) closed.push(piece);
    else {
      close();
      found.push(...drawn);
    }
  }
  close();
  return found;
}

/** A piece that is to be drawn; null for others. A long loop is always drawn, but maybe not what is in it. */
function drawnPiece(piece: Chain, isOpen: IsOpen): Chain | null {
  const [first] = piece;
  if (first && piece.length === 1 && countOf(piece) > PIECE) return [withStacks(first, (body) => cut(body, isOpen))];
  return isOpen(piece, false) ? piece : null;
}

/** Where a piece ends depends on its statements alone, so that an edit changes only the piece in which it is. */
function piecesOf(chain: Chain): Block[][] {
  const found: Block[][] = [];
  let piece: Block[] = [];
  let size = 0;
  const end = () => {
    if (piece.length) found.push(piece);
    piece = [];
    size = 0;
  };
  for (const block of chain) {
    const own = countOf([block]);
    if (size + own > PIECE) end();
    piece.push(block);
    size += own;
    if (size > PIECE || mixed(block.id) % ENDS === 0) end();
  }
  end();
  return found;
}

/** A number that says nothing about the order of ids (FNV-1a). */
function mixed(id: string): number {
  let hash = 2166136261;
  for (let i = 0; i < id.length; i++) hash = Math.imul(hash ^ id.charCodeAt(i), 16777619);
  return (hash ^ (hash >>> 15)) >>> 0;
}

function restFor(pieces: readonly Chain[], folded: boolean): Block {
  const state: Rest = { pieces, folded, count: countOf(pieces.flat()) };
  return { type: REST, id: idOf(pieces), extraState: state };
}

function idOf([piece]: readonly Chain[]): string {
  return `${REST}:${piece?.[0]?.id}`;
}

function withStacks(block: Block, change: (stack: Chain) => Block[]): Block {
  const inputs = Object.entries(block.inputs ?? {}).map(([name, input]) => {
    return [name, input.stack?.length ? { ...input, stack: change(input.stack) } : input];
  });
  return { ...block, inputs: Object.fromEntries(inputs) };
}

function unfoldChain(chain: Chain, copy: Copy): Block[] {
  return chain.flatMap((block) => {
    const rest = restOf(block);
    if (rest) return block.id === idOf(rest.pieces) ? blocksOf(rest) : copy(rest, block.id);
    return hasRest(block) ? withStacks(block, (stack) => unfoldChain(stack, copy)) : block;
  });
}

function hasRest(block: Block): boolean {
  return Object.values(block.inputs ?? {}).some(({ stack }) => stack?.some((one) => restOf(one) || hasRest(one)));
}

const counts = new WeakMap<Block, number>();

function statementsIn(block: Block): number {
  const known = counts.get(block);
  if (known !== undefined) return known;
  const inner = Object.values(block.inputs ?? {}).map(({ stack }) => countOf(stack ?? []));
  const count = (restOf(block)?.count ?? 1) + inner.reduce((sum, one) => sum + one, 0);
  counts.set(block, count);
  return count;
}
