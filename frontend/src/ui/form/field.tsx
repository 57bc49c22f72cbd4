/** A field of a form: its label, its input, and what is wrong with its value. */

import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";

import { ColourInput, type Swatch } from "./colour";
import { type Path, useProblems } from "./form";
import { ChoiceInput, type Described, type Known, LinesInput, NumberInput, TextInput, Tick } from "./inputs";
import type { Shape } from "./schema";
import "./form.css";

/** What each kind of field holds. */
interface Held {
  number: number | null;
  /** Null if it is optional and empty. */
  text: string | null;
  choice: string;
  yes: boolean;
  /** The value of a swatch, or "#rrggbb". */
  colour: string;
  numbers: readonly number[];
  /** Texts, one in each line. */
  list: readonly string[];
}

interface Common {
  readonly label: string;
  readonly path?: Path;
  readonly optional?: boolean;
  readonly help?: string | undefined;
  /** The name of an option, of a swatch, or of a number in a group. */
  readonly words?: (option: string) => string;
  readonly known?: readonly Known[];
  readonly swatches?: readonly Swatch[];
  readonly placeholder?: string;
  readonly lang?: string;
  /** Why the value is not possible, if its editor knows. */
  readonly wrong?: string | undefined;
  readonly dataKey?: string;
}

export interface FieldProps<Kind extends keyof Held = keyof Held> extends Common {
  readonly shape: Shape & { readonly kind: Kind };
  readonly value: Held[Kind];
  readonly take: (value: Held[Kind]) => void;
}

type AnyField = { [Kind in keyof Held]: FieldProps<Kind> }[keyof Held];

/** A field, drawn by the description of what it holds. */
export function FormField<Kind extends keyof Held>(given: FieldProps<Kind>) {
  // The kind of its shape is the kind of its value.
  const props = given as unknown as AnyField;
  const { label, shape, path = [], help, wrong, lang, dataKey } = props;
  const [id, note] = [useId(), useId()];
  const judged = useProblems(path);
  const problems = [...(judged ?? []), ...(wrong ? [wrong] : [])];
  if (isOf("yes", props)) return <Tick text={label} value={props.value} take={props.take} dataKey={dataKey} />;
  const described = {
    id,
    "aria-describedby": help || problems.length > 0 ? note : undefined,
    "aria-invalid": problems.length > 0,
    ...(lang && { lang }),
    ...(dataKey && { "data-key": dataKey }),
  } as Described;
  const messages = (
    <span id={note}>
      {help && <span class="dim">{help}</span>}
      <Messages texts={problems} />
    </span>
  );
  if (shape.kind === "numbers" || shape.kind === "colour") {
    return (
      <fieldset class="form-group" data-key={dataKey}>
        <legend>{label}</legend>
        <Input props={props} described={described} isJudged={judged !== null} />
        {messages}
      </fieldset>
    );
  }
  return (
    <div class="field form-field">
      <label for={id}>{label}</label>
      <Input props={props} described={described} isJudged={judged !== null} />
      {messages}
    </div>
  );
}

interface InputProps {
  readonly props: AnyField;
  readonly described: Described;
  readonly isJudged: boolean;
}

function Input({ props, described, isJudged }: InputProps) {
  const common = { described, isJudged, optional: props.optional ?? false };
  if (isOf("number", props)) return <NumberInput {...common} {...pick(props)} />;
  if (isOf("text", props)) {
    return <TextInput {...common} {...pick(props)} known={props.known ?? []} placeholder={props.placeholder} />;
  }
  if (isOf("choice", props)) {
    const { shape, words = String } = props;
    const options = shape.options.map((option) => [option, words(option)] as const);
    return <ChoiceInput options={options} value={props.value} take={props.take} described={described} />;
  }
  if (isOf("colour", props)) {
    return <ColourInput swatches={props.swatches ?? []} value={props.value} take={props.take} described={described} />;
  }
  if (isOf("numbers", props)) return <NumberRow {...props} />;
  if (isOf("list", props)) return <LinesInput value={props.value} take={props.take} described={described} />;
  return null;
}

function isOf<Kind extends keyof Held>(kind: Kind, props: AnyField): props is Extract<AnyField, FieldProps<Kind>> {
  return props.shape.kind === kind;
}

function pick<S, T>({ shape, value, take }: { shape: S; value: T; take: (value: T) => void }) {
  return { shape, value, take };
}

/** Numbers beside each other, each with a name for screen readers. */
export function NumberRow({ shape, value, take, words = String, dataKey = "" }: FieldProps<"numbers">) {
  return (
    <div class="form-row">
      {shape.bounds.map(([least, most], index) => (
        <NumberInput
          key={index}
          shape={{ kind: "number", least, most }}
          value={value[index] ?? 0}
          take={(number) => take(value.with(index, number ?? 0))}
          described={{ "aria-label": words(String(index)), "data-key": `${dataKey}.${index}` }}
        />
      ))}
    </div>
  );
}

/** What is wrong at a place. */
export function Problems({ path }: { path: Path }) {
  return <Messages texts={useProblems(path) ?? []} />;
}

function Messages({ texts }: { texts: readonly string[] }): ComponentChildren {
  return texts.map((text) => (
    <span key={text} class="form-problem">
      {text}
    </span>
  ));
}
