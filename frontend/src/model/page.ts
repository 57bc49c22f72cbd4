/**
 * The objects that every component of the page can use.
 *
 * A feature with state of its own declares it as one more property, beside its class:
 * `declare module "../../model/page" { interface Page { readonly tags: TagDictionary } }`.
 * `app/compose.ts` makes them all.
 */

import { createContext } from "preact";
import { useContext } from "preact/hooks";

import type { Toasts } from "../ui/toasts";
import type { Announcer } from "./announcer";
import type { AskingWhy } from "./asking-why";
import type { Connect } from "./connect";
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
  readonly connect: Connect;
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

const Provided = createContext<Page | null>(null);

/** Gives the page to the components below it. */
export const PageProvider = Provided.Provider;

/** The page, in a component below its provider. */
export function usePage(): Page {
  const page = useContext(Provided);
  if (page === null) throw new Error("The page is used outside its provider");
  return page;
}
