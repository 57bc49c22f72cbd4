/** The objects that every component of the page can use. */

import { provided } from "../ui/provided";
import type { Toasts } from "../ui/toasts";
import type { Announcer } from "./announcer";
import type { Context } from "./context";
import type { Controls } from "./controls";
import type { Dialogs } from "./dialogs";
import type { Project } from "./project";
import type { Views } from "./views";

export interface Page {
  readonly context: Context;
  readonly project: Project;
  readonly controls: Controls;
  readonly views: Views;
  readonly dialogs: Dialogs;
  readonly toasts: Toasts;
  readonly announcer: Announcer;
}

export const [PageProvider, usePage] = provided<Page>("Page");
