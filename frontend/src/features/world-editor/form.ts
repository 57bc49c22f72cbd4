/** A form for all properties of an object; it refuses values that a world file does not allow. */

import { t, translated } from "../../i18n";
import type { Thing } from "../../views/world/plan/sorts";
import { rgb } from "../../views/world/scenery/colours";
import type { Colour, PartValues, XY } from "../../views/world/scenery/description";
import { type Field, fieldsOf, type TableName } from "./fields";
import { checked, numeric } from "./inputs";
import { partList } from "./parts";
import { pointList } from "./points";
import type { Take, TakeList, Update } from "./updates";

/** A field's table, key and value, and the receiver of a new value. */
interface Entry<F extends Field = Field> {
  readonly table: TableName;
  readonly field: F;
  readonly value: unknown;
  take(update: Update<unknown>): void;
}

/** Fields for each key of a table. */
export function form(table: TableName, thing: Thing, take: Take): HTMLElement[] {
  return fieldsOf(table)
    .filter(({ key }) => key in thing && !isHidden(thing, key))
    .map((field) => entry({ table, field, value: thing[field.key], take: (update) => take(field.key, update) }));
}

/** A line has either corners or a path. */
function isHidden(thing: Thing, key: string): boolean {
  if (!("path" in thing)) return false;
  const path = (thing.path as unknown[]).length > 0;
  return key === "points" ? path : path ? false : key === "start" || key === "path";
}

function entry(given: Entry): HTMLElement {
  const { field } = given;
  switch (field.kind) {
    case "number":
      return labelled(given, numberInput({ ...given, field }));
    case "text":
      return labelled(given, textInput({ ...given, field }));
    case "choice":
      return labelled(
        given,
        choice(given, field.options, (option) => t(`page-world-${field.key}-${option}`)),
      );
    case "yes":
      return labelled(given, checkbox(given));
    case "colour":
      return colour(given);
    case "numbers":
      return numbers({ ...given, field });
    case "points":
      return group(given, pointList(given.value as XY[], given.take as TakeList<XY>));
    case "parts":
      return group(given, partList(given.value as PartValues[], given.take as TakeList<PartValues>));
  }
}

/** The label of a key: the table's own, or the shared one. */
export function labelOf(table: TableName, key: string): string {
  const word = key.replace("_", "-");
  return translated(`page-editor-key-${table}-${word}`, t(`page-editor-key-${word}`));
}

function labelled({ table, field }: Entry, input: HTMLElement): HTMLElement {
  const label = document.createElement("label");
  const words = document.createElement("span");
  words.textContent = labelOf(table, field.key);
  input.dataset.key = field.key;
  label.className = "field";
  label.append(words, input);
  return label;
}

function group({ table, field }: Entry, ...children: Node[]): HTMLElement {
  const set = document.createElement("fieldset");
  const legend = document.createElement("legend");
  legend.textContent = labelOf(table, field.key);
  set.dataset.key = field.key;
  set.append(legend, ...children);
  return set;
}

function numberInput({ field, value, take }: Entry<Extract<Field, { kind: "number" }>>): HTMLInputElement {
  const { least, most, whole, optional } = field;
  const read = (text: string): void => take(() => (text === "" ? null : Number(text)));
  return numeric(value as number | null, { least, most, whole, optional }, read);
}

function textInput({ field, value, take }: Entry<Extract<Field, { kind: "text" }>>): HTMLInputElement {
  const { shortest, longest, optional } = field;
  const input = document.createElement("input");
  input.type = "text";
  input.maxLength = longest;
  input.value = (value as string | null) ?? "";
  if (optional) input.placeholder = t("page-editor-none");
  const wrong = () =>
    input.value.length < shortest && !(optional && input.value === "") ? t("page-editor-wants-text") : null;
  return checked(input, wrong, () => take(() => (optional && input.value === "" ? null : input.value)));
}

function choice(
  { value, take }: Entry,
  options: readonly string[],
  words: (option: string) => string,
): HTMLSelectElement {
  const select = document.createElement("select");
  select.append(...options.map((option) => new Option(words(option), option, false, option === value)));
  select.addEventListener("change", () => take(() => select.value));
  return select;
}

function checkbox({ value, take }: Entry): HTMLInputElement {
  const input = document.createElement("input");
  input.type = "checkbox";
  input.checked = value === true;
  input.addEventListener("change", () => take(() => input.checked));
  return input;
}

const NAMES = ["white", "black", "grey", "red", "green", "blue", "yellow", "orange", "brown", "purple"] as const;
const MIXED = "mixed";

/** One of the named colours, or any other. */
function colour(given: Entry): HTMLElement {
  const value = given.value as Colour;
  const named = typeof value === "string";
  const take = (update: Update<unknown>): void =>
    given.take((old) => (update(old) === MIXED ? [...rgb(old as Colour)] : update(old)));
  const words = (option: string): string => t(`page-editor-colour-${option}`);
  const select = choice({ ...given, value: named ? value : MIXED, take }, [...NAMES, MIXED], words);
  const label = labelled(given, select);
  if (named) return label;
  const picker = document.createElement("input");
  picker.type = "color";
  picker.ariaLabel = t("page-editor-mix");
  picker.value = `#${rgb(value)
    .map((part) => part.toString(16).padStart(2, "0"))
    .join("")}`;
  picker.addEventListener("input", () => given.take(() => levels(picker.value)));
  label.append(picker);
  return label;
}

function levels(hexadecimal: string): number[] {
  return [1, 3, 5].map((start) => Number.parseInt(hexadecimal.slice(start, start + 2), 16));
}

/** A group of numbers, such as a floor's size or a pose. */
function numbers({ table, field, value, take }: Entry<Extract<Field, { kind: "numbers" }>>): HTMLElement {
  const all = value as number[];
  const inputs = field.bounds.map(([least, most], i) => {
    const input = numeric(all[i] ?? 0, { least, most }, (text) =>
      take((old) => (old as number[]).with(i, Number(text))),
    );
    input.dataset.key = `${field.key}.${i}`;
    input.ariaLabel = t(`page-editor-part-${field.key}-${i}`);
    input.title = input.ariaLabel;
    return input;
  });
  const row = document.createElement("div");
  row.className = "row";
  row.append(...inputs);
  return group({ table, field, value, take }, row);
}
