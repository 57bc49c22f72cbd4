/** Texts of lessons, in the user's language. */

import { language, say } from "../../i18n";
import type { LessonWords } from "../../protocol/messages";

type Text = string | Readonly<Record<string, string>>;

/** A text of a lesson in the user's language, in English, or in the first language that it has. */
export function inLanguage(text: Text = ""): string {
  if (typeof text === "string") return text;
  return text[language.value] ?? text.en ?? Object.values(text)[0] ?? "";
}

export function sayWords({ text = "", phrase = null }: LessonWords): string {
  return phrase ? say(phrase) : inLanguage(text);
}
