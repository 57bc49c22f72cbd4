/** The inputs of the lesson editor; each shows the mistakes at its place. */

import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { IconButton } from "../../ui/button";
import { languageName } from "../../ui/language-name";
import type { Texts } from "../lessons/lesson-edit";
import { inLanguage } from "../lessons/lessons";
import type { Path } from "../lessons/making";

interface Props {
  /** The code of the label. */
  readonly word: string;
  readonly path: Path;
}

interface FieldProps extends Props {
  readonly help?: string;
  readonly children: (id: string, described: Described) => ComponentChildren;
}

interface Described {
  readonly "aria-invalid": boolean;
  readonly "aria-describedby": string;
}

/** A label, an input, and what is wrong with its value. */
export function Field({ word, path, help, children }: FieldProps) {
  const [id, note] = [useId(), useId()];
  const problems = usePage().lessonMaking.problemsAt(path);
  return (
    <div class="field maker-field">
      <label for={id}>{t(word)}</label>
      {children(id, { "aria-invalid": problems.length > 0, "aria-describedby": note })}
      <span id={note}>
        {help && <span class="dim">{t(help)}</span>}
        <Problems path={path} />
      </span>
    </div>
  );
}

/** The mistakes at a place. */
export function Problems({ path }: { path: Path }) {
  const problems = usePage().lessonMaking.problemsAt(path);
  return (
    <>
      {problems.map(({ message }) => (
        <span key={say(message)} class="maker-problem">
          {say(message)}
        </span>
      ))}
    </>
  );
}

interface TextProps extends Props {
  readonly text: Texts | undefined;
  readonly take: (text: Texts) => void;
  readonly long?: boolean;
  readonly longest?: number;
}

/** A text in the language in which the teacher writes; that of another language shows what is missing. */
export function TextInput({ word, path, text = {}, take, long = false, longest = 200 }: TextProps) {
  const { writing } = usePage().lessonMaking;
  const code = writing.value;
  const other = text[code] ? "" : inLanguage(text);
  const props = {
    value: text[code] ?? "",
    maxLength: longest,
    lang: code,
    placeholder: other ? t("page-maker-fallback", { text: other.slice(0, 80) }) : "",
    onInput: ({ currentTarget }: { currentTarget: { value: string } }) =>
      take({ ...text, [code]: currentTarget.value }),
  };
  return (
    <Field word={word} path={path}>
      {(id, described) =>
        long ? <textarea id={id} rows={9} {...props} {...described} /> : <input id={id} {...props} {...described} />
      }
    </Field>
  );
}

interface NumberProps extends Props {
  readonly value: number | undefined;
  readonly least: number;
  readonly most: number;
  readonly whole?: boolean;
  readonly optional?: boolean;
  readonly take: (value: number | undefined) => void;
}

export function NumberInput({ word, path, value, least, most, whole = true, optional = false, take }: NumberProps) {
  return (
    <Field word={word} path={path}>
      {(id, described) => (
        <input
          id={id}
          type="number"
          min={least}
          max={most}
          step={whole ? 1 : "any"}
          required={!optional}
          value={value ?? ""}
          onInput={({ currentTarget }) => take(currentTarget.value === "" ? undefined : Number(currentTarget.value))}
          {...described}
        />
      )}
    </Field>
  );
}

interface ChoiceProps extends Props {
  readonly value: string;
  /** Their values and words. */
  readonly options: readonly (readonly [string, string])[];
  readonly take: (value: string) => void;
  readonly help?: string;
}

export function ChoiceInput({ word, path, help, value, options, take }: ChoiceProps) {
  return (
    <Field word={word} path={path} help={help}>
      {(id, described) => (
        <select id={id} value={value} onChange={({ currentTarget }) => take(currentTarget.value)} {...described}>
          {options.map(([option, words]) => (
            <option key={option} value={option}>
              {words}
            </option>
          ))}
        </select>
      )}
    </Field>
  );
}

interface TickProps {
  readonly text: string;
  readonly value: boolean;
  readonly take: (value: boolean) => void;
}

export function Tick({ text, value, take }: TickProps) {
  return (
    <label class="check">
      <input type="checkbox" checked={value} onChange={({ currentTarget }) => take(currentTarget.checked)} />
      {text}
    </label>
  );
}

/** A part of the form with a button that deletes it. */
export function Part({ title, remove, children }: { title: string; remove: () => void; children: ComponentChildren }) {
  return (
    <fieldset class="maker-part">
      <legend>{title}</legend>
      <div class="maker-part-body">{children}</div>
      <IconButton icon="trash" word="page-maker-remove" values={{ title }} onClick={remove} />
    </fieldset>
  );
}

export function Add({ word, onClick, off = false }: { word: string; onClick: () => void; off?: boolean }) {
  return (
    <button type="button" class="button bordered maker-add" disabled={off} onClick={onClick}>
      {t(word)}
    </button>
  );
}

/** The choice of the language in which the teacher writes. */
export function Languages({ codes }: { codes: readonly string[] }) {
  const { writing } = usePage().lessonMaking;
  return (
    <div class="maker-languages" role="group" aria-label={t("page-maker-languages")}>
      {codes.map((code) => (
        <button
          key={code}
          type="button"
          class="button bordered"
          aria-pressed={writing.value === code}
          onClick={() => (writing.value = code)}
        >
          {languageName(code)}
        </button>
      ))}
    </div>
  );
}
