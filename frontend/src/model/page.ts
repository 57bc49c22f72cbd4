/** The objects that every component of the page can use. */

import { provided } from "../ui/provided";
import type { Toasts } from "../ui/toasts";
import type { Announcer } from "./announcer";
import type { AskingWhy } from "./asking-why";
import type { Context } from "./context";
import type { Controls } from "./controls";
import type { Dialogs } from "./dialogs";
import type { Ghost } from "./ghost";
import type { KeptRuns } from "./kept-runs";
import type { LookingBack } from "./looking-back";
import type { Project } from "./project";
import type { RobotTabs } from "./robot-tabs";
import type { RunsOn } from "./runs-on";
import type { Views } from "./views";

export interface Page {
  readonly context: Context;
  readonly project: Project;
  readonly tabs: RobotTabs;
  readonly controls: Controls;
  readonly lookingBack: LookingBack;
  readonly askingWhy: AskingWhy;
  /** The twin of a real robot, while the user looks back. */
  readonly ghost: Ghost;
  readonly keptRuns: KeptRuns;
  readonly runsOn: RunsOn;
  readonly views: Views;
  readonly dialogs: Dialogs;
  readonly toasts: Toasts;
  readonly announcer: Announcer;
}

export const [PageProvider, usePage] = provided<Page>("Page");
