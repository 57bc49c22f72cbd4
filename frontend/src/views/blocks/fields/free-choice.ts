/** A choice that asks for its options each time; a value outside of them is kept and shown. */

import * as Blockly from "blockly/core";

export class FreeChoice extends Blockly.FieldDropdown {
  override getOptions(): Blockly.MenuOption[] {
    return super.getOptions(false);
  }

  protected override doClassValidation_(value?: string): string | null {
    return value ?? null;
  }

  protected override getText_(): string | null {
    const found = this.getOptions().find((option) => option[1] === this.getValue());
    return found ? String(found[0]) : this.getValue();
  }
}
