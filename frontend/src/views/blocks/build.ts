/** Builds Blockly's blocks from flat ones, without their children. */

import * as Blockly from "blockly/core";

import type { Block, BlockComment } from "../../protocol/messages";
import type { Node } from "./flat";
import { shadowOf } from "./flat";
import { toState } from "./read";
import { ensureDefined, shapeUnknown } from "./unknown";

const { MANUALLY_DISABLED } = Blockly.constants;

/** A new block without its children and shadows. */
export function build(workspace: Blockly.WorkspaceSvg, node: Node): Blockly.BlockSvg {
  const flat = node.block;
  ensureDefined(flat);
  const block = workspace.newBlock(flat.type, flat.id);
  shapeUnknown(block, node);
  if (flat.extraState != null) block.loadExtraState?.(flat.extraState);
  loadFields(block, flat.fields);
  setAttributes(block, flat);
  setComment(block, flat.comment ?? null);
  block.initSvg();
  block.queueRender();
  return block;
}

/** Gives a new block its shadows, after its children: shadows under a child are not created. */
export function addShadows(block: Blockly.BlockSvg, flat: Block): void {
  setShadows(block, flat, undefined);
}

/** Changes a block from `shown` to `wanted`; returns false if they are equal. */
export function update(block: Blockly.BlockSvg, shown: Block, wanted: Block): boolean {
  const fields = changedFields(shown, wanted);
  if (fields) loadFields(block, fields);
  const attributes = !sameAttributes(shown, wanted);
  if (attributes) setAttributes(block, wanted);
  const comment = !same(shown.comment, wanted.comment);
  if (comment) setComment(block, wanted.comment ?? null);
  return setShadows(block, wanted, shown) || fields !== null || attributes || comment;
}

function changedFields(shown: Block, wanted: Block): Block["fields"] | null {
  const changed = Object.entries(wanted.fields ?? {}).filter(([name, value]) => !same(value, shown.fields?.[name]));
  return changed.length ? Object.fromEntries(changed) : null;
}

/** Whether the change needs a new block. */
export function differsInShape(shown: Block, wanted: Block): boolean {
  return shown.type !== wanted.type || !same(shown.extraState, wanted.extraState);
}

/** Whether two JSON values are equal. */
export function same(one: unknown, other: unknown): boolean {
  return one === other || (one ?? null) === (other ?? null) || JSON.stringify(one) === JSON.stringify(other);
}

function sameAttributes(one: Block, other: Block): boolean {
  return (
    (one.data ?? null) === (other.data ?? null) &&
    (one.collapsed ?? false) === (other.collapsed ?? false) &&
    (one.inline ?? null) === (other.inline ?? null) &&
    isDisabled(one) === isDisabled(other)
  );
}

function isDisabled(flat: Block): boolean {
  return flat.disabledReasons?.includes(MANUALLY_DISABLED) ?? false;
}

function loadFields(block: Blockly.BlockSvg, fields: Block["fields"]): void {
  for (const [name, value] of Object.entries(fields ?? {})) {
    const field = block.getField(name);
    if (field) quietly(field, () => field.loadState(value));
  }
}

// A name's validator would rename its uses, or the name itself if it is currently taken; the
// server's program is already consistent.
function quietly(field: Blockly.Field, load: () => void): void {
  const validator = field.name === "NAME" ? field.getValidator() : null;
  if (validator) field.setValidator((value) => value);
  load();
  if (validator) field.setValidator(validator);
}

function setAttributes(block: Blockly.BlockSvg, flat: Block): void {
  block.data = flat.data ?? null;
  if (flat.inline != null && block.getInputsInline() !== flat.inline) block.setInputsInline(flat.inline);
  if (block.isCollapsed() !== (flat.collapsed ?? false)) block.setCollapsed(flat.collapsed ?? false);
  block.setDisabledReason(isDisabled(flat), MANUALLY_DISABLED);
}

function setComment(block: Blockly.BlockSvg, comment: BlockComment | null): void {
  block.setCommentText(comment ? comment.text : null);
  const icon = block.getIcon(Blockly.icons.CommentIcon.TYPE);
  if (!comment || !icon) return;
  const { width, height, pinned = false } = comment;
  if (width && height) icon.setBubbleSize(new Blockly.utils.Size(width, height));
  if (icon.bubbleIsVisible() !== pinned) void icon.setBubbleVisible(pinned);
}

function setShadows(block: Blockly.BlockSvg, wanted: Block, shown: Block | undefined): boolean {
  let changed = false;
  for (const { connection, name } of block.inputList) {
    const shadow = shadowOf(wanted, name);
    if (!connection || same(shadow, shadowOf(shown, name))) continue;
    if (!updateShadow(connection.targetBlock(), shadow, shadowOf(shown, name))) {
      connection.setShadowState(shadow && toState(shadow));
    }
    changed = true;
  }
  return changed;
}

/** Changes a shadow in place, so an open editor stays open; false if that is not enough. */
function updateShadow(target: Blockly.Block | null, wanted: Block | null, shown: Block | null): boolean {
  if (!wanted || !shown || !target?.isShadow() || target.id !== wanted.id) return false;
  if (!same({ ...wanted, fields: null }, { ...shown, fields: null })) return false;
  loadFields(target as Blockly.BlockSvg, wanted.fields);
  return true;
}
