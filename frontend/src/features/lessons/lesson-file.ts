/** The file of a lesson. */

import { LIMITS } from "../../protocol/messages";

export const LESSON_FILE = ".lblesson";
/** What may be chosen: a lesson as a file, or as a folder that was zipped by hand. */
export const LESSON_FILES = `${LESSON_FILE},.zip`;
/** The longest name, and the most bytes. */
export const { filename: LONGEST_NAME, content: LARGEST } = LIMITS.ImportLesson;
