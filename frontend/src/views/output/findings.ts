/** Names for what was recognised in a camera's picture. */

import { t } from "../../i18n";
import type { Seen } from "../../protocol/messages";
import { emotionName } from "./emotions";

const SORTS: Record<Seen["sort"], string> = {
  tag: "page-camera-tag",
  face: "page-camera-face",
  line: "page-camera-line",
  object: "page-camera-object",
};
const WORDS: Record<string, string> = {
  black: "page-camera-black",
  red: "page-camera-red",
  blue: "page-camera-blue",
  left: "page-camera-left",
  center: "page-camera-center",
  right: "page-camera-right",
};

/** A tag with its number, a face with its emotion, a line with its colour and side, a thing with its colour. */
export function findingName({ sort, label }: Seen): string {
  if (sort === "face") return faceName(label);
  if (sort === "object") return t(SORTS[sort], { colour: label });
  const words = label.split(" ").map((word) => (WORDS[word] ? t(WORDS[word]) : word));
  return [t(SORTS[sort]), ...words].join(" ").trim();
}

function faceName(emotion: string): string {
  const feeling = emotionName(emotion);
  return feeling ? t("page-camera-feeling-face", { emotion: feeling }) : t(SORTS.face);
}
