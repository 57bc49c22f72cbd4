/** The sign of a number as a word of the sentence: "turn right by 90°", "turn left by 90°". */

import * as Blockly from "blockly/core";

import { become } from "./become";

const POSITIVE = "positive";
const NEGATIVE = "negative";
/** The name of a parameter's direction is that of the parameter with this end, as on the server. */
const END = ".direction";
/** The class of a word that cannot be changed: it says which way a calculated positive number goes. */
const FIXED = "lbFixed";

interface Options extends Blockly.FieldConfig {
  readonly options: Blockly.MenuOption[];
  /** The types of two blocks that are one in two directions, by the sign of the number. */
  readonly types?: Readonly<Record<string, string>>;
}

/**
 * A menu of two words for the sign of a plain number in the parameter's place.
 *
 * It is not saved: the number has the sign. Beside a zero it is remembered for the next number.
 * A choice also changes the block's type where each direction has a block of its own, so that the
 * texts turn right with `turn_right`.
 */
export class FieldDirection extends Blockly.FieldDropdown {
  static override fromJson(json: Blockly.FieldConfig): FieldDirection {
    const { options, types } = json as Options;
    const field = new FieldDirection(options);
    field.types = types ?? {};
    return field;
  }

  private types: Readonly<Record<string, string>> = {};

  override isSerializable(): boolean {
    return false;
  }

  get isNegative(): boolean {
    return this.getValue() === NEGATIVE;
  }

  /** Blockly asks for it whenever it draws the block, also after its number has changed. */
  override getSize(): Blockly.utils.Size {
    this.follow();
    return super.getSize();
  }

  /** The search reads blocks that are not drawn. */
  protected override getText_(): string | null {
    this.follow();
    return super.getText_();
  }

  private follow(): void {
    const number = this.number()?.getValue();
    this.fieldGroup_?.classList.toggle(FIXED, number === undefined);
    const sign = Number(number ?? 1);
    const word = sign < 0 ? NEGATIVE : sign > 0 ? POSITIVE : this.getValue();
    // Without an event: the change is the number's.
    if (word !== this.getValue()) this.doValueUpdate_(word ?? POSITIVE);
  }

  protected override showEditor_(event?: MouseEvent): void {
    if (this.number()) super.showEditor_(event);
  }

  protected override onItemSelected_(_menu: Blockly.Menu, item: Blockly.MenuItem): void {
    const number = this.number();
    if (!number || item.getValue() === this.getValue()) return;
    this.doValueUpdate_(item.getValue() ?? POSITIVE);
    this.forceRerender();
    Blockly.Events.setGroup(true);
    number.setValue(-Number(number.getValue()) || 0);
    const type = this.types[this.getValue() ?? ""];
    const block = this.getSourceBlock();
    if (type && block?.type !== type) become(block as Blockly.BlockSvg, type);
    Blockly.Events.setGroup(false);
  }

  /** The field of the number; null if the parameter is calculated. */
  private number(): Blockly.Field | null {
    const parameter = this.name?.slice(0, -END.length) ?? "";
    return this.getSourceBlock()?.getInputTargetBlock(parameter)?.getField("NUM") ?? null;
  }
}

/** The direction that shows the sign of a number; null if the number shows it. */
export function directionOf(number: Blockly.Field): FieldDirection | null {
  const place = number.getSourceBlock()?.outputConnection?.targetConnection;
  const found = place?.getSourceBlock().getField(place.getParentInput()?.name + END);
  return found instanceof FieldDirection ? found : null;
}

/** A number without the sign that a direction shows. A typed sign counts, as in the texts. */
export class SignedNumber extends Blockly.FieldNumber {
  private direction: FieldDirection | null = null;

  /** A number that was dragged to a place with a direction, or away from one, changes its text. */
  override getSize(): Blockly.utils.Size {
    const direction = directionOf(this as Blockly.Field);
    if (direction !== this.direction) this.isDirty_ = true;
    this.direction = direction;
    return super.getSize();
  }

  protected override getText_(): string | null {
    return super.getText_() ?? this.getEditorText_(this.getValue());
  }

  protected override getEditorText_(value: unknown): string {
    const text = super.getEditorText_(value);
    return directionOf(this as Blockly.Field) ? text.replace(/^-/, "") : text;
  }

  protected override getValueFromEditorText_(text: string): string {
    const isNegative = directionOf(this as Blockly.Field)?.isNegative && /^\s*\d/.test(text);
    return isNegative ? `-${text.trim()}` : text;
  }
}

/** Use these fields in all blocks; call it once. */
export function registerDirections(): void {
  Blockly.fieldRegistry.register("lb_direction", FieldDirection);
  Blockly.fieldRegistry.unregister("field_number");
  Blockly.fieldRegistry.register("field_number", SignedNumber);
}
