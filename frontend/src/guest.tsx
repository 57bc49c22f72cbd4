/** The entry point of a guest's view: the world of the classmate who has invited the pupil. */

import { effect } from "@preact/signals";
import { render } from "preact";

import { compose } from "./app/compose";
import { GuestPage } from "./app/guest-page";
import { language, startLanguage } from "./i18n";
import { PageProvider } from "./model/page";
import { preferredLanguage, theme } from "./model/preferences";
import { startFonts } from "./ui/fonts";

/** A guest edits nothing here. */
const NO_DRAFTS = { keep: () => {}, forget: () => {}, left: async () => [] };

async function begin(root: HTMLElement): Promise<void> {
  effect(() => {
    document.documentElement.lang = language.value;
    document.documentElement.dataset.theme = theme.value;
  });
  const page = compose({ drafts: NO_DRAFTS, query: "" });
  page.askingWhy.isOff = true;
  page.context.connection.open();
  await Promise.all([startLanguage(preferredLanguage), startFonts()]);
  render(
    <PageProvider value={page}>
      <GuestPage />
    </PageProvider>,
    root,
  );
}

void begin(document.getElementById("page")!);
