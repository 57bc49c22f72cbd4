/** The page's keyboard shortcuts; the app assigns the actions. */

/** A key that works everywhere on the page; `key` is that of `KeyboardEvent`. */
export interface Shortcut {
  readonly key: string;
  readonly control?: boolean;
  readonly shift?: boolean;
  /** The code of its description. */
  readonly word: string;
}

// Avoids the keys of Blockly (letters), CodeMirror (F2, F8, F12 and more) and browsers.
export const SHORTCUTS = [
  { key: "Enter", control: true, word: "page-bar-run" },
  { key: "Enter", control: true, shift: true, word: "page-bar-stop" },
  { key: "F4", word: "page-bar-pause-or-resume" },
  { key: "F7", word: "page-bar-step" },
  { key: "F10", word: "page-bar-step-over" },
  { key: "F6", word: "page-settings-next-region" },
  { key: "F6", shift: true, word: "page-settings-previous-region" },
  { key: "o", control: true, word: "page-project-open" },
  { key: "s", control: true, word: "page-settings-saves" },
  { key: "F1", word: "page-help-title" },
] as const satisfies readonly Shortcut[];

export type ShortcutWord = (typeof SHORTCUTS)[number]["word"];

/** Keys that lead into the blocks from the whole page, where they are shown. */
export const INTO_BLOCKS: readonly Shortcut[] = [
  { key: "t", word: "page-settings-toolbox" },
  { key: "b", control: true, word: "page-blocks-search-blocks" },
  { key: "w", word: "page-settings-workspace" },
  { key: "f", control: true, word: "page-settings-search" },
];

/** Keys that work in one region, for the dialog of shortcuts: keys and the code of their description. */
export const OTHER_KEYS: Readonly<Record<string, readonly (readonly [string, string])[]>> = {
  "page-settings-everywhere": [
    ["Ctrl+Z", "page-bar-undo"],
    ["Ctrl+Shift+Z, Ctrl+Y", "page-bar-redo"],
    ["F9", "page-settings-breakpoint"],
    ["Esc", "page-settings-closes"],
  ],
  "page-timeline-title": [
    ["← →", "page-timeline-key-moment"],
    ["Shift+← →", "page-timeline-key-step"],
    ["Ctrl+← →", "page-timeline-key-mark"],
    ["Esc", "page-timeline-present"],
  ],
  "page-shell-blocks": [
    ...INTO_BLOCKS.map((one) => [keysOf(one), one.word] as const),
    ["F1, Ctrl+I", "page-blocks-help-key"],
    ["←↑↓→", "page-settings-move-cursor"],
    ["Enter", "page-settings-edit-block"],
    ["M", "page-settings-move-block"],
    ["D", "page-settings-duplicate"],
    ["Delete", "page-settings-delete"],
  ],
  "page-settings-texts": [
    ["Ctrl+Space", "page-settings-complete"],
    ["Ctrl+I", "page-settings-describe"],
    ["F8", "page-settings-next-problem"],
    ["F2", "page-settings-rename"],
    ["F12", "page-settings-definition"],
    ["Shift+Alt+F", "page-settings-format"],
    ["Alt+Enter", "page-settings-reveal"],
    ["Alt+Y", "page-text-why"],
    ["Ctrl+F", "page-settings-search"],
    ["Esc, Tab", "page-settings-leaves"],
  ],
};

/** The keys as text, such as Ctrl+Enter. */
export function keysOf({ key, control, shift }: Shortcut): string {
  const name = key.length === 1 ? key.toUpperCase() : key;
  return [control ? "Ctrl" : "", shift ? "Shift" : "", name].filter(Boolean).join("+");
}

/** The keys with the same action as a button. */
export function keysFor(word: string): string | undefined {
  const found = SHORTCUTS.find((one) => one.word === word);
  return found && keysOf(found);
}

export function matches(shortcut: Shortcut, event: KeyboardEvent): boolean {
  return (
    event.key.toLowerCase() === shortcut.key.toLowerCase() &&
    (event.ctrlKey || event.metaKey) === (shortcut.control ?? false) &&
    event.shiftKey === (shortcut.shift ?? false) &&
    !event.altKey
  );
}
