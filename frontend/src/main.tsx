/** The page begins. */

import { effect } from "@preact/signals";
import { render } from "preact";

import { socketAddress, takeToken } from "./chrome/address";
import { Announcer } from "./chrome/notes/announcer";
import { App } from "./chrome/app";
import { Controls } from "./chrome/controls";
import { Dialogs } from "./chrome/dialogs/dialogs";
import { PageContext, type Page } from "./chrome/page";
import { Project } from "./chrome/project";
import { listen } from "./chrome/shortcuts";
import { Toasts } from "./chrome/notes/toasts";
import { Views } from "./chrome/views";
import { Connection } from "./connection";
import type { Context } from "./context";
import { BlockSetLibrary } from "./blocksets/library";
import { language } from "./i18n";
import { LibraryShelf } from "./libraries/shelf";
import { Shelf } from "./ownblocks/shelf";
import { MachineSettings } from "./machine/settings";
import { RobotMaker } from "./newrobot/maker";
import { theme } from "./preferences";
import { Program } from "./program";
import { runError } from "./runerror";
import { Running } from "./running";
import { TagDictionary } from "./tags/dictionary";

function assemble(): Page {
  const connection = new Connection(socketAddress(), takeToken());
  const program = new Program(connection);
  const running = new Running(connection);
  const views = new Views();
  const dialogs = new Dialogs();
  const shelf = new Shelf(connection);
  const tags = new TagDictionary(connection);
  const blockSets = new BlockSetLibrary(connection);
  const context: Context = {
    connection,
    program,
    running,
    runError: runError(program, running),
    ownBlocks: shelf.blocks,
    tagNames: tags.names,
    shownBlocks: blockSets.shown,
    reveal: (block) => views.reveal(block),
    listOwnBlocks: () => dialogs.show("ownBlocks"),
    editOwnBlock: (name, line = 0) => dialogs.show({ ownBlock: name, line }),
  };
  const toasts = new Toasts();
  return {
    context,
    views,
    toasts,
    project: new Project(connection, program, toasts),
    controls: new Controls(context),
    dialogs,
    blockSets,
    tags,
    machine: new MachineSettings(connection),
    robotMaker: new RobotMaker(connection),
    shelf,
    libraries: new LibraryShelf(connection),
    announcer: new Announcer(context),
  };
}

async function sound({ context }: Page): Promise<void> {
  const { startSound } = await import("./robot/sound");
  startSound(context);
}

function begin(root: HTMLElement): void {
  const page = assemble();
  effect(() => {
    document.documentElement.lang = language.value;
    document.documentElement.dataset.theme = theme.value;
  });
  addEventListener("pagehide", () => page.context.program.flush());
  listen(page);
  page.context.connection.open();
  render(
    <PageContext.Provider value={page}>
      <App />
    </PageContext.Provider>,
    root,
  );
  void sound(page);
  expose(page);
}

/** For benchmarks, which ask for it in the address: `?test`. */
function expose(page: Page): void {
  if (new URLSearchParams(location.search).has("test")) Object.assign(globalThis, { learnblock: page });
}

const root = document.getElementById("page");
if (root) begin(root);
