/** Opens an example and runs it as soon as its world can be seen. */

import type { ReadonlySignal } from "@preact/signals";

import type { Page } from "../../model/page";
import type { ExampleChoice } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import { plainTitle } from "../examples/words";

export async function tryExample(page: Page, example: ExampleChoice): Promise<void> {
  const { context, controls, project, views } = page;
  const opened = nextScene(page);
  project.openExample(plainTitle(example), example.name);
  if (!(await opened)) return;
  await present(views.world);
  if (!context.running.active.value) controls.run();
}

/** Wait until a signal has a value. */
function present(wanted: ReadonlySignal<unknown>): Promise<void> {
  return new Promise((resolve) => {
    const stop = wanted.subscribe((value) => {
      if (!value) return;
      // On the first call there is nothing to stop yet.
      queueMicrotask(() => stop());
      resolve();
    });
  });
}

/** Whether the server sends a scene; false if it refuses to open the example. */
function nextScene({ context: { connection } }: Page): Promise<boolean> {
  return new Promise((resolve) => {
    const cleanup = new Cleanup(
      connection.on("Scene", () => end(true)),
      connection.onRefused(["OpenExample"], () => end(false)),
    );
    const end = (came: boolean) => {
      cleanup.dispose();
      resolve(came);
    };
  });
}
