/** A test run of one function on the current robot: its arguments, output and result. */

import { useSignal } from "@preact/signals";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { sentence } from "../../model/run-result";
import type { Ended } from "../../protocol/messages";
import { choice } from "../../ui/form/choice";
import { FormField } from "../../ui/form/field";
import { type Argument, argumentsOf, parseValue } from "./arguments";
import type { Editing } from "./editing";

const TRUTHS = ["TRUE", "FALSE"] as const;

type Written = Readonly<Record<string, string>>;

export function TryIt({ editing }: { editing: Editing }) {
  const { context, project } = usePage();
  const written = useSignal<Written>({});
  const { draft, trying, shown } = editing;
  const preview = shown.value;
  const list = preview ? argumentsOf(preview) : [];
  const robot = project.robotTitle(context.running.robot.value);
  const start = (event: SubmitEvent) => {
    event.preventDefault();
    const { name, source } = draft.written.peek();
    const values = list.map((one) => parseValue(one, written.value[one.name] ?? one.initial) ?? null);
    trying.try(name, source, preview?.name ?? "", values);
  };
  return (
    <div class="custom-block-try">
      <form onSubmit={start}>
        {list.map((one) => (
          <Value
            key={`${preview?.name} ${one.name}`}
            argument={one}
            value={written.value[one.name] ?? one.initial}
            set={(text) => (written.value = { ...written.value, [one.name]: text })}
          />
        ))}
        <div class="custom-block-run">
          <button
            type="submit"
            class="button filled"
            disabled={!preview || !draft.current.value || context.running.active.value}
          >
            {t("page-custom-try", { robot })}
          </button>
          <button type="button" class="button bordered" disabled={!trying.active.value} onClick={() => trying.stop()}>
            {t("page-bar-stop")}
          </button>
        </div>
      </form>
      <Outcome editing={editing} />
    </div>
  );
}

interface ValueProps {
  readonly argument: Argument;
  readonly value: string;
  readonly set: (text: string) => void;
}

/** A field for what is typed for a parameter. */
function Value({ argument, value, set }: ValueProps) {
  const common = { label: argument.name, value, take: (text: string | null) => set(text ?? "") };
  const { kind, allowed } = argument;
  switch (kind) {
    case "number":
    case "range":
    case "angle": {
      const { min: least, max: most, step } = allowed;
      const shape = {
        kind: "number",
        ...(least !== undefined && { least }),
        ...(most !== undefined && { most }),
      } as const;
      const number = value === "" ? null : Number(value);
      const take = (changed: number | null) => set(changed === null ? "" : String(changed));
      return <FormField {...common} shape={step ? { ...shape, step } : shape} value={number} take={take} />;
    }
    case "choice":
      return <FormField {...common} {...choice(allowed.options?.map(([words, option]) => [option, words]) ?? [])} />;
    case "truth":
      return (
        <FormField
          {...common}
          {...choice(TRUTHS.map((option) => [option, t(`page-custom-${option.toLowerCase()}`)]))}
        />
      );
    case "colour":
      return <FormField {...common} shape={{ kind: "colour" }} />;
    case "list": {
      const wrong = parseValue(argument, value) === undefined ? t("page-custom-list-help") : undefined;
      return <FormField {...common} shape={{ kind: "text" }} wrong={wrong} />;
    }
    case "text":
    case "tag":
      return <FormField {...common} shape={{ kind: "text" }} />;
  }
}

function Outcome({ editing: { trying } }: { editing: Editing }) {
  const { output, ended, refused, active, prompt } = trying;
  return (
    <>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard has to reach it */}
      <pre class="custom-block-output" tabIndex={0} role="log" aria-label={t("page-custom-output")}>
        {output.value}
      </pre>
      {prompt.value !== null && <Question prompt={prompt.value} answer={(text) => trying.answer(text)} />}
      <p role="status">
        {active.value ? t("page-custom-runs") : ended.value ? describeEnd(ended.value) : say(refused.value)}
      </p>
    </>
  );
}

/** How the run ended, with the line of an error. */
function describeEnd(ended: Ended): string {
  const text = sentence(ended);
  return ended.custom_line ? `${text} ${t("page-custom-at-line", { line: ended.custom_line })}` : text;
}

function Question({ prompt, answer }: { prompt: string; answer: (text: string) => void }) {
  const text = useSignal("");
  const send = (event: SubmitEvent) => {
    event.preventDefault();
    answer(text.value);
  };
  return (
    <form onSubmit={send}>
      <label class="field">
        {prompt || t("page-custom-asks")}
        <input value={text.value} onInput={({ currentTarget }) => (text.value = currentTarget.value)} />
      </label>
    </form>
  );
}
