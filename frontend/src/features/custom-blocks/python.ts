/** Python for custom blocks: completes the robot's skills and the names in the code. */

import {
  autocompletion,
  type Completion,
  type CompletionContext,
  type CompletionResult,
  type CompletionSource,
  closeBrackets,
  closeBracketsKeymap,
  completeAnyWord,
  completionKeymap,
} from "@codemirror/autocomplete";
import { globalCompletion, localCompletionSource, python as pythonLanguage } from "@codemirror/lang-python";
import type { Extension } from "@codemirror/state";
import { keymap } from "@codemirror/view";

import { SKILL } from "../../views/blocks/menus";
import type { Palette } from "../../views/blocks/palette";

const BEHIND_DOT = /[\p{ID_Start}_]\p{ID_Continue}*\.\p{ID_Continue}*$/u;
const NAME = /^\p{ID_Continue}*$/u;
const GENERAL = [localCompletionSource, globalCompletion, completeAnyWord].map(exceptBehindDot);

/** The description in a block's definition. */
interface Described {
  readonly type: string;
  readonly args0?: readonly { readonly name?: string }[];
  readonly tooltip?: string;
}

/** Highlighting and completion for Python; the skills come from the palette. */
export function python(palette: Promise<Palette>): Extension {
  const skills = palette.then(({ definitions }) => (definitions as readonly Described[]).flatMap(skill));
  return [
    pythonLanguage(),
    autocompletion({ override: [(context) => ofRobot(context, skills), ...GENERAL] }),
    closeBrackets(),
    keymap.of([...completionKeymap, ...closeBracketsKeymap]),
  ];
}

/** After a dot only the robot's skills are offered. */
function exceptBehindDot(source: CompletionSource): CompletionSource {
  return (context) => (context.matchBefore(BEHIND_DOT) ? null : source(context));
}

async function ofRobot(
  context: CompletionContext,
  skills: Promise<readonly Completion[]>,
): Promise<CompletionResult | null> {
  const found = context.matchBefore(BEHIND_DOT);
  if (!found) return null;
  return { from: found.from + found.text.indexOf(".") + 1, options: await skills, validFor: NAME };
}

function skill({ type, args0 = [], tooltip = "" }: Described): Completion[] {
  if (!type.startsWith(SKILL)) return [];
  const parameters = args0.map(({ name }) => name).join(", ");
  return [{ label: type.slice(SKILL.length), type: "skill", detail: `(${parameters})`, info: tooltip }];
}
