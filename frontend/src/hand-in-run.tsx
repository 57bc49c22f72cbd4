/** The entry point of the run beside a hand-in: the page's world, timeline and "why", without the rest. */

import { effect } from "@preact/signals";
import { render } from "preact";

import { compose } from "./app/compose";
import { HandInRunPage } from "./app/hand-in-run-page";
import { revealAround, runHandIn } from "./features/hand-ins/run";
import { language, startLanguage } from "./i18n";
import { PageProvider } from "./model/page";
import { preferredLanguage, theme } from "./model/preferences";
import { startFonts } from "./ui/fonts";

/** What is sent to run is no edit of the teacher's, so nothing of it is kept in the browser. */
const NO_DRAFTS = { keep: () => {}, forget: () => {}, left: async () => [] };

async function begin(root: HTMLElement): Promise<void> {
  effect(() => {
    document.documentElement.lang = language.value;
    document.documentElement.dataset.theme = theme.value;
  });
  const page = compose({ drafts: NO_DRAFTS, query: location.search });
  runHandIn(page);
  revealAround(page);
  page.context.connection.open();
  await Promise.all([startLanguage(preferredLanguage), startFonts()]);
  render(
    <PageProvider value={page}>
      <HandInRunPage />
    </PageProvider>,
    root,
  );
}

void begin(document.getElementById("page")!);
