/** Emotions in the user's language. */

import { t } from "../../i18n";

const WORDS: Record<string, string> = {
  fear: "page-camera-fear",
  surprise: "page-camera-surprise",
  anger: "page-camera-anger",
  sadness: "page-camera-sadness",
  disgust: "page-camera-disgust",
  joy: "page-camera-joy",
  neutral: "page-camera-neutral",
};

/** The name of an emotion; null if it is not one. */
export function emotionName(emotion: string): string | null {
  const word = WORDS[emotion];
  return word ? t(word) : null;
}
