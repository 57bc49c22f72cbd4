/** A block that is being made or changed: what is typed, what is wrong with it, and what comes of it. */

import { computed, signal } from "@preact/signals";

import { t } from "../../i18n";
import { freeName, nameFault, nameInTexts } from "../../model/own-block-names";
import { kindOf, type OwnBlock, type OwnInput, type Sample, type SampleKind } from "../../model/own-blocks";

/** An input as it is typed. */
export interface TypedInput {
  /** Keeps its row. */
  readonly key: number;
  readonly name: string;
  readonly kind: SampleKind;
  /** The typed value; "true" or "false" for yes or no. */
  readonly value: string;
  readonly was?: number;
}

const FIRST_VALUES: Readonly<Record<SampleKind, string>> = { number: "10", text: "", truth: "true" };

export class Making {
  readonly name;
  readonly inputs;
  private keys = 0;

  /**
   * @param own The block before the change; an empty name for a new one.
   * @param taken The names that the program has for other things, in small letters.
   */
  constructor(
    own: OwnBlock,
    private readonly taken: ReadonlySet<string>,
  ) {
    this.name = signal(own.name);
    this.inputs = signal<readonly TypedInput[]>(own.inputs.map((input) => this.typed(input)));
  }

  /** What is wrong with the name; empty if it can be used. */
  readonly fault = computed(() => worded(nameFault(this.name.value, this.taken), this.name.value));

  /** What is wrong with the inputs, by their keys. */
  readonly inputFaults = computed(() => {
    const names = this.inputs.value.map(({ name }) => nameInTexts(name));
    const faults = this.inputs.value.map(({ key, name, kind, value }, place): [number, string] => {
      const earlier = new Set(names.slice(0, place).map((one) => one.toLowerCase()));
      const wrong = worded(nameFault(name, earlier), name);
      const hasValue = kind !== "number" || (value.trim() !== "" && Number.isFinite(Number(value)));
      return [key, wrong || (hasValue ? "" : t("page-make-no-number"))];
    });
    return new Map(faults.filter(([, fault]) => fault));
  });

  readonly isReady = computed(() => !this.fault.value && this.inputFaults.value.size === 0);

  /** The block as it is typed; for its picture, also while something is missing. */
  readonly own = computed((): OwnBlock => {
    const others: string[] = [];
    const inputs = this.inputs.value.map(({ name, kind, value, was }): OwnInput => {
      others.push(freeName(nameInTexts(name) || "_", others));
      return { name: others.at(-1)!, sample: sampleOf(kind, value), ...(was === undefined ? {} : { was }) };
    });
    return { name: nameInTexts(this.name.value) || t("page-make-placeholder"), inputs };
  });

  add(kind: SampleKind): void {
    const names = this.inputs.peek().map(({ name }) => name);
    const name = freeName(t(`page-make-name-${kind}`), names);
    this.keys += 1;
    const value = kind === "text" ? t("page-make-first-text") : FIRST_VALUES[kind];
    this.inputs.value = [...this.inputs.peek(), { key: this.keys, name, kind, value }];
  }

  set(key: number, change: Partial<TypedInput>): void {
    this.inputs.value = this.inputs.peek().map((input) => {
      if (input.key !== key) return input;
      const isOther = change.kind !== undefined && change.kind !== input.kind;
      return { ...input, ...(isOther ? { value: FIRST_VALUES[change.kind!] } : {}), ...change };
    });
  }

  remove(key: number): void {
    this.inputs.value = this.inputs.peek().filter((input) => input.key !== key);
  }

  /** Move an input one place up. */
  raise(key: number): void {
    const inputs = [...this.inputs.peek()];
    const place = inputs.findIndex((input) => input.key === key);
    if (place < 1) return;
    inputs.splice(place - 1, 0, ...inputs.splice(place, 1));
    this.inputs.value = inputs;
  }

  private typed({ name, sample, was }: OwnInput): TypedInput {
    this.keys += 1;
    return { key: this.keys, name, kind: kindOf(sample), value: String(sample), ...(was === undefined ? {} : { was }) };
  }
}

function worded(code: string, typed: string): string {
  return code && t(code, { name: typed.trim() });
}

function sampleOf(kind: SampleKind, value: string): Sample {
  if (kind === "text") return value;
  if (kind === "truth") return value === "true";
  const number = Number(value);
  return Number.isFinite(number) ? number : 0;
}
