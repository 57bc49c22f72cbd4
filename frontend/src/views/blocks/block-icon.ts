/** The icon of its group at the beginning of every statement, and a face at the end of what is about one. */

import * as Blockly from "blockly/core";

import { faceSource } from "../../ui/face";
import { type IconName, iconSource } from "../../ui/icons";
import { type Group, inkOf, STYLES } from "./groups";
import { beforeDrawing } from "./patches";

const SIZE = 20;
const FACE_SIZE = 26;
const NAME = "LB_ICON";
const FACE = "LB_FACE";
/** The emotions by the ends of the names of the skills that show or see them. */
const EMOTIONS: Readonly<Record<string, string>> = {
  joy: "joy",
  happy: "joy",
  sadness: "sadness",
  sad: "sadness",
  surprise: "surprise",
  surprised: "surprise",
  disgust: "disgust",
  disgusted: "disgust",
  anger: "anger",
  angry: "anger",
  fear: "fear",
  scared: "fear",
  neutral: "neutral",
};
const EMOTION = /^lb_skill_(?:express|is_any_face_|is_)([A-Za-z]+)$/;

/** Blocks for which the icon of their group would be wrong: what chooses or waits does not repeat. */
const OWN_ICONS: Readonly<Record<string, IconName>> = {
  controls_if: "branch",
  lb_skill_sleep: "wait",
  lb_wait_until: "wait",
};

/** Each icon is made once, and all blocks that have it share it. */
const sources = new Map<string, string>();

function sourceOf(name: IconName, group: Group): string {
  const key = `${name} ${group}`;
  const known = sources.get(key);
  if (known) return known;
  const source = iconSource(name, inkOf(group));
  sources.set(key, source);
  return source;
}

/** A picture without a name: the sentence says everything. */
class Picture extends Blockly.FieldImage {
  override readonly SERIALIZABLE = false;

  // Blockly would read out a field without text as "empty"; an empty list adds nothing to the sentence.
  override computeAriaLabel(): string {
    return [] as unknown as string;
  }
}

class BlockIcon extends Picture {
  constructor() {
    super(sourceOf("control", "control"), SIZE, SIZE);
  }

  /** The block's group may change, such as that of a call with its function. */
  override applyColour(): void {
    const block = this.getSourceBlock() as Blockly.BlockSvg | null;
    const group = STYLES[block?.getStyleName() ?? ""];
    if (group) this.setValue(sourceOf(OWN_ICONS[block?.type ?? ""] ?? group, group));
  }
}

/** Call it once, before the first block is created. */
export function showIcons(): void {
  beforeDrawing((block) => {
    addIcon(block);
    addFace(block);
  });
}

function addIcon(block: Blockly.BlockSvg): void {
  const row = block.inputList[0];
  if (!row || block.outputConnection || block.getField(NAME) || !(block.getStyleName() in STYLES)) return;
  row.insertFieldAt(0, new BlockIcon(), NAME);
}

function addFace(block: Blockly.BlockSvg): void {
  const emotion = EMOTIONS[EMOTION.exec(block.type)?.[1]?.toLowerCase() ?? ""];
  const row = block.inputList.at(-1);
  if (!emotion || !row || block.getField(FACE)) return;
  row.appendField(new Picture(faceSource(emotion, "#ffffff"), FACE_SIZE, FACE_SIZE), FACE);
}
