/** What every component of the chrome is given. */

import { createContext } from "preact";
import { useContext } from "preact/hooks";

import type { BlockSetLibrary } from "../blocksets/library";
import type { Context } from "../context";
import type { Announcer } from "./notes/announcer";
import type { Controls } from "./controls";
import type { Dialogs } from "./dialogs/dialogs";
import type { LibraryShelf } from "../libraries/shelf";
import type { Shelf } from "../ownblocks/shelf";
import type { MachineSettings } from "../machine/settings";
import type { RobotMaker } from "../newrobot/maker";
import type { TagDictionary } from "../tags/dictionary";
import type { Project } from "./project";
import type { Toasts } from "./notes/toasts";
import type { Views } from "./views";

export interface Page {
  readonly context: Context;
  readonly project: Project;
  readonly controls: Controls;
  readonly views: Views;
  readonly dialogs: Dialogs;
  readonly blockSets: BlockSetLibrary;
  readonly tags: TagDictionary;
  readonly machine: MachineSettings;
  readonly robotMaker: RobotMaker;
  readonly shelf: Shelf;
  readonly libraries: LibraryShelf;
  readonly toasts: Toasts;
  readonly announcer: Announcer;
}

export const PageContext = createContext<Page | null>(null);

export function usePage(): Page {
  const page = useContext(PageContext);
  if (!page) throw new Error("a component of the page stands outside it");
  return page;
}
