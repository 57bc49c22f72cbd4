/** Runs what was handed in, on the page that shows its run beside the program. */

import { effect, signal } from "@preact/signals";

import type { Page } from "../../model/page";
import { VIEWS } from "../../model/views";
import type { HandInRun } from "../../protocol/classroom";
import type { ShowLine } from "../in-class/noted-line";

/** Once the server is at the step, give it the program, and run it as fast as it can; later runs are to be watched. */
export function runHandIn({ context, lessons }: Pick<Page, "context" | "lessons">): void {
  const { connection, program } = context;
  const wanted = signal<HandInRun | null>(null);
  connection.on("HandInRun", (run) => (wanted.value = run));
  let isFirst = false;
  connection.on("Ended", () => {
    // Not for the end of an earlier run, which an opened project tells, too.
    if (isFirst) connection.send({ kind: "SetSpeed", factor: 1 });
    isFirst = false;
  });
  effect(() => {
    const [run, shown, { blocktext }] = [wanted.value, lessons.shown.value, program.state.value];
    if (!run || !blocktext || shown?.name !== run.lesson || shown.step !== run.step) return;
    wanted.value = null;
    const { text, is_python: isPython } = run.program;
    program.editedText(isPython ? "python" : "blocktext", () => text);
    program.flush();
    isFirst = true;
    connection.send({ kind: "SetSpeed", factor: null });
    connection.send({ kind: "ShowVariant", robot: run.robot, variant: run.variant ?? 0 });
  });
}

/** The program is on the page around this one: have that show the blocks that answers name. */
export function revealAround({ views, context }: Pick<Page, "views" | "context">): void {
  const reveal = (block: string) => {
    const place = context.program.state.peek().places.find(([id]) => id === block);
    const message: ShowLine = { showLine: place?.[1] ?? 0 };
    if (message.showLine) parent.postMessage(message, location.origin);
  };
  const nothing = () => {};
  const dom = document.createElement("div");
  // A narrow page shows the panel of the answer in the place of the program, which is elsewhere here.
  effect(() => {
    if (views.area.value === "panel") views.area.value = "blocks";
  });
  for (const view of VIEWS) views.put(view, { dom, reveal, describeStep: () => "", focus: nothing, destroy: nothing });
}
