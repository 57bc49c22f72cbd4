/** The names that a project and its robots can have. */

import { t } from "../i18n";
import type { ProjectEntry, Tab } from "../protocol/messages";

/** The server's limit in bytes of UTF-8. */
export const LONGEST_PROJECT_NAME = 100;

/** The server's limit for the name of a robot, in characters. */
const LONGEST_ROBOT_NAME = 40;

/** The server's rule: names that files can have everywhere. */
const PLAIN = /^[\p{L}\p{N}](?:[\p{L}\p{N}_ .-]*[\p{L}\p{N}_-])?$/u;

/** Why a project can't have a name; empty if it can. */
export function projectNameFault(name: string): string {
  const wish = name.normalize("NFC");
  const isShort = new TextEncoder().encode(wish).length <= LONGEST_PROJECT_NAME;
  return PLAIN.test(wish) && isShort ? "" : t("project-name-wrong", { name, limit: LONGEST_PROJECT_NAME });
}

/** Why a project can't be renamed; empty if it can. `known` is null until the server has sent the list. */
export function renameFault(name: string, own: string, known: readonly ProjectEntry[] | null): string {
  const isTaken = (known ?? []).some((one) => one.name !== own && folded(one.name) === folded(name));
  return isTaken ? t("project-name-taken", { name }) : projectNameFault(name);
}

/** Why the robot of a tab can't be renamed; empty if it can. */
export function robotNameFault(name: string, own: string, tabs: readonly Tab[]): string {
  const isFree = name === own || tabs.every((tab) => tab.name !== name);
  const isPlain = PLAIN.test(name) && [...name].length <= LONGEST_ROBOT_NAME;
  return isFree && isPlain ? "" : t("tabs-wrong-name", { name, limit: LONGEST_ROBOT_NAME });
}

/** Windows and macOS ignore case in the names of files. */
function folded(name: string): string {
  return name.normalize("NFC").toLowerCase();
}
