/** A unit after a number: "wait 1 second", "wait 2 seconds". */

import * as Blockly from "blockly/core";

/** The singulars of units, by their plurals, in all languages of the blocks. */
type Units = Readonly<Record<string, string>>;
let units: Units = {};
const FIRST_WORD = /^\s*\p{L}+/u;

/** Words of a sentence, the first of which may be the unit of the number before them. */
class FieldUnit extends Blockly.FieldLabel {
  static override fromJson(json: Blockly.FieldConfig & { text?: string; class?: string }): FieldUnit {
    return new FieldUnit(Blockly.utils.parsing.replaceMessageReferences(json.text), json.class, json);
  }

  /** Only on a drawn block: the search knows the usual word. */
  private isOne = false;

  /** Blockly asks for it whenever it draws the block, also after the number has changed. */
  override getSize(): Blockly.utils.Size {
    const isOne = this.followsOne();
    if (isOne !== this.isOne) this.isDirty_ = true;
    this.isOne = isOne;
    return super.getSize();
  }

  protected override getText_(): string | null {
    return this.isOne ? String(this.getValue()).replace(FIRST_WORD, (word) => units[word.trim()] ?? word) : null;
  }

  private followsOne(): boolean {
    const input = this.getParentInput();
    const inputs = this.getSourceBlock()?.inputList ?? [];
    const before = inputs[inputs.indexOf(input) - 1];
    if (input.fieldRow[0] !== (this as Blockly.Field)) return false;
    return before?.connection?.targetBlock()?.getField("NUM")?.getValue() === 1;
  }
}

export function learnUnits(known: Units): void {
  units = known;
}

/** Use it for the words of all blocks; call it once. */
export function registerUnits(): void {
  Blockly.fieldRegistry.unregister("field_label");
  Blockly.fieldRegistry.register("field_label", FieldUnit);
}
