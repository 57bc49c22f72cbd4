/** Lists in a form: parts that can be added and removed. */

import type { ComponentChildren } from "preact";

import { IconButton } from "../button";
import "./form.css";

interface PartsProps<T> {
  readonly values: readonly T[];
  readonly take: (values: readonly T[]) => void;
  /** The title of a part, by its number from 1. */
  readonly title: (number: number) => string;
  /** The words of the button that adds a part, the part that it adds, and how many there can be. */
  readonly add: string;
  readonly fresh: () => T;
  readonly most?: number;
  readonly children: (value: T, take: (value: T) => void, index: number) => ComponentChildren;
}

/** Parts with a title each, and a button that adds one. */
export function Parts<T>({ values, take, title, add, fresh, most = Infinity, children }: PartsProps<T>) {
  return (
    <>
      {values.map((value, index) => (
        <Part key={index} title={title(index + 1)} remove={() => take(values.toSpliced(index, 1))}>
          {children(value, (changed) => take(values.with(index, changed)), index)}
        </Part>
      ))}
      <Add words={add} off={values.length >= most} onClick={() => take([...values, fresh()])} />
    </>
  );
}

function Part({ title, remove, children }: { title: string; remove: () => void; children: ComponentChildren }) {
  return (
    <fieldset class="form-part">
      <legend>{title}</legend>
      <div class="form-part-body">{children}</div>
      <IconButton icon="trash" word="page-form-remove" values={{ title }} onClick={remove} />
    </fieldset>
  );
}

export function Add({ words, onClick, off = false }: { words: string; onClick: () => void; off?: boolean }) {
  return (
    <button type="button" class="button bordered form-add" disabled={off} onClick={onClick}>
      {words}
    </button>
  );
}

interface RowsProps<T> {
  readonly values: readonly T[];
  readonly take: (values: readonly T[]) => void;
  readonly fewest: number;
  /** The value that is inserted after one. */
  readonly between: (index: number) => T;
  /** The names of a row's buttons, by its number from 1. */
  readonly insertWords: (number: number) => string;
  readonly removeWords: (number: number) => string;
  readonly children: (value: T, take: (value: T) => void, index: number) => ComponentChildren;
}

/** Short values below each other, each with buttons that insert one after it and remove it. */
export function Rows<T>({ values, take, fewest, between, insertWords, removeWords, children }: RowsProps<T>) {
  return (
    <ol class="form-rows">
      {values.map((value, index) => (
        <li key={index}>
          {children(value, (changed) => take(values.with(index, changed)), index)}
          <Small
            sign="+"
            words={insertWords(index + 1)}
            act={() => take(values.toSpliced(index + 1, 0, between(index)))}
          />
          <Small
            sign="−"
            words={removeWords(index + 1)}
            off={values.length <= fewest}
            act={() => take(values.toSpliced(index, 1))}
          />
        </li>
      ))}
    </ol>
  );
}

interface SmallProps {
  readonly sign: string;
  readonly words: string;
  readonly off?: boolean;
  readonly act: () => void;
}

/** A button with a sign and an accessible name. */
export function Small({ sign, words, off = false, act }: SmallProps) {
  return (
    <button type="button" class="button bordered" disabled={off} aria-label={words} title={words} onClick={act}>
      {sign}
    </button>
  );
}
