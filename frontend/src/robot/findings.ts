/** What was found in a camera's picture, in words. */

import { t } from "../i18n";
import type { Seen } from "../messages";
import { emotionName } from "./emotions";

const SORTS: Record<Seen["sort"], string> = { tag: "robot.tag", face: "robot.face", line: "robot.line" };
const WORDS: Record<string, string> = {
  black: "robot.black",
  red: "robot.red",
  blue: "robot.blue",
  left: "robot.left",
  center: "robot.center",
  right: "robot.right",
};

/** A tag with its number, a face with its feeling, a line with its colour and side. */
export function findingName({ sort, label }: Seen): string {
  if (sort === "face") return faceName(label);
  const words = label.split(" ").map((word) => (WORDS[word] ? t(WORDS[word]) : word));
  return [t(SORTS[sort]), ...words].join(" ").trim();
}

function faceName(emotion: string): string {
  const feeling = emotionName(emotion);
  return feeling ? t("robot.feelingFace", { emotion: feeling }) : t(SORTS.face);
}
