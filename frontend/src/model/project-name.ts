/** The names that a project can have. */

import { t } from "../i18n";

/** The server's limit in bytes of UTF-8. */
export const LONGEST_PROJECT_NAME = 100;

/** The server's rule: names that files can have everywhere. */
const PLAIN = /^[\p{L}\p{N}](?:[\p{L}\p{N}_ .-]*[\p{L}\p{N}_-])?$/u;

/** Why a project can't have a name; empty if it can. */
export function projectNameFault(name: string): string {
  const wish = name.normalize("NFC");
  const isShort = new TextEncoder().encode(wish).length <= LONGEST_PROJECT_NAME;
  return PLAIN.test(wish) && isShort ? "" : t("project-name-wrong", { name, limit: LONGEST_PROJECT_NAME });
}
