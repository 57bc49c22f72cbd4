/** What the wall says of lessons. */

import { type Phrase, say, t, translated } from "../../i18n";
import type { LessonOffer, MissedCheck } from "../../protocol/classroom";
import type { LessonWords } from "../../protocol/messages";
import { sayWords } from "../lessons/texts";

/** The robots of LearnBlock's own. */
const ALL_ROBOTS = 4;

/** What was missed, by how much if that is known. */
export function missedInWords({ goal, reason }: MissedCheck): string {
  if (reason) return say(reason as unknown as Phrase);
  return sayWords(goal as LessonWords);
}

/** The level, how long it takes, and for which robots it is. */
export function lessonInWords({ level, minutes, robots }: LessonOffer): string {
  return [t("page-class-level", { level }), t("page-lesson-minutes", { minutes }), robotsInWords(robots)].join(" · ");
}

export function robotsInWords(robots: readonly string[]): string {
  const names = robots.map((name) => name.replace(/^sim-/, ""));
  if (names.length >= ALL_ROBOTS) return t("page-class-every-robot");
  return names.map((name) => translated(`page-catalog-robot-${name}`, name)).join(", ");
}

/** The address of a lesson's picture; empty if it has none. */
export function pictureOf({ name, picture = "" }: Pick<LessonOffer, "name" | "picture">): string {
  return picture && `lessons/${encodeURIComponent(name)}/pictures/${encodeURIComponent(picture)}`;
}
