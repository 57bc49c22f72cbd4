/** A small piano to choose a note, for mouse, finger and keys. */

import { t } from "../../../i18n";

type Choice = readonly [label: string, value: string];

const NOTE = /^([A-G])([#b]?)(\d)$/;
/** The white keys in order, and the semitones from the first to each of them. */
const WHITE = ["C", "D", "E", "F", "G", "A", "B"];
const SEMITONES = [0, 2, 4, 5, 7, 9, 11];
/** How far an arrow key goes, in semitones. */
const STEPS: Readonly<Record<string, number>> = { ArrowRight: 1, ArrowLeft: -1, ArrowUp: 12, ArrowDown: -12 };

/** Whether all values are notes, such as C#4. */
export function areNotes(values: readonly string[]): boolean {
  return values.length > 0 && values.every((value) => NOTE.test(value));
}

/** The number of a note in semitones; a sharp and the flat above it are the same key. */
export function pitch(note: string): number {
  const [, letter = "C", sign = "", octave = "0"] = NOTE.exec(note) ?? [];
  const shift = sign === "#" ? 1 : sign === "b" ? -1 : 0;
  return 12 * Number(octave) + (SEMITONES[WHITE.indexOf(letter)] ?? 0) + shift;
}

/** The piano; `take` gets the value of each chosen note, `done` is called after a click. */
export function piano(
  choices: readonly Choice[],
  current: string,
  take: (note: string) => void,
  done: () => void,
): HTMLElement {
  const panel = document.createElement("div");
  const keyboard = document.createElement("div");
  const name = document.createElement("output");
  keyboard.className = "lbPiano";
  keyboard.setAttribute("role", "radiogroup");
  keyboard.ariaLabel = t("page-blocks-piano");
  const keys = distinct(choices).map(([label, value]) => keyOf(label, value));
  const choose = (key: HTMLElement) => {
    for (const one of keys) {
      one.setAttribute("aria-checked", String(one === key));
      one.tabIndex = one === key ? 0 : -1;
    }
    name.textContent = key.ariaLabel;
  };
  const press = (key: HTMLElement) => {
    choose(key);
    key.focus({ preventScroll: true });
    key.scrollIntoView({ block: "nearest", inline: "nearest" });
    take(key.dataset.note ?? "");
  };
  for (const key of keys) {
    key.addEventListener("click", () => {
      press(key);
      done();
    });
  }
  keyboard.addEventListener("keydown", (event) => {
    const at = keys.indexOf(document.activeElement as HTMLButtonElement);
    const next = keys[at + (STEPS[event.key] ?? 0)];
    if (!(event.key in STEPS)) return;
    event.preventDefault();
    event.stopPropagation();
    if (next) press(next);
  });
  choose(keys.find(({ dataset }) => pitch(dataset.note ?? "") === pitch(current)) ?? keys[0]!);
  keyboard.append(...keys);
  panel.append(keyboard, name);
  return panel;
}

/** One choice for each key, from low to high. */
function distinct(choices: readonly Choice[]): Choice[] {
  const found = new Map<number, Choice>();
  for (const choice of choices) if (!found.has(pitch(choice[1]))) found.set(pitch(choice[1]), choice);
  return [...found].sort(([one], [other]) => one - other).map(([, choice]) => choice);
}

function keyOf(label: string, value: string): HTMLButtonElement {
  const key = document.createElement("button");
  key.type = "button";
  key.className = NOTE.exec(value)?.[2] ? "lbBlackKey" : "lbWhiteKey";
  key.dataset.note = value;
  key.setAttribute("role", "radio");
  key.ariaLabel = key.title = label;
  if (value.startsWith("C") && !NOTE.exec(value)?.[2]) key.textContent = label;
  return key;
}
