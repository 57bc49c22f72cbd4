/** Fields for numbers: one within a range, and an angle. */

import * as Blockly from "blockly/core";

import { t } from "../../../i18n";
import { allowedAt } from "./allowed";
import { Dial } from "./dial";
import { SignedNumber } from "./direction";
import { openPanel, rangeInput } from "./panel";

/** The ends of a slider for a parameter without limits. */
const LEAST = 0;
const MOST = 100;
/** The number of steps of a slider for real numbers. */
const STEPS = 100;
const ANGLES = { min: -180, max: 180, step: 5 };

/**
 * A number that is typed, or set in a panel.
 *
 * It never corrects a program: the check warns about numbers out of range.
 */
abstract class PanelNumber extends SignedNumber {
  /** The control in the panel. */
  protected abstract panel(): HTMLElement;

  protected override showEditor_(event?: Event): void {
    // The panel has the focus and returns it.
    super.showEditor_(event, true, false);
    const before = this.getValue();
    const panel = this.panel();
    panel.addEventListener("keydown", (event) => this.type(event));
    openPanel(this as Blockly.Field, panel, { undo: () => this.take(Number(before)) });
  }

  /** A digit replaces the number, as in a field without a panel. */
  private type({ key }: KeyboardEvent): void {
    if (!/^[\d.-]$/.test(key)) return;
    this.htmlInput_?.focus();
    this.htmlInput_?.select();
  }

  /** An intermediate value: the edit is reported when the panel closes. */
  protected take(value: number): void {
    const old = this.getValue();
    this.setEditorValue_(value, false);
    const Change = Blockly.Events.BlockFieldIntermediateChange;
    const block = this.getSourceBlock();
    if (block) Blockly.Events.fire(new Change(block, this.name, old, this.getValue()));
    this.resizeEditor_();
  }
}

/** A number within a range, set by a slider. */
export class FieldSlider extends PanelNumber {
  protected override panel(): HTMLElement {
    const {
      min = LEAST,
      max = Math.max(MOST, min),
      step = (max - min) / STEPS || 1,
    } = allowedAt(this as Blockly.Field);
    const panel = document.createElement("div");
    const ends = [min, max].map((end) => Object.assign(document.createElement("span"), { textContent: String(end) }));
    const slider = rangeInput({ min, max, step }, Number(this.getValue()), (value) => this.take(value));
    panel.append(ends[0]!, slider, ends[1]!);
    return panel;
  }

  override getAriaTypeName(): string {
    return t("page-blocks-slider");
  }
}

/** An angle in degrees clockwise, set by a dial; the sentence around it has the unit. */
export class FieldAngle extends PanelNumber {
  private dial: Dial | null = null;

  protected override panel(): HTMLElement {
    const panel = document.createElement("div");
    const slider = rangeInput(ANGLES, Number(this.getValue()), (value) => this.take(value));
    slider.ariaLabel = t("page-blocks-angle");
    this.dial = new Dial(ANGLES.step, (value) => {
      slider.value = String(value);
      this.take(value);
    });
    this.dial.show(Number(this.getValue()));
    panel.append(this.dial.dom, slider);
    return panel;
  }

  protected override take(value: number): void {
    super.take(value);
    this.dial?.show(value);
  }

  override getAriaTypeName(): string {
    return t("page-blocks-angle");
  }
}
