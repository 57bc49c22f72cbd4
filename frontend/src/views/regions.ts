/** The regions that F6 cycles through. */

import { VIEWS, type Views } from "../model/views";
import type { View } from "../protocol/messages";

const FOCUSABLE =
  'button:not([disabled]), select:not([disabled]), input:not([disabled]), a[href], [tabindex="0"], [contenteditable="true"]';

/** Focus the next or previous region. */
export function nextRegion(views: Views, direction: 1 | -1): void {
  const regions = [...document.querySelectorAll<HTMLElement>("[data-region]")].filter(
    (one) => one.offsetParent !== null,
  );
  const at = regions.findIndex((one) => one.contains(document.activeElement));
  const next = at < 0 && direction < 0 ? -1 : at + direction;
  const region = regions.at(next % regions.length);
  if (region) enterRegion(views, region);
}

/** Focus a region: a view focuses itself, others their first focusable element. */
export function enterRegion(views: Views, region: HTMLElement): void {
  const view = VIEWS.find((one: View) => one === region.dataset.region);
  if (view) views.focus(view);
  if (region.contains(document.activeElement)) return;
  const first = [...region.querySelectorAll<HTMLElement>(FOCUSABLE)].find((one) => one.offsetParent);
  (first ?? region).focus();
}

/** Focus the run button. */
export function focusRun(): void {
  document.querySelector<HTMLElement>(".run-group button")?.focus();
}
