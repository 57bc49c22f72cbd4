/** The shadow blocks for a skill's parameters, each with a field of its type. */

import * as Blockly from "blockly/core";

import "./fields.css";
import { registerDirections } from "./direction";
import { FieldAngle, FieldSlider } from "./numbers";
import { FieldChoice, FieldColour } from "./texts";
import { FieldTick } from "./tick";
import { registerUnits } from "./unit";

export { type Allowed, type Definition, learnAllowed } from "./allowed";

interface Pale {
  readonly style: string;
  readonly output: string;
  /** The field's name in messages. */
  readonly name: string;
  field(): unknown;
}

const PALE: Readonly<Record<string, Pale>> = {
  lb_slider: { style: "math_blocks", output: "Number", name: "NUM", field: () => new FieldSlider() },
  lb_angle: { style: "math_blocks", output: "Number", name: "NUM", field: () => new FieldAngle() },
  lb_choice: { style: "text_blocks", output: "String", name: "TEXT", field: () => new FieldChoice() },
  lb_truth: { style: "logic_blocks", output: "Boolean", name: "BOOL", field: () => new FieldTick() },
  lb_colour: { style: "text_blocks", output: "String", name: "TEXT", field: () => new FieldColour() },
};

/** Define these blocks, once for the whole page. */
export function defineFields(): void {
  registerDirections();
  registerUnits();
  for (const [type, pale] of Object.entries(PALE)) defineField(type, pale);
}

/** Define a block that is one field. */
export function defineField(type: string, { style, output, name, field }: Pale): void {
  Blockly.Blocks[type] = {
    init(this: Blockly.Block) {
      this.appendDummyInput().appendField(field() as Blockly.Field, name);
      this.setOutput(true, output);
      this.setStyle(style);
    },
  };
}
