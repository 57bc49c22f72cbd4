/** When the parts of the page that are hidden at first are loaded. */

import { effect } from "@preact/signals";

import type { Page } from "../../model/page";
import { whenIdle } from "../../ui/when-idle";

/** Wait until a part is shown or a program runs, or until all that is shown has been drawn and the page is idle. */
export function whenNeeded({ views, context: { running } }: Page, isShown: () => boolean): Promise<void> {
  return new Promise((resolve) => {
    const stop = effect(() => {
      if (isShown() || running.active.value) resolve();
      else if (views.areLoaded.value && running.scene.value) whenIdle(resolve);
      else return;
      // The effect can't stop itself before it has run.
      queueMicrotask(() => stop());
    });
  });
}
