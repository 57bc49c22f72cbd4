/** Completions at the cursor, from the server. */

import {
  autocompletion,
  type CompletionContext,
  type CompletionResult,
  closeBrackets,
  closeBracketsKeymap,
  completionKeymap,
  type Completion as Option,
  snippet,
} from "@codemirror/autocomplete";
import { syntaxTree } from "@codemirror/language";
import type { Extension } from "@codemirror/state";
import { keymap } from "@codemirror/view";

import type { Completion } from "../../protocol/messages";
import type { Requests } from "./requests";

/** Typing asks for completions in a word, or after the dot of `function.`. */
const ASKING = /(?:[\p{ID_Start}_]\p{ID_Continue}*|\.)$/u;
const SAME_WORD = /^\p{ID_Continue}*$/u;

/** A CodeMirror snippet: the cursor goes to the first empty line. */
function template(insert: string): string {
  // biome-ignore lint/suspicious/noTemplateCurlyInString: CodeMirror's placeholder syntax
  return insert.includes("${") ? insert : insert.replace(/^([ \t]+)$/m, "$1${}");
}

/** Too small to change the order of better and worse matches; equal ones keep the server's order. */
const STEP_DOWN = 0.05;

/** After all other matches: a hidden block can still be typed. */
const HIDDEN = -90;

function option({ label, insert, sort, detail, help }: Completion, index: number, shown: boolean): Option {
  const plain = !insert.includes("\n") && !insert.includes("${");
  return {
    label,
    type: sort,
    boost: Math.max(-99, (shown ? 0 : HIDDEN) - STEP_DOWN * index),
    apply: plain ? insert : snippet(template(insert)),
    ...(detail ? { detail } : {}),
    ...(help ? { info: help } : {}),
  };
}

function wanted(context: CompletionContext): boolean {
  if (context.explicit) return true;
  const node = syntaxTree(context.state).resolveInner(context.pos, -1);
  return !/comment|string/i.test(node.name) && context.matchBefore(ASKING) !== null;
}

async function complete(context: CompletionContext, requests: Requests): Promise<CompletionResult | null> {
  if (!wanted(context)) return null;
  const found = await requests.complete(context.state, context.pos);
  if (!found || found.options.length === 0) return null;
  const line = context.state.doc.lineAt(context.pos);
  const from = Math.min(line.from + found.from_column - 1, context.pos);
  const options = found.options.map((one, index) => option(one, index, requests.isShown(one)));
  return { from, options, validFor: SAME_WORD };
}

/** Completion while typing and with Ctrl+Space; brackets and quotes are closed. */
export function completion(requests: Requests): Extension {
  return [
    autocompletion({ override: [(context) => complete(context, requests)] }),
    closeBrackets(),
    keymap.of([...completionKeymap, ...closeBracketsKeymap]),
  ];
}
