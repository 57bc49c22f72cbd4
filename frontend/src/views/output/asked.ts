/** A program's question, where the console is not open. */

import type { Context } from "../../model/context";
import type { Island } from "../../ui/island";
import { createQuestion } from "./question";

export function createAsked({ running }: Context): Island {
  return createQuestion(running.dialogue);
}
