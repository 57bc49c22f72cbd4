/** The form for a library made of the program's functions and custom blocks. */

import { type Signal, useSignal } from "@preact/signals";
import { useEffect, useId } from "preact/hooks";

import { language, say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { ExportableFunction } from "../../protocol/messages";
import { Actions } from "../../ui/dialog";

type Ticks = Signal<ReadonlySet<string>>;

export function LibraryForm({ done }: { done: () => void }) {
  const { context, libraries } = usePage();
  const name = useSignal("");
  const version = useSignal("1.0.0");
  const title = useSignal("");
  const functions: Ticks = useSignal(new Set());
  const own: Ticks = useSignal(new Set());
  useEffect(() => {
    context.program.flush();
    libraries.list();
  }, []);
  const found = libraries.exportable.value;
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    libraries.make({
      name: name.value.trim(),
      version: version.value.trim(),
      title: title.value.trim() ? { [language.peek()]: title.value.trim() } : {},
      functions: [...functions.value],
      own: [...own.value],
    });
  };
  const some = functions.value.size + own.value.size > 0;
  return (
    <form onSubmit={submit}>
      <p class="dim">{t("page-libraries-make-help")}</p>
      <div class="library-fields">
        <Field
          word="page-libraries-name"
          help="page-libraries-name-help"
          value={name}
          pattern="[a-z][a-z0-9_]*"
          longest={40}
        />
        <Field
          word="page-libraries-version"
          help="page-libraries-version-help"
          value={version}
          pattern="\d{1,5}(\.\d{1,5}){0,2}"
          longest={17}
        />
        <Field word="page-libraries-label" help="page-libraries-label-help" value={title} longest={60} optional />
      </div>
      <fieldset class="library-parts">
        <legend>{t("page-libraries-functions")}</legend>
        {found?.functions.map((one) => (
          <FunctionTick key={one.name} one={one} ticks={functions} />
        ))}
        {found?.functions.length === 0 && <p class="dim">{t("page-libraries-no-functions")}</p>}
      </fieldset>
      {found && found.own.length > 0 && (
        <fieldset class="library-parts">
          <legend>{t("page-libraries-own")}</legend>
          {found.own.map((one) => (
            <Tick key={one.name} name={one.name} ticks={own} text={one.blocks.join(", ")} />
          ))}
        </fieldset>
      )}
      <Actions cancel={done}>
        <button type="submit" class="button filled" disabled={!some}>
          {t("page-libraries-make-now")}
        </button>
      </Actions>
    </form>
  );
}

interface FieldProps {
  readonly word: string;
  readonly help: string;
  readonly value: Signal<string>;
  readonly pattern?: string;
  readonly longest: number;
  readonly optional?: boolean;
}

function Field({ word, help, value, pattern, longest, optional = false }: FieldProps) {
  const [field, id] = [useId(), useId()];
  return (
    <div class="field">
      <label for={field}>{t(word)}</label>
      <input
        id={field}
        required={!optional}
        pattern={pattern}
        maxLength={longest}
        aria-describedby={id}
        value={value.value}
        onInput={({ currentTarget }) => (value.value = currentTarget.value)}
      />
      <span id={id} class="dim">
        {t(help)}
      </span>
    </div>
  );
}

function FunctionTick({ one, ticks }: { one: ExportableFunction; ticks: Ticks }) {
  const { name, parameters, takes_along = [], problem } = one;
  const along = takes_along.length ? t("page-libraries-along", { names: takes_along.join(", ") }) : "";
  return (
    <Tick
      name={name}
      ticks={ticks}
      text={`${name}(${parameters.join(", ")})`}
      more={along}
      problem={problem ? say(problem) : ""}
    />
  );
}

interface TickProps {
  readonly name: string;
  readonly ticks: Ticks;
  readonly text: string;
  readonly more?: string;
  readonly problem?: string;
}

function Tick({ name, ticks, text, more = "", problem = "" }: TickProps) {
  const id = useId();
  const change = (on: boolean) => {
    const others = [...ticks.value].filter((one) => one !== name);
    ticks.value = new Set(on ? [...others, name] : others);
  };
  return (
    <div class="library-part">
      <label class="check">
        <input
          type="checkbox"
          disabled={Boolean(problem)}
          aria-describedby={id}
          checked={ticks.value.has(name)}
          onChange={({ currentTarget }) => change(currentTarget.checked)}
        />
        <code>{text}</code>
      </label>
      <span id={id} class={problem ? "library-problem" : "dim"}>
        {problem || more}
      </span>
    </div>
  );
}
