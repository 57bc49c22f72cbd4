/** Shows a recorded run with the page's own parts; the recording answers them as a server would. */

import { effect } from "@preact/signals";
import { render } from "preact";

import { RecordedConnection } from "../../features/standalone/connection";
import type { RunContent } from "../../features/standalone/content";
import { RecordedRun } from "../../features/standalone/recorded";
import { PageProvider } from "../../model/page";
import { givePalette } from "../../views/blocks/palette";
import { compose } from "../compose";
import { RunPage } from "./run-page";

/** Nothing is edited. */
const NO_DRAFTS = { keep: () => {}, forget: () => {}, left: async () => [] };

export function showRun(content: RunContent, root: HTMLElement): void {
  givePalette(content.palette);
  const run = new RecordedRun(content);
  const connection = new RecordedConnection(run);
  const page = compose({ drafts: NO_DRAFTS, query: "", connection });
  const { context, lookingBack, project } = page;
  const { workspace, blocktext, python, places, scene, timeline, title, robot, printed } = content;
  context.program.state.value = { ...context.program.state.peek(), workspace, blocktext, python, places };
  project.name.value = title;
  connection.show(scene);
  connection.show({ kind: "RunState", state: "ended" });
  connection.show(timeline);
  const { telemetry } = run.end;
  if (telemetry) connection.show(telemetry);
  effect(() => {
    // There is no present to go back to: a run that is over ends with its last moment.
    if (!context.running.past.value) lookingBack.look(timeline.end);
  });
  lookingBack.look(timeline.begin ?? 0);
  render(
    <PageProvider value={page}>
      <RunPage title={title} robot={robot} printed={printed} />
    </PageProvider>,
    root,
  );
}
