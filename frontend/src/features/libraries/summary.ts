/** A library's title and description. */

import { language } from "../../i18n";
import type { InstalledLibrary } from "../../protocol/messages";

/** The library's title in the user's language, or else its name. */
export function titleOf({ name, title = {} }: InstalledLibrary): string {
  return title[language.value] ?? title.en ?? name;
}

/** The import line, the version and the skills. */
export function described({ name, version = "", skills = [] }: InstalledLibrary): string {
  return [`import "${name}"`, version, skills.join(", ")].filter(Boolean).join(" · ");
}
