/** The entry point of the page. */

import { render } from "preact";

import { App } from "./app/app";
import { begin } from "./app/begin";
import { compose } from "./app/compose";
import { listen } from "./app/shortcuts";
import { t } from "./i18n";
import { isHeard } from "./model/loudness";
import { type Page, PageProvider } from "./model/page";

async function sound({ context, classNews, project, toasts }: Page): Promise<void> {
  const { startSound } = await import("./views/output/sound");
  const sayWhere = () => {
    toasts.note(t("page-console-heard-here", { robot: project.robotTitle(context.running.robot.value) }));
  };
  startSound(context, () => isHeard(classNews.now.value !== null), sayWhere);
}

async function pictures(page: Page): Promise<void> {
  const { keepPictures } = await import("./features/start/keep-pictures");
  keepPictures(page);
}

async function show(root: HTMLElement): Promise<void> {
  const readable = begin();
  const page = compose();
  addEventListener("pagehide", () => page.context.program.flush());
  listen(page);
  page.context.connection.open();
  await readable;
  render(
    <PageProvider value={page}>
      <App />
    </PageProvider>,
    root,
  );
  void sound(page);
  void install();
  void pictures(page);
  expose(page);
}

/** Let the browser install the page as an app; browsers allow it on this computer and with HTTPS. */
async function install(): Promise<void> {
  try {
    await navigator.serviceWorker?.register("./service-worker.js");
  } catch (error) {
    // The page works without it, for example in a private window.
    console.info(error);
  }
}

/** For benchmarks; enabled by `?test` in the address. */
function expose(page: Page): void {
  if (new URLSearchParams(location.search).has("test")) Object.assign(globalThis, { learnblock: page });
}

const root = document.getElementById("page");
if (root) void show(root);
