/** The span of time whose calls are counted. */

import { type Signal, useSignal, useSignalEffect } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";

/** Seconds; null where the user has chosen none. */
export interface Span {
  readonly first: Signal<number | null>;
  readonly last: Signal<number | null>;
}

/** The span that the user has chosen, until another run begins. */
export function useSpan(): Span {
  const { running } = usePage().context;
  const first = useSignal<number | null>(null);
  const last = useSignal<number | null>(null);
  useSignalEffect(() => {
    if (running.state.value.state === "starting") first.value = last.value = null;
  });
  return { first, last };
}

interface SpanFieldsProps {
  readonly span: Span;
  /** Where the span that is shown ends. */
  readonly shown: number;
}

export function SpanFields({ span, shown }: SpanFieldsProps) {
  const { first, last } = span;
  const { past } = usePage().context.running;
  const here = past.value?.time;
  return (
    <div class="calls-span" role="group" aria-label={t("page-calls-span")}>
      <Seconds label={t("page-calls-from")} value={first} without={0} />
      <Seconds label={t("page-calls-to")} value={last} without={shown} />
      {here !== undefined && (
        <>
          <button type="button" class="button bordered" onClick={() => (first.value = here)}>
            {t("page-calls-from-here")}
          </button>
          <button type="button" class="button bordered" onClick={() => (last.value = here)}>
            {t("page-calls-to-here")}
          </button>
        </>
      )}
      {(first.value ?? last.value) !== null && (
        <button type="button" class="button bordered" onClick={() => (first.value = last.value = null)}>
          {t("page-calls-whole")}
        </button>
      )}
    </div>
  );
}

interface SecondsProps {
  readonly label: string;
  readonly value: Signal<number | null>;
  /** What is used where the user has chosen nothing. */
  readonly without: number;
}

function Seconds({ label, value, without }: SecondsProps) {
  const take = ({ currentTarget: { value: text, valueAsNumber } }: { currentTarget: HTMLInputElement }) => {
    value.value = text === "" || !(valueAsNumber >= 0) ? null : valueAsNumber;
  };
  return (
    <label>
      {label}
      <input
        type="number"
        min={0}
        step={0.1}
        placeholder={without.toFixed(2)}
        value={value.value ?? ""}
        onInput={take}
      />
    </label>
  );
}
