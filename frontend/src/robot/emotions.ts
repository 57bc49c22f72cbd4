/** Emotions in the user's language. */

import { t } from "../i18n";

const WORDS: Record<string, string> = {
  fear: "robot.fear",
  surprise: "robot.surprise",
  anger: "robot.anger",
  sadness: "robot.sadness",
  disgust: "robot.disgust",
  joy: "robot.joy",
  neutral: "robot.neutral",
};

/** What an emotion is called; null for what is none. */
export function emotionName(emotion: string): string | null {
  const word = WORDS[emotion];
  return word ? t(word) : null;
}
