/** The panel below a field while it is edited, for mouse, finger and keys. */

import * as Blockly from "blockly/core";

import { t } from "../../../i18n";

const { DropDownDiv, WidgetDiv } = Blockly;

/** How a panel closes: Enter keeps the value, Escape restores the old one. */
interface Ending {
  readonly undo: () => void;
  readonly closed?: () => void;
}

/** Open a panel below a field and focus its first element. */
export function openPanel(field: Blockly.Field, content: HTMLElement, { undo, closed }: Ending): void {
  content.className = "lbPanel";
  content.addEventListener("keydown", (event) => {
    if (event.key === "Escape") undo();
    // The panel closes before the browser would click the button.
    if (event.key === "Enter" && event.target instanceof HTMLButtonElement) event.target.click();
    if (event.key === "Escape" || event.key === "Enter") close(field, event);
  });
  DropDownDiv.clearContent();
  DropDownDiv.getContentDiv().replaceChildren(content);
  DropDownDiv.setColour("var(--surface-2)", "var(--border-strong)");
  DropDownDiv.showPositionedByField(field, closed);
  content.querySelector<HTMLElement>("input, button")?.focus({ preventScroll: true });
}

function close(field: Blockly.Field, event: Event): void {
  event.stopPropagation();
  event.preventDefault();
  WidgetDiv.hideIfOwner(field);
  DropDownDiv.hideIfOwner(field);
}

interface Scale {
  readonly min: number;
  readonly max: number;
  readonly step: number;
}

/** A slider with a value. */
export function rangeInput({ min, max, step }: Scale, value: number, take: (value: number) => void): HTMLInputElement {
  const input = document.createElement("input");
  input.type = "range";
  input.min = String(min);
  input.max = String(max);
  input.step = String(step);
  input.value = String(value);
  input.ariaLabel = t("page-blocks-slider");
  input.addEventListener("input", () => take(Number(input.value)));
  return input;
}
