/** The extensions of CodeMirror that make up a text view. */

import { defaultKeymap, indentWithTab } from "@codemirror/commands";
import { python } from "@codemirror/lang-python";
import {
  bracketMatching,
  foldGutter,
  foldKeymap,
  indentOnInput,
  indentUnit,
  syntaxHighlighting,
} from "@codemirror/language";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { EditorState, type Extension, Prec } from "@codemirror/state";
import {
  crosshairCursor,
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  highlightSpecialChars,
  keymap,
  lineNumbers,
  rectangularSelection,
} from "@codemirror/view";

import type { Notation } from "../../protocol/messages";
import type { TextActions } from "./actions";
import { blocktext } from "./blocktext";
import { breakpointGutter } from "./breakpoints";
import { completion } from "./completion";
import { openBlock } from "./enter";
import { blocktextFolding } from "./folding";
import { help } from "./help";
import { highlighter } from "./highlighter";
import { markedLines } from "./marked-lines";
import { problemMarks } from "./problems";
import { renamePanel } from "./rename";
import type { Requests } from "./requests";
import { values } from "./values";

/** Keys that the page uses instead of CodeMirror: Ctrl+Enter runs the program. */
const TAKEN = new Set(["Mod-Enter"]);

function language(notation: Notation): Extension {
  if (notation === "python") return python();
  return [blocktext, blocktextFolding(), Prec.high(keymap.of([{ key: "Enter", run: openBlock }]))];
}

/** The appearance of any code. */
export function appearance(): Extension {
  return [
    lineNumbers(),
    foldGutter(),
    highlightSpecialChars(),
    drawSelection(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    highlightSelectionMatches(),
    bracketMatching(),
    syntaxHighlighting(highlighter),
  ];
}

/** The editing behaviour of any code. */
export function editing(): Extension {
  return [
    EditorState.allowMultipleSelections.of(true),
    EditorState.tabSize.of(4),
    indentUnit.of("    "),
    indentOnInput(),
    rectangularSelection(),
    crosshairCursor(),
    search({ top: true }),
  ];
}

function keys(actions: TextActions): Extension {
  const usual = [...defaultKeymap.filter(({ key }) => !TAKEN.has(key ?? "")), ...searchKeymap, ...foldKeymap];
  return [Prec.high(keymap.of(actions.keys)), keymap.of([...usual, indentWithTab])];
}

/** Ctrl+click goes to a name's definition; the browser's undo becomes the program's. */
function pointerAndMenu(actions: TextActions): Extension {
  const action = (name: string) => actions.all.find((each) => each.name === name);
  return EditorView.domEventHandlers({
    mousedown: (event, view) => {
      const position = view.posAtCoords({ x: event.clientX, y: event.clientY });
      if (event.button !== 0 || !(event.ctrlKey || event.metaKey) || position === null) return false;
      void actions.goToDefinition(view, position);
      return true;
    },
    beforeinput: (event, view) => {
      const own = { historyUndo: "undo", historyRedo: "redo" }[event.inputType];
      if (own) action(own)?.run(view);
      return own !== undefined;
    },
  });
}

/** All extensions except the phrases. */
export function extensions(notation: Notation, actions: TextActions, requests: Requests): Extension {
  return [
    breakpointGutter((view, line) => actions.toggleBreakpoint(view, line)),
    problemMarks(),
    appearance(),
    language(notation),
    completion(requests),
    help(requests),
    renamePanel(),
    markedLines(),
    values(),
    editing(),
    keys(actions),
    pointerAndMenu(actions),
  ];
}
