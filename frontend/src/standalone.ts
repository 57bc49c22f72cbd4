/** The entry point of a page in one file, which the server or the command line has filled. */

import { signal } from "@preact/signals";

import type { Content } from "./features/standalone/content";
import { writePicture } from "./features/standalone/picture";
import { startLanguage } from "./i18n";
import "./ui/standalone-fonts.css";
import "./ui/theme.css";

declare const learnblockContent: Content;

async function begin(content: Content): Promise<void> {
  await Promise.all([startLanguage(signal(content.language)), document.fonts.load('1em "Nunito Variable"')]);
  await writePicture(content);
}

void begin(learnblockContent);
