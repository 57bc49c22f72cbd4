/** Block-Text for CodeMirror: the kind of each word and the indentation of each line. */

import { StreamLanguage, type StringStream } from "@codemirror/language";
import { tags } from "@lezer/highlight";

interface State {
  /** The open blocks and brackets. */
  depth: number;
  brackets: number;
  /** Within `python:` ... `end`. */
  raw: boolean;
  /** The quote of the open f-string, and whether a value in it is being read. */
  text: string;
  value: boolean;
  /** The previous word on the line, if it determines the kind of the next name. */
  before: string;
}

const WORD = /^[\p{ID_Start}_]\p{ID_Continue}*/u;
const NUMBER = /^(?:0[xXbBoO]\w*|(?:\d[\d_]*\.?[\d_]*|\.\d[\d_]*)(?:[eE][-+]?\d[\d_]*)?)/;
const STRING = /^(?:"(?:[^"\\]|\\.)*"?|'(?:[^'\\]|\\.)*'?)/;
const F_STRING = /^[fF]["']/;
/** The text in an f-string, by its quote. */
const TEXT_OF_F_STRING: Readonly<Record<string, RegExp>> = {
  '"': /^(?:[^"{}\\]|\\.|\{\{|\}\})*/,
  "'": /^(?:[^'{}\\]|\\.|\{\{|\}\})*/,
};
const RAW_EXPRESSION = /^`(?:[^`]|``)*`?/;
const OPERATOR = /^(?:\*\*|\/\/|[-+*/%<>=!])=?|^,|^\./;
const RAW_START = /^python[ \t]*:[ \t]*(?:#.*)?$/;
const RAW_END = /^end\b[ \t]*(?:#.*)?$/;
const CLOSES = /^(?:end|else|elif)\b/;
/** A line that begins like this is a statement, even after an open bracket. */
const OPENS_STATEMENT =
  /^(?:if|elif|else|while|for|break|continue|return|pass|def|import|main|when|end|activate|deactivate)\b/;
const AT_LINE_END = /^[ \t]*(?:#.*)?$/;

const KEYWORDS = new Set(
  "and or not in if elif else while for break continue return pass def import main when end activate deactivate repeat from to step".split(
    " ",
  ),
);
const PYTHON_KEYWORDS = new Set(
  "and or not in is if elif else while for break continue return pass def import from class lambda try except finally raise with as global nonlocal del assert yield async await match case".split(
    " ",
  ),
);
const CONSTANTS = new Set(["True", "False", "None"]);
const DEFINING = new Set(["def", "when", "class"]);
/** Soft keywords are names, unless the form of the line makes them keywords. */
const AT_START: Readonly<Record<string, RegExp>> = {
  repeat: /^\s*repeat/,
  forever: /^\s*forever\s*:/,
  wait: /^\s*wait\s+until\b/,
  until: /^\s*wait\s+until\b/,
  local: /^\s*local\s+[^\s=(]+\s*=(?!=)/,
};
const AFTER_FOR = new Set(["from", "to", "step"]);

function startState(): State {
  return { depth: 0, brackets: 0, raw: false, text: "", value: false, before: "" };
}

function startLine(stream: StringStream, state: State): void {
  state.before = state.text = "";
  if (!state.raw && stream.match(RAW_START, false)) {
    state.raw = true;
    state.depth += 1;
  } else if (stream.match(state.raw ? RAW_END : CLOSES, false)) {
    state.raw = false;
    state.depth = Math.max(0, state.depth - 1);
  }
  if (!state.raw && stream.match(OPENS_STATEMENT, false)) state.brackets = 0;
}

function token(stream: StringStream, state: State): string | null {
  if (state.text && stream.pos > 0) {
    const found = textWithValues(stream, state);
    if (found) return found;
  }
  if (stream.eatSpace()) return null;
  if (stream.string.search(/\S/) === stream.pos) startLine(stream, state);
  if (stream.match("#")) return comment(stream);
  if (stream.match(STRING)) return "string";
  if (!state.raw && stream.match(F_STRING)) return beginText(stream, state);
  if (!state.raw && stream.match(RAW_EXPRESSION)) return "special";
  if (stream.match(NUMBER)) return "number";
  const word = stream.match(WORD) as RegExpMatchArray | null;
  if (word) return named(word[0], stream, state);
  return punctuation(stream, state);
}

function beginText(stream: StringStream, state: State): string {
  state.text = stream.current().slice(-1);
  state.value = false;
  return textWithValues(stream, state) ?? "string";
}

/** Reads an f-string up to its next value or its end; null inside a value. */
function textWithValues(stream: StringStream, state: State): string | null {
  const next = stream.peek();
  if (state.value && next !== "}" && next !== state.text) return null;
  if (next === "{" || next === "}") {
    state.value = stream.next() === "{";
    return "punctuation";
  }
  stream.match(TEXT_OF_F_STRING[state.text] ?? /^.*/);
  if (stream.eat(state.text) || stream.eol()) state.text = "";
  return "string";
}

function comment(stream: StringStream): string {
  stream.skipToEnd();
  return "comment";
}

function named(word: string, stream: StringStream, state: State): string {
  const before = state.before;
  state.before = word;
  if (before === ".") return "skill";
  if (DEFINING.has(before)) return "definition";
  if (isKeyword(word, stream, state)) return "keyword";
  if (CONSTANTS.has(word)) return "atom";
  if (word === "function" && stream.match(/^\./, false)) return "self";
  return stream.match(/^[ \t]*\(/, false) ? "call" : "variable";
}

function isKeyword(word: string, stream: StringStream, state: State): boolean {
  if (word === "python") return RAW_START.test(stream.string.trim());
  if (state.raw) return PYTHON_KEYWORDS.has(word);
  if (word in AT_START) return AT_START[word]?.test(stream.string) ?? false;
  if (AFTER_FOR.has(word)) return /^\s*for\b/.test(stream.string);
  return KEYWORDS.has(word);
}

function punctuation(stream: StringStream, state: State): string | null {
  const operator = stream.match(OPERATOR) as RegExpMatchArray | null;
  if (operator) {
    state.before = operator[0];
    return "operator";
  }
  const character = stream.next() ?? "";
  if (character === ":" && opens(stream, state)) state.depth += 1;
  if ("([{".includes(character)) state.brackets += 1;
  if (")]}".includes(character)) state.brackets = Math.max(0, state.brackets - 1);
  return "()[]{}:".includes(character) ? "punctuation" : null;
}

function opens(stream: StringStream, state: State): boolean {
  return !state.raw && state.brackets === 0 && stream.match(AT_LINE_END, false) !== null;
}

/** The language itself. */
export const blocktext = StreamLanguage.define<State>({
  name: "blocktext",
  startState,
  token,
  blankLine: (state) => {
    state.before = "";
  },
  indent: (state, textAfter, context) => {
    if (state.raw && !RAW_END.test(textAfter)) return null;
    const closes = CLOSES.test(textAfter) ? 1 : 0;
    const depth = state.depth - closes + Math.min(state.brackets, 1);
    return Math.max(0, depth) * context.unit;
  },
  languageData: {
    commentTokens: { line: "#" },
    closeBrackets: { brackets: ["(", "[", "{", "'", '"', "`"] },
    indentOnInput: /^\s*(?:end|else:|elif\s)$/,
  },
  tokenTable: {
    skill: tags.function(tags.propertyName),
    call: tags.function(tags.variableName),
    definition: tags.definition(tags.variableName),
    variable: tags.variableName,
    self: tags.self,
    special: tags.special(tags.string),
  },
});
