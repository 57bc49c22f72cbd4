/** The placeholder of statements that are not drawn. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { changedBlocks } from "../../model/flat-blocks";
import type { Block } from "../../protocol/messages";
import { iconSource } from "../../ui/icons";
import { actionsOf } from "./actions";
import { blocksIn, REST, type Rest } from "./folds";

/** About the height of a statement, in units of the workspace. */
export const ROW = 48;
const ICON = 20;
const COLOUR = "#ffffff";
/** A picture that cannot be seen. */
const NOTHING = "data:image/gif;base64,R0lGODlhAQABAAAAACH5BAEKAAEALAAAAAABAAEAAAICTAEAOw==";

interface RestBlock extends Blockly.Block {
  rest?: Rest;
}

/** Call it once, before the first workspace is created. */
export function registerRest(): void {
  Blockly.Blocks[REST] = {
    init(this: RestBlock) {
      this.setStyle("procedure_blocks");
      this.setPreviousStatement(true);
      this.setNextStatement(true);
      this.setMovable(false);
      this.setDeletable(false);
    },
    saveExtraState(this: RestBlock) {
      return this.rest;
    },
    loadExtraState(this: RestBlock, rest: Rest) {
      show(this, rest);
    },
    /** Blockly calls it on every block when a function has a new name. */
    renameProcedure(this: RestBlock, old: string, name: string) {
      if (this.rest) this.rest = withPieces(this.rest, (piece) => renamedCalls(piece, old, name));
    },
  };
}

/** The statements that a placeholder hides; null for all other blocks. */
export function restIn(block: Blockly.Block | null): Rest | null {
  return block?.type === REST ? ((block as RestBlock).rest ?? null) : null;
}

/** Use a new name of a `when` in what is not drawn. */
export function renameHidden(workspace: Blockly.Workspace, types: readonly string[], old: string, name: string): void {
  for (const block of workspace.getBlocksByType(REST, false) as RestBlock[]) {
    if (!block.rest) continue;
    block.rest = withPieces(block.rest, (piece) => {
      return changedBlocks(piece, (one) => {
        const isUse = types.includes(one.type) && one.fields?.WHEN === old;
        return isUse ? { ...one, fields: { ...one.fields, WHEN: name } } : one;
      });
    });
  }
}

function show(block: RestBlock, rest: Rest): void {
  const isSame = block.rest?.count === rest.count && block.rest.folded === rest.folded;
  block.rest = rest;
  if (isSame) return;
  if (block.getInput("REST")) block.removeInput("REST");
  const row = block.appendDummyInput("REST");
  const words = t("page-blocks-rest", { count: rest.count });
  if (!rest.folded) row.appendField(new Blockly.FieldImage(NOTHING, 1, Math.max(1, rest.count - 1) * ROW));
  row.appendField(
    new Blockly.FieldImage(iconSource("down", COLOUR), ICON, ICON, t("page-blocks-open-rest"), open),
    "OPEN",
  );
  row.appendField(words);
}

function open(field: Blockly.Field): void {
  const block = field.getSourceBlock() as Blockly.BlockSvg | null;
  if (block) actionsOf(block.workspace)?.draw(block.id);
}

function withPieces(rest: Rest, change: (piece: readonly Block[]) => Block[]): Rest {
  return { ...rest, pieces: rest.pieces.map(change) };
}

function renamedCalls(blocks: readonly Block[], old: string, name: string): Block[] {
  return changedBlocks(blocks, (one) => {
    const state = one.extraState as { name?: string } | null | undefined;
    const calls = one.type.startsWith("procedures_call") && state?.name === old;
    return calls ? { ...one, extraState: { ...state, name } } : one;
  });
}

/** Statements with other ids, for a copy of their placeholder. */
export function copied(blocks: readonly Block[]): Block[] {
  const copies = structuredClone(blocks) as Block[];
  for (const block of blocksIn(copies)) {
    block.id = Blockly.utils.idGenerator.genUid();
    for (const { shadow } of Object.values(block.inputs ?? {}))
      if (shadow) shadow.id = Blockly.utils.idGenerator.genUid();
  }
  return copies;
}
