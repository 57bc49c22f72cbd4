/** Creates the objects of the page and connects them. */

import { computed } from "@preact/signals";

import { BlockSets } from "../features/block-sets/block-sets";
import { Containment } from "../features/containment/containment";
import { CustomBlocks } from "../features/custom-blocks/custom-blocks";
import { HandInNews } from "../features/in-class/hand-ins";
import { ClassNews } from "../features/in-class/in-class";
import { Pairs } from "../features/in-class/pairs";
import { ShownPrograms } from "../features/in-class/shown-programs";
import { Lessons } from "../features/lessons/lessons";
import { LessonMaking } from "../features/lessons/making";
import { Libraries } from "../features/libraries/libraries";
import { RobotMaker } from "../features/new-robot/robot-maker";
import { Replay } from "../features/replay/replay";
import { RobotSettings } from "../features/robot-settings/robot-settings";
import { Links } from "../features/share/links";
import { Share } from "../features/share/share";
import { TagDictionary } from "../features/tags/tag-dictionary";
import { Classes } from "../features/teachers/classes";
import { WorldPictures } from "../features/worlds/pictures";
import { Worlds } from "../features/worlds/worlds";
import { t } from "../i18n";
import { Announcer } from "../model/announcer";
import { AskingWhy } from "../model/asking-why";
import { beginAnew } from "../model/beginning-anew";
import { Connect } from "../model/connect";
import type { Context } from "../model/context";
import { Controls } from "../model/controls";
import { Dialogs } from "../model/dialogs";
import { BrowserDrafts, type Drafts } from "../model/drafts";
import { Ghost } from "../model/ghost";
import { KeptRuns } from "../model/kept-runs";
import { LookingBack } from "../model/looking-back";
import type { Page } from "../model/page";
import { Program } from "../model/program";
import { Project } from "../model/project";
import { RobotTabs } from "../model/robot-tabs";
import { runError } from "../model/run-error";
import { Running } from "../model/running";
import { RunsOn } from "../model/runs-on";
import { Views } from "../model/views";
import { socketAddress, takeToken } from "../protocol/address";
import { Connection } from "../protocol/connection";
import { Toasts } from "../ui/toasts";

/** The parts of the page that listen to the server and need little else. */
type Stores = ReturnType<typeof makeStores>;

interface Place {
  /** What keeps edits until they are saved. */
  readonly drafts: Drafts;
  /** What the address of the connection says besides the path. */
  readonly query: string;
  /** Instead of one to the server. */
  readonly connection?: Connection;
}

export function compose(place: Place = { drafts: new BrowserDrafts(), query: "" }): Page {
  const { drafts, query, connection = connectionTo(query) } = place;
  const toasts = new Toasts();
  const dialogs = new Dialogs();
  const stores = makeStores(connection, toasts, dialogs);
  const model = makeModel(connection, toasts, dialogs, { ...stores, drafts });
  const { announcer, context } = model;
  const lessons = new Lessons(connection, { program: context.program, announcer, toasts });
  const lessonMaking = new LessonMaking(connection, { program: context.program, dialogs, toasts, lessons });
  stores.handIns.follow(context.program.state, lessons.shown);
  const links = new Links(connection, model.project, toasts);
  const share = new Share(model);
  const replay = new Replay({ ...model, share });
  const page = { ...model, ...stores, lessons, lessonMaking, links, share, replay };
  connect(page);
  return page;
}

function connectionTo(query: string): Connection {
  const address = socketAddress();
  address.search = query;
  return new Connection(address, takeToken());
}

/** Let a new connection and an opened project change the parts of the page, in this order. */
function connect(page: Page): void {
  const { program, running } = page.context;
  beginAnew(page.context.connection, {
    // It is known who only reads before the project is opened again, and whose it is after that.
    connected: [page.connect, page.containment, program, page.project, page.lessons, page.links],
    // The program comes before what shows it. The survey takes a moment, so the project comes first.
    reset: [
      program,
      page.tabs,
      running,
      page.lookingBack,
      page.keptRuns,
      page.project,
      page.lessons,
      page.links,
      page.blockSets,
      page.customBlocks,
      page.containment,
    ],
  });
}

function makeStores(connection: Connection, toasts: Toasts, dialogs: Dialogs) {
  return {
    blockSets: new BlockSets(connection),
    classNews: new ClassNews(connection),
    classes: new Classes(connection),
    connect: new Connect(connection),
    containment: new Containment(connection, toasts, () => dialogs.show("containment")),
    customBlocks: new CustomBlocks(connection),
    handIns: new HandInNews(connection),
    libraries: new Libraries(connection),
    pairs: new Pairs(connection),
    shownPrograms: new ShownPrograms(connection),
    robotMaker: new RobotMaker(connection),
    robotSettings: new RobotSettings(connection),
    tags: new TagDictionary(connection),
    worlds: new Worlds(connection, toasts),
    worldPictures: new WorldPictures(connection),
  };
}

/** What finds statements and mistakes in the views of a program. */
function places(views: Views, program: Program): Pick<Context, "openView" | "reveal" | "goTo" | "describeStep"> {
  return {
    openView: computed(() => views.programView(program.state.value.origin)),
    reveal: (block) => views.reveal(block),
    goTo: (problem) => views.goTo(problem),
    describeStep: (view, block) => views.describeStep(view, block),
  };
}

/** The dialogs in which own and custom blocks are made. */
function blockDialogs(dialogs: Dialogs): Pick<Context, "makeBlock" | "listCustomBlocks" | "editCustomBlock"> {
  return {
    makeBlock: (makeBlock) => dialogs.show({ makeBlock }),
    listCustomBlocks: () => dialogs.show("customBlocks"),
    editCustomBlock: (name, line = 0) => dialogs.show({ customBlock: name, line }),
  };
}

function makeModel(
  connection: Connection,
  toasts: Toasts,
  dialogs: Dialogs,
  stores: Stores & { readonly drafts: Drafts },
) {
  const { blockSets, customBlocks, tags } = stores;
  const program = new Program(connection, stores.drafts);
  const tabs = new RobotTabs(connection, program);
  const running = new Running(connection);
  const views = new Views();
  const lookingBack = new LookingBack(running, connection);
  const askingWhy = new AskingWhy(connection, running, () => views.showPanel("why"));
  const ghost = new Ghost(connection, running);
  const context: Context = {
    connection,
    robots: computed(() => project.welcome.value?.robots ?? []),
    program,
    running,
    runError: runError(program, running),
    customBlocks: customBlocks.blocks,
    tagNames: tags.names,
    noted: stores.handIns.noted,
    ways: computed(() => (keptRuns.ways.value.length > 0 ? keptRuns.ways.value : ghost.ways.value)),
    ghost: ghost.robot,
    shownBlocks: blockSets.shown,
    ...places(views, program),
    select: (block) => (views.selected.value = block),
    robotColor: (name) => (tabs.tabs.value.length > 0 ? tabs.colorOf(name) : null),
    lookingBack,
    askingWhy,
    ...blockDialogs(dialogs),
    openExample: (program) => void project.import(new File([program], `${t("page-help-example")}.bt`)),
  };
  const project = new Project(connection, program, toasts, tabs);
  const forgetQuestions = () => {
    askingWhy.questions.value = askingWhy.answer.value = null;
  };
  const keptRuns = new KeptRuns(connection, project.name, { program, running, lookingBack, toasts, forgetQuestions });
  return {
    context,
    views,
    toasts,
    project,
    tabs,
    controls: new Controls(context),
    lookingBack,
    ghost,
    keptRuns,
    askingWhy,
    runsOn: new RunsOn(connection, program, project.name),
    dialogs,
    announcer: new Announcer(context),
  };
}
