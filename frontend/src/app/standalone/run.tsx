/** Shows a recorded run with the page's own parts; the recording answers them as a server would. */

import { batch, effect, signal } from "@preact/signals";
import { render } from "preact";

import { RecordedConnection } from "../../features/standalone/connection";
import type { RobotContent, RunContent } from "../../features/standalone/content";
import { RecordedRun } from "../../features/standalone/recorded";
import { RecordedWorld } from "../../features/standalone/world";
import { NO_DRAFTS } from "../../model/drafts";
import { type Page, PageProvider } from "../../model/page";
import type { Scene } from "../../protocol/messages";
import { givePalette } from "../../views/blocks/palette";
import { compose } from "../compose";
import { RunPage } from "./run-page";

export function showRun(content: RunContent, root: HTMLElement): void {
  const { palette, pupil, robots, title } = content;
  givePalette(palette);
  const world = new RecordedWorld(content.scene, content.states);
  const runs = robots.map((robot) => new RecordedRun(robot, (time) => world.robotsAt(time, robot)));
  const [first, run] = [robots[0]!, runs[0]!];
  const connection = new RecordedConnection(run);
  const page = compose({ drafts: NO_DRAFTS, query: "", connection });
  const { context, lookingBack, project, tabs } = page;
  // The title of the page in its tab, too.
  project.name.value = pupil ? `${title} · ${pupil}` : title;
  // They have the colours that they have in the world.
  if (robots.length > 1) tabs.tabs.value = robots.map(({ name, robot }) => ({ name, robot, state: "ended" }));
  const shown = signal(first);
  const choose = (robot: RobotContent) => {
    const [time, run] = [lookingBack.time, runs[robots.indexOf(robot)]!];
    connection.follow(run);
    batch(() => {
      showRobot(page, connection, { ...robot, scene: world.sceneOf(robot) }, run);
      shown.value = robot;
    });
    lookingBack.look(time);
  };
  showRobot(page, connection, { ...first, scene: world.sceneOf(first) }, run);
  effect(() => {
    // There is no present to go back to: a run that is over ends with its last moment.
    if (!context.running.past.value) lookingBack.look(shown.peek().timeline.end);
  });
  lookingBack.look(first.timeline.begin ?? 0);
  render(
    <PageProvider value={page}>
      <RunPage title={title} pupil={pupil} robots={robots} shown={shown} choose={choose} />
    </PageProvider>,
    root,
  );
}

interface ShownRobot extends RobotContent {
  readonly scene: Scene;
}

/** Show a robot of the run, at its end. */
function showRobot({ context }: Page, connection: RecordedConnection, robot: ShownRobot, run: RecordedRun): void {
  const { workspace, blocktext, python, places, scene, timeline } = robot;
  // It forgets the robot that was shown before.
  connection.show({ kind: "RunState", state: "idle" });
  context.program.state.value = { ...context.program.state.peek(), workspace, blocktext, python, places };
  connection.show(scene);
  connection.show({ kind: "RunState", state: "ended" });
  connection.show(timeline);
  const { telemetry } = run.end;
  if (telemetry) connection.show(telemetry);
}
