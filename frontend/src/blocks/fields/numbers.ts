/** Fields for numbers: one within a range, and an angle. */

import * as Blockly from "blockly/core";

import { t } from "../../i18n";
import { allowedAt } from "./allowed";
import { Dial } from "./dial";
import { openPanel, rangeInput } from "./panel";

/** Of a slider whose parameter has no end there. */
const LEAST = 0;
const MOST = 100;
/** Steps of a slider whose parameter allows every number. */
const STEPS = 100;
const ANGLES = { min: -180, max: 180, step: 5 };

/**
 * A number that is typed, or set in a panel below.
 *
 * It never corrects what a program says: the check warns of a number that is out of range.
 */
abstract class PanelNumber extends Blockly.FieldNumber {
  /** What to set the number with. */
  protected abstract panel(): HTMLElement;

  protected override showEditor_(event?: Event): void {
    // Without the focus, and with the panel to give it back.
    super.showEditor_(event, true, false);
    const before = this.getValue();
    openPanel(this as Blockly.Field, this.panel(), { undo: () => this.take(Number(before)) });
  }

  /** A value in passing: it is told when the panel closes. */
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
    const { min = LEAST, max = Math.max(MOST, min), step = (max - min) / STEPS || 1 } = allowedAt(this as Blockly.Field);
    const panel = document.createElement("div");
    const ends = [min, max].map((end) => Object.assign(document.createElement("span"), { textContent: String(end) }));
    const slider = rangeInput({ min, max, step }, Number(this.getValue()), (value) => this.take(value));
    panel.append(ends[0]!, slider, ends[1]!);
    return panel;
  }

  override getAriaTypeName(): string {
    return t("blocks.slider");
  }
}

/** Degrees clockwise, as a robot turns: set by a dial. */
export class FieldAngle extends PanelNumber {
  private dial: Dial | null = null;

  protected override panel(): HTMLElement {
    const panel = document.createElement("div");
    const slider = rangeInput(ANGLES, Number(this.getValue()), (value) => this.take(value));
    slider.ariaLabel = t("blocks.angle");
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

  protected override getText_(): string | null {
    return super.getText_() ?? `${this.getValue()}°`;
  }

  override getAriaTypeName(): string {
    return t("blocks.angle");
  }
}
