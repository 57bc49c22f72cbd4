/** Fits the first statements of a program into the view of a phone, as long as they can be read. */

import type * as Blockly from "blockly/core";

/** The statements that are in sight at first. */
const FIRST = 10;
/** Words of 12 px: smaller ones could not be read. Larger blocks would differ from those on other screens. */
export const LEAST = 0.75;
/** Around the program, px. */
export const MARGIN = 4;

/** What a user does to a program. */
const TOUCHES = ["pointerdown", "wheel", "keydown"] as const;

interface Area {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Keeps the beginning of a program in the upper left corner of its view until the user touches it. */
export class Fit {
  private isOn = false;
  private before: readonly Blockly.BlockSvg[] = [];
  private readonly end = () => {
    this.isOn = false;
  };

  /** @param most the scale of a program that has room. */
  constructor(
    private readonly host: HTMLElement,
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly most: number,
  ) {
    for (const touch of TOUCHES) host.addEventListener(touch, this.end, true);
  }

  destroy(): void {
    for (const touch of TOUCHES) this.host.removeEventListener(touch, this.end, true);
  }

  /** A program is about to be shown. */
  remember(): void {
    this.before = this.workspace.getTopBlocks(false);
  }

  /** The program or the size of its view has changed; another program begins at its beginning. */
  look(): void {
    if (this.before.every((block) => block.isDisposed())) this.isOn = true;
    this.before = this.workspace.getTopBlocks(false);
    if (!this.workspace.horizontalLayout) return;
    const { viewWidth, viewHeight } = this.workspace.getMetrics();
    const first = this.isOn ? statementsOf(this.workspace).slice(0, FIRST) : [];
    if (first.length === 0 || viewHeight <= 2 * MARGIN) return;
    const { left, top, right, bottom } = around(first.map(areaOf));
    const scale = scaleFor([right - left, bottom - top], [viewWidth - 2 * MARGIN, viewHeight - 2 * MARGIN], this.most);
    this.workspace.setScale(scale);
    this.workspace.scroll(MARGIN - left * scale, MARGIN - top * scale);
  }
}

/** The largest allowed scale at which a program has room in a view, both as width and height. */
export function scaleFor(program: readonly [number, number], view: readonly [number, number], most: number): number {
  return Math.max(LEAST, Math.min(most, view[0] / program[0], view[1] / program[1]));
}

/** The statements from top to bottom. */
function statementsOf(workspace: Blockly.WorkspaceSvg): Blockly.BlockSvg[] {
  return workspace
    .getTopBlocks(true)
    .flatMap((stack) => stack.getDescendants(true).filter((one) => !one.outputConnection));
}

/** Of a statement that has others inside, what is above these. */
function areaOf(block: Blockly.BlockSvg): Area {
  const { left, top, right, bottom } = block.getBoundingRectangleWithoutChildren();
  const inputs = block.inputList.map(({ connection }) =>
    (connection as Blockly.RenderedConnection | null)?.targetBlock(),
  );
  const inside = inputs.find((one) => one?.previousConnection);
  return { left, top, right, bottom: inside?.getBoundingRectangleWithoutChildren().top ?? bottom };
}

function around(areas: readonly Area[]): Area {
  return {
    left: Math.min(...areas.map(({ left }) => left)),
    top: Math.min(...areas.map(({ top }) => top)),
    right: Math.max(...areas.map(({ right }) => right)),
    bottom: Math.max(...areas.map(({ bottom }) => bottom)),
  };
}
