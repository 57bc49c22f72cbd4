/** What could stand at the cursor, as the server knows it. */

import {
  autocompletion,
  closeBrackets,
  closeBracketsKeymap,
  completionKeymap,
  snippet,
  type Completion as Option,
  type CompletionContext,
  type CompletionResult,
} from "@codemirror/autocomplete";
import { syntaxTree } from "@codemirror/language";
import type { Extension } from "@codemirror/state";
import { keymap } from "@codemirror/view";

import type { Completion } from "../messages";
import type { Requests } from "./requests";

/** Where typing asks by itself: in a word, or behind the dot of `function.`. */
const ASKING = /(?:[\p{L}_][\p{L}\p{N}_]*|\.)$/u;
const SAME_WORD = /^[\p{L}\p{N}_]*$/u;

/** The form that CodeMirror's snippets have: the cursor goes to the first line left empty. */
function template(insert: string): string {
  return insert.includes("${") ? insert : insert.replace(/^([ \t]+)$/m, "$1${}");
}

/** Too little to put a worse match before a better one; among equals the server's order stays. */
const STEP_DOWN = 0.05;

/** Behind all that fits: a block that is not shown may be written all the same. */
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

async function complete(
  context: CompletionContext,
  requests: Requests,
): Promise<CompletionResult | null> {
  if (!wanted(context)) return null;
  const found = await requests.complete(context.state, context.pos);
  if (!found || found.options.length === 0) return null;
  const line = context.state.doc.lineAt(context.pos);
  const from = Math.min(line.from + found.from_column - 1, context.pos);
  const options = found.options.map((one, index) => option(one, index, requests.isShown(one)));
  return { from, options, validFor: SAME_WORD };
}

/** Completion while typing and by Ctrl+Space; brackets and quotes come in pairs. */
export function completion(requests: Requests): Extension {
  return [
    autocompletion({ override: [(context) => complete(context, requests)] }),
    closeBrackets(),
    keymap.of([...completionKeymap, ...closeBracketsKeymap]),
  ];
}
