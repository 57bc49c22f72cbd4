/** The entry point of a page in one file, which the server or the command line has filled. */

import { effect, signal } from "@preact/signals";

import { showRun } from "./app/standalone/run";
import { showWorksheet } from "./app/standalone/worksheet";
import type { Content } from "./features/standalone/content";
import { writePicture } from "./features/standalone/picture";
import { language, startLanguage } from "./i18n";
import { theme } from "./model/preferences";
import "./ui/standalone-fonts.css";
import "./ui/theme.css";
import "./ui/controls.css";

declare const learnblockContent: Content;

async function begin(content: Content): Promise<void> {
  await Promise.all([startLanguage(signal(content.language)), document.fonts.load('1em "Nunito Variable"')]);
  effect(() => {
    document.documentElement.lang = language.value;
    document.documentElement.dataset.theme = theme.value;
  });
  if (content.kind === "picture") await writePicture(content);
  else if (content.kind === "worksheet") await showWorksheet(content, document.getElementById("page")!);
  else showRun(content, document.getElementById("page")!);
}

void begin(learnblockContent);
