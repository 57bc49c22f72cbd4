/** Creates the objects of the page and connects them. */

import type { ComponentChildren } from "preact";

import { BlockSets, BlockSetsProvider } from "../features/block-sets/block-sets";
import { Containment, ContainmentProvider } from "../features/containment/containment";
import { CustomBlocks, CustomBlocksProvider } from "../features/custom-blocks/custom-blocks";
import { Libraries, LibrariesProvider } from "../features/libraries/libraries";
import { RobotMaker, RobotMakerProvider } from "../features/new-robot/robot-maker";
import { RobotSettings, RobotSettingsProvider } from "../features/robot-settings/robot-settings";
import { TagDictionary, TagDictionaryProvider } from "../features/tags/tag-dictionary";
import { Worlds, WorldsProvider } from "../features/worlds/worlds";
import { Announcer } from "../model/announcer";
import type { Context } from "../model/context";
import { Controls } from "../model/controls";
import { Dialogs } from "../model/dialogs";
import { BrowserDrafts } from "../model/drafts";
import { type Page, PageProvider } from "../model/page";
import { Program } from "../model/program";
import { Project } from "../model/project";
import { runError } from "../model/run-error";
import { Running } from "../model/running";
import { Views } from "../model/views";
import { socketAddress, takeToken } from "../protocol/address";
import { Connection } from "../protocol/connection";
import { Toasts } from "../ui/toasts";

/** The state of each feature; it listens to the server from the start. */
interface Stores {
  readonly blockSets: BlockSets;
  readonly containment: Containment;
  readonly customBlocks: CustomBlocks;
  readonly libraries: Libraries;
  readonly robotMaker: RobotMaker;
  readonly robotSettings: RobotSettings;
  readonly tags: TagDictionary;
  readonly worlds: Worlds;
}

export interface Composition {
  readonly page: Page;
  readonly stores: Stores;
}

export function compose(): Composition {
  const connection = new Connection(socketAddress(), takeToken());
  const toasts = new Toasts();
  const dialogs = new Dialogs();
  const stores = makeStores(connection, toasts, dialogs);
  return { page: makePage(connection, toasts, dialogs, stores), stores };
}

function makeStores(connection: Connection, toasts: Toasts, dialogs: Dialogs): Stores {
  return {
    blockSets: new BlockSets(connection),
    containment: new Containment(connection, toasts, () => dialogs.show("containment")),
    customBlocks: new CustomBlocks(connection),
    libraries: new Libraries(connection),
    robotMaker: new RobotMaker(connection),
    robotSettings: new RobotSettings(connection),
    tags: new TagDictionary(connection),
    worlds: new Worlds(connection, toasts),
  };
}

function makePage(connection: Connection, toasts: Toasts, dialogs: Dialogs, stores: Stores): Page {
  const { blockSets, customBlocks, tags } = stores;
  const program = new Program(connection, new BrowserDrafts());
  const running = new Running(connection);
  const views = new Views();
  const context: Context = {
    connection,
    program,
    running,
    runError: runError(program, running),
    customBlocks: customBlocks.blocks,
    tagNames: tags.names,
    shownBlocks: blockSets.shown,
    reveal: (block) => views.reveal(block),
    listCustomBlocks: () => dialogs.show("customBlocks"),
    editCustomBlock: (name, line = 0) => dialogs.show({ customBlock: name, line }),
  };
  const project = new Project(connection, program, toasts);
  return {
    context,
    views,
    toasts,
    project,
    controls: new Controls(context),
    dialogs,
    announcer: new Announcer(context),
  };
}

/** Provides the page and the features' state to the components below. */
export function Providers({ of: { page, stores }, children }: { of: Composition; children: ComponentChildren }) {
  return (
    <PageProvider value={page}>
      <BlockSetsProvider value={stores.blockSets}>
        <ContainmentProvider value={stores.containment}>
          <CustomBlocksProvider value={stores.customBlocks}>
            <LibrariesProvider value={stores.libraries}>
              <RobotMakerProvider value={stores.robotMaker}>
                <RobotSettingsProvider value={stores.robotSettings}>
                  <TagDictionaryProvider value={stores.tags}>
                    <WorldsProvider value={stores.worlds}>{children}</WorldsProvider>
                  </TagDictionaryProvider>
                </RobotSettingsProvider>
              </RobotMakerProvider>
            </LibrariesProvider>
          </CustomBlocksProvider>
        </ContainmentProvider>
      </BlockSetsProvider>
    </PageProvider>
  );
}
