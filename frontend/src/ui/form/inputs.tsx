/** The inputs of a form's fields. */

import { useSignal } from "@preact/signals";
import { useId, useRef } from "preact/hooks";

import { t } from "../../i18n";
import type { NumberShape, TextShape } from "./schema";

/** The attributes that connect an input with its label and its messages. */
export interface Described {
  readonly id?: string;
  readonly lang?: string;
  readonly "aria-label"?: string;
  readonly "aria-describedby"?: string;
  readonly "aria-invalid"?: boolean;
  readonly "data-key"?: string;
}

interface Props<S, T> {
  readonly shape: S;
  readonly optional?: boolean;
  /** Whether the server judges the value: it is reported even if it is not allowed. */
  readonly isJudged?: boolean;
  readonly value: T;
  readonly take: (value: T) => void;
  readonly described: Described;
}

type Element = HTMLInputElement | HTMLTextAreaElement;

/** A number within bounds; an optional one may be empty. */
export function NumberInput({ shape, optional, isJudged, value, take, described }: Props<NumberShape, number | null>) {
  const typing = useTyping(value, value === null ? "" : String(value));
  const { least, most, step = "any" } = shape;
  const typed = ({ currentTarget }: { currentTarget: HTMLInputElement }) => {
    const number = currentTarget.value === "" ? null : Number(currentTarget.value);
    const reason = isJudged ? "" : numberFault(currentTarget, shape, optional ?? false);
    typing.note(currentTarget, reason);
    if (!reason) take(number);
  };
  return (
    <input
      type="number"
      min={least}
      max={most}
      step={step}
      required={!optional}
      placeholder={optional ? t("page-form-none") : undefined}
      value={typing.text}
      onInput={typed}
      onChange={({ currentTarget }) => currentTarget.reportValidity()}
      {...described}
      aria-invalid={described["aria-invalid"] || typing.isWrong}
    />
  );
}

function numberFault({ value, validity }: HTMLInputElement, shape: NumberShape, optional: boolean): string {
  const { least = -Infinity, most = Infinity, step } = shape;
  if (value === "" && optional && !validity.badInput) return "";
  const number = Number(value);
  if (value !== "" && number >= least && number <= most && (step !== 1 || Number.isInteger(number))) return "";
  return t(step === 1 ? "page-form-wants-whole" : "page-form-wants-number", { least, most });
}

interface TextProps extends Props<TextShape, string | null> {
  /** Texts to choose from; others are possible, too. */
  readonly known?: readonly Known[];
  readonly placeholder?: string | undefined;
}

/** A text to choose, or its words as well. */
export type Known = string | readonly [value: string, words: string];

/** A text; an optional one is null if it is empty. */
export function TextInput(props: TextProps) {
  const { shape, optional, isJudged, value, take, known = [], placeholder, described } = props;
  const list = useId();
  const typing = useTyping(value, value ?? "");
  const { shortest = 0, longest, rows, isCode, isCommitted } = shape;
  const report = (text: string) => take(optional && text === "" ? null : text);
  const typed = ({ currentTarget }: { currentTarget: Element }) => {
    const text = currentTarget.value;
    const isShort = text.length < shortest && !(optional && text === "");
    const reason = isShort && !isJudged ? t("page-form-wants-text") : "";
    typing.note(currentTarget, reason);
    if (!reason && !isCommitted) report(text);
  };
  const left = ({ currentTarget }: { currentTarget: Element }) => {
    if (!currentTarget.reportValidity() || !isCommitted) return;
    typing.end();
    report(currentTarget.value.trim());
  };
  const common = {
    value: typing.text,
    maxLength: longest,
    placeholder: placeholder ?? (optional ? t("page-form-none") : undefined),
    onInput: typed,
    onChange: left,
    ...described,
    "aria-invalid": described["aria-invalid"] || typing.isWrong,
  };
  if (rows) return <textarea {...common} rows={rows} class={isCode ? "code" : undefined} spellcheck={!isCode} />;
  return (
    <>
      <input type="text" list={known.length > 0 ? list : undefined} {...common} />
      {known.length > 0 && (
        <datalist id={list}>
          {known.map((each) => (
            <option key={each} value={typeof each === "string" ? each : each[0]}>
              {typeof each === "string" ? undefined : each[1]}
            </option>
          ))}
        </datalist>
      )}
    </>
  );
}

interface ChoiceProps {
  /** Values with their words. */
  readonly options: readonly (readonly [value: string, words: string])[];
  readonly value: string;
  readonly take: (value: string) => void;
  readonly described: Described;
}

export function ChoiceInput({ options, value, take, described }: ChoiceProps) {
  return (
    <select value={value} onChange={({ currentTarget }) => take(currentTarget.value)} {...described}>
      {options.map(([option, words]) => (
        <option key={option} value={option}>
          {words}
        </option>
      ))}
    </select>
  );
}

interface TickProps {
  readonly text: string;
  readonly value: boolean;
  readonly take: (value: boolean) => void;
  readonly dataKey?: string | undefined;
}

export function Tick({ text, value, take, dataKey }: TickProps) {
  return (
    <label class="check">
      <input
        type="checkbox"
        data-key={dataKey}
        checked={value}
        onChange={({ currentTarget }) => take(currentTarget.checked)}
      />
      {text}
    </label>
  );
}

interface LinesProps {
  readonly value: readonly string[];
  readonly take: (value: readonly string[]) => void;
  readonly described: Described;
}

/** Texts, one in each line; a last line without text is none yet. */
export function LinesInput({ value, take, described }: LinesProps) {
  const written = value.join("\n");
  const typing = useTyping(written, written);
  const typed = ({ currentTarget }: { currentTarget: HTMLTextAreaElement }) => {
    typing.note(currentTarget, "");
    take(currentTarget.value.split("\n").filter((line, index, all) => line || index < all.length - 1));
  };
  return <textarea rows={3} value={typing.text} onInput={typed} {...described} />;
}

/** What the user types stays as it is written, such as "0.0", until the value becomes another than it made. */
function useTyping(value: unknown, written: string) {
  const typed = useSignal<Typed | null>(null);
  const made = useRef<{ readonly typed: Typed; readonly value: unknown } | null>(null);
  if (typed.value && made.current?.typed !== typed.value) made.current = { typed: typed.value, value };
  const now = typed.value && Object.is(made.current?.value, value) ? typed.value : null;
  return {
    text: now?.text ?? written,
    isWrong: now?.isWrong ?? false,
    /** Keep the text of an input, and why it is refused. */
    note(input: Element, reason: string): void {
      input.setCustomValidity(reason);
      typed.value = { text: input.value, isWrong: reason !== "" };
    },
    end(): void {
      typed.value = null;
    },
  };
}

interface Typed {
  readonly text: string;
  readonly isWrong: boolean;
}
