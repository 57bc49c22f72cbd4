/** The blocks that stand pale in the places of a skill's parameters, each with a field of its type. */

import * as Blockly from "blockly/core";

import "./fields.css";
import { FieldAngle, FieldSlider } from "./numbers";
import { FieldChoice, FieldColour, FieldTag } from "./texts";

export { learnAllowed, type Allowed, type Definition } from "./allowed";

interface Pale {
  readonly style: string;
  readonly output: string;
  /** Of the field, as the server writes and reads it. */
  readonly name: string;
  field(): unknown;
}

const PALE: Readonly<Record<string, Pale>> = {
  lb_slider: { style: "math_blocks", output: "Number", name: "NUM", field: () => new FieldSlider() },
  lb_angle: { style: "math_blocks", output: "Number", name: "NUM", field: () => new FieldAngle() },
  lb_choice: { style: "text_blocks", output: "String", name: "TEXT", field: () => new FieldChoice() },
  lb_colour: { style: "text_blocks", output: "String", name: "TEXT", field: () => new FieldColour() },
  lb_tag: { style: "text_blocks", output: "String", name: "TEXT", field: () => new FieldTag() },
};

/** Define these blocks, once for the whole page. */
export function defineFields(): void {
  for (const [type, { style, output, name, field }] of Object.entries(PALE)) {
    Blockly.Blocks[type] = {
      init(this: Blockly.Block) {
        this.appendDummyInput().appendField(field() as Blockly.Field, name);
        this.setOutput(true, output);
        this.setStyle(style);
      },
    };
  }
}
