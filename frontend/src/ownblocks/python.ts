/** Python with what a block's code may say: the robot's skills, and the names in it. */

import {
  autocompletion,
  closeBrackets,
  closeBracketsKeymap,
  completeAnyWord,
  completionKeymap,
  type Completion,
  type CompletionContext,
  type CompletionResult,
  type CompletionSource,
} from "@codemirror/autocomplete";
import { globalCompletion, localCompletionSource, python as pythonLanguage } from "@codemirror/lang-python";
import type { Extension } from "@codemirror/state";
import { keymap } from "@codemirror/view";

import { SKILL } from "../blocks/menus";
import type { Palette } from "../blocks/palette";

const BEHIND_DOT = /[\p{L}_][\p{L}\p{N}_]*\.[\p{L}\p{N}_]*$/u;
const NAME = /^[\p{L}\p{N}_]*$/u;
const GENERAL = [localCompletionSource, globalCompletion, completeAnyWord].map(exceptBehindDot);

/** What a block's definition says to a reader. */
interface Described {
  readonly type: string;
  readonly args0?: readonly { readonly name?: string }[];
  readonly tooltip?: string;
}

/** Python's highlighting and completion; the skills come with the palette. */
export function python(palette: Promise<Palette>): Extension {
  const skills = palette.then(({ definitions }) => (definitions as readonly Described[]).flatMap(skill));
  return [
    pythonLanguage(),
    autocompletion({ override: [(context) => ofRobot(context, skills), ...GENERAL] }),
    closeBrackets(),
    keymap.of([...completionKeymap, ...closeBracketsKeymap]),
  ];
}

/** Behind a dot stand the robot's skills and nothing else. */
function exceptBehindDot(source: CompletionSource): CompletionSource {
  return (context) => (context.matchBefore(BEHIND_DOT) ? null : source(context));
}

async function ofRobot(context: CompletionContext, skills: Promise<readonly Completion[]>): Promise<CompletionResult | null> {
  const found = context.matchBefore(BEHIND_DOT);
  if (!found) return null;
  return { from: found.from + found.text.indexOf(".") + 1, options: await skills, validFor: NAME };
}

function skill({ type, args0 = [], tooltip = "" }: Described): Completion[] {
  if (!type.startsWith(SKILL)) return [];
  const parameters = args0.map(({ name }) => name).join(", ");
  return [{ label: type.slice(SKILL.length), type: "skill", detail: `(${parameters})`, info: tooltip }];
}
