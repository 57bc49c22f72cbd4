/** Puts a block of the palette where it fits in the program, for a tap instead of a drag. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { onPaletteClick } from "./patches";

type Block = Blockly.BlockSvg;
type State = Blockly.serialization.blocks.State;

/** Between a block and what is above it, in units of the workspace. */
const GAP = 40;

/** In Blockly a click in a palette that closes itself puts the block on top of the program. */
export function insertOnClick(): void {
  onPaletteClick((block, workspace) => {
    const state = Blockly.serialization.blocks.save(block);
    if (state) insertWhereFits(state, workspace);
  });
}

/** Add a block at the end of the program in sight, or into the selected block if it is a value. */
export function insertWhereFits(state: State, workspace: Blockly.WorkspaceSvg): void {
  const group = Blockly.Events.getGroup();
  Blockly.Events.setGroup(true);
  const selected = selectedBlock(workspace);
  const others = workspace.getTopBlocks(true);
  const block = Blockly.serialization.blocks.append(state, workspace) as Block;
  const place = placeFor(block, selected, others);
  if (!place) moveBelow(block, others);
  else place.connect((block.outputConnection ?? block.previousConnection)!);
  Blockly.Events.setGroup(group);
  workspace.hideChaff(false);
  Blockly.renderManagement.triggerQueuedRenders(workspace);
  Blockly.getFocusManager().focusNode(block);
  workspace.scrollBoundsIntoView(block.getBoundingRectangleWithoutChildren());
  Blockly.utils.aria.announceDynamicAriaState(t("page-blocks-inserted", { block: block.toString() }));
}

function selectedBlock(workspace: Blockly.WorkspaceSvg): Block | null {
  const selected = Blockly.common.getSelected();
  return selected instanceof Blockly.BlockSvg && selected.workspace === workspace ? selected : null;
}

/** The first place where the block fits: at the selected block, else in the stacks, those in sight first. */
function placeFor(block: Block, selected: Block | null, others: readonly Block[]): Blockly.Connection | null {
  const hats = others.filter((one) => !one.previousConnection && !one.outputConnection);
  const places = [
    ...(selected ? placesAt(selected, block) : []),
    ...inSightFirst(hats).flatMap((hat) => placesIn(hat, block)),
  ];
  return places.find((place) => fits(block, place)) ?? null;
}

function inSightFirst(stacks: readonly Block[]): readonly Block[] {
  const seen = stacks.filter(isInSight);
  return [...seen, ...stacks.filter((one) => !seen.includes(one))];
}

function isInSight(block: Block): boolean {
  const { top, left, width, height } = block.workspace.getMetricsManager().getViewMetrics(true);
  return new Blockly.utils.Rect(top, top + height, left, left + width).intersects(block.getBoundingRectangle());
}

/** A value may take the place of a usual value; a statement goes into an empty loop, or below. */
function placesAt(selected: Block, block: Block): Blockly.Connection[] {
  if (block.outputConnection) return [...emptyPlaces(selected), ...usualPlaces(selected)];
  const statement = statementAround(selected);
  if (!statement) return placesIn(selected, block);
  const body = bodyOf(statement);
  return [body?.targetBlock() ? null : body, statement.nextConnection].filter(
    (place) => place !== null && place !== undefined,
  );
}

/** Where a block fits into a stack that begins with a hat. */
function placesIn(hat: Block, block: Block): Blockly.Connection[] {
  if (block.outputConnection) return emptyPlaces(hat);
  const body = bodyOf(hat);
  const end = body?.targetBlock() ? body.targetBlock()?.lastConnectionInStack(true) : body;
  return end ? [end] : [];
}

function fits(block: Block, place: Blockly.Connection): boolean {
  const own = block.outputConnection ?? block.previousConnection;
  return !!own && block.workspace.connectionChecker.canConnect(place, own, false);
}

function bodyOf({ inputList }: Block): Blockly.Connection | null {
  return inputList.find(({ type }) => type === Blockly.inputs.inputTypes.STATEMENT)?.connection ?? null;
}

function emptyPlaces(block: Block): Blockly.Connection[] {
  return valuePlaces(block).filter((place) => !place.targetBlock());
}

function usualPlaces(block: Block): Blockly.Connection[] {
  return valuePlaces(block).filter((place) => place.targetBlock()?.isShadow());
}

/** The places for values in a block and in what is inside it. */
function valuePlaces(block: Block): Blockly.Connection[] {
  const inside = block.getDescendants(true).filter((one) => !one.isShadow());
  const inputs = inside.flatMap((one) => one.inputList).filter(({ type }) => type === Blockly.inputs.inputTypes.VALUE);
  return inputs.map(({ connection }) => connection).filter((connection) => connection !== null);
}

/** A block that is a statement, or the one that a value belongs to. */
function statementAround(block: Block): Block | null {
  let outer: Block | null = block;
  while (outer?.outputConnection) outer = outer.getParent();
  return outer?.previousConnection ? outer : null;
}

/** A block that fits nowhere goes below all others. */
function moveBelow(block: Block, others: readonly Block[]): void {
  const { left, top } = block.workspace.getMetricsManager().getViewMetrics(true);
  const bottom = Math.max(top, ...others.map((one) => one.getBoundingRectangle().bottom));
  const x = others[0]?.getRelativeToSurfaceXY().x ?? left + GAP;
  block.moveTo(new Blockly.utils.Coordinate(x, bottom + GAP));
}
