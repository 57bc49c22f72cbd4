/** What pages have in common when they begin: their language, their theme and their fonts. */

import { effect } from "@preact/signals";

import { language, startLanguage } from "../i18n";
import { preferredLanguage, theme } from "../model/preferences";
import { startFonts } from "../ui/fonts";

/** Wait until the page can be read; it follows the language and the theme from then on. */
export async function begin(): Promise<void> {
  effect(() => {
    document.documentElement.lang = language.value;
    document.documentElement.dataset.theme = theme.value;
  });
  await Promise.all([startLanguage(preferredLanguage), startFonts()]);
}
