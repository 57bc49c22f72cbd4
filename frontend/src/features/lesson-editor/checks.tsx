/** The checks of a step: each in words, with a small form for its values. */

import { useId } from "preact/hooks";
import { say, t, worldName } from "../../i18n";
import { usePage } from "../../model/page";
import type { StepContent, Values } from "../lessons/lesson-edit";
import type { Path } from "../lessons/making";
import { type Field as CheckField, fieldsOf, kindsOf, kindWords, newOf } from "./fields";
import { Add, ChoiceInput, Field, NumberInput, Part, Problems, TextInput, Tick } from "./inputs";

const MOST = 12;
const NEW: Values = { kind: "ends" };

export function Checks({ step, index }: { step: StepContent; index: number }) {
  const making = usePage().lessonMaking;
  const { check: checks = [] } = step;
  const take = (check: readonly Values[]) => making.editStep(index, { check });
  return (
    <section class="maker-group">
      <h3>{t("page-maker-checks")}</h3>
      <p class="dim">{t("page-maker-checks-help")}</p>
      {checks.map((check, at) => (
        <Check
          key={at}
          check={check}
          step={index}
          index={at}
          take={(changed) => take(checks.with(at, changed))}
          remove={() => take(checks.toSpliced(at, 1))}
        />
      ))}
      <Add word="page-maker-add-check" off={checks.length >= MOST} onClick={() => take([...checks, NEW])} />
    </section>
  );
}

interface CheckProps {
  readonly check: Values;
  readonly step: number;
  readonly index: number;
  readonly take: (check: Values) => void;
  readonly remove: () => void;
}

function Check({ check, step, index, take, remove }: CheckProps) {
  const { examined } = usePage().lessonMaking;
  const words = examined.value.steps?.[step]?.checks?.[index];
  const path = ["step", step, "check", index];
  const { kind, say: said, optional, name, robot } = check;
  const kept = { ...(said != null && { say: said }), ...(name != null && { name }), ...(robot != null && { robot }) };
  const choose = (chosen: string) => take({ ...newOf("kind", chosen), ...kept, optional });
  const kinds = kindsOf("kind").includes(String(kind)) ? kindsOf("kind") : [...kindsOf("kind"), String(kind)];
  return (
    <Part title={t("page-maker-check", { number: index + 1 })} remove={remove}>
      <p class="maker-sentence" aria-live="polite">
        {words ? say(words) : t("page-maker-check-unfinished")}
      </p>
      <ChoiceInput
        word="page-maker-kind"
        path={[...path, "kind"]}
        value={String(kind)}
        options={kinds.map((one) => [one, kindWords(one)] as const)}
        take={choose}
      />
      <div class="maker-row">
        {fieldsOf("kind", kind).map((field) => (
          <ValueInput
            key={`${kind} ${field.key}`}
            field={field}
            path={[...path, field.key]}
            step={step}
            value={check[field.key]}
            take={(value) => take(withValue(check, field.key, value))}
          />
        ))}
      </div>
      <TextInput
        word="page-maker-say"
        path={[...path, "say"]}
        text={check.say as never}
        take={(text) => take({ ...check, say: text })}
      />
      <Tick text={t("page-maker-optional")} value={optional === true} take={(on) => take({ ...check, optional: on })} />
      <OwnProblems path={path} />
    </Part>
  );
}

/** The mistakes of a check that belong to none of its values. */
function OwnProblems({ path }: { path: Path }) {
  const making = usePage().lessonMaking;
  const own = making.problemsAt(path).filter((one) => one.path.length === path.length);
  return own.length > 0 ? <Problems path={path} /> : null;
}

interface ValueProps {
  readonly field: CheckField;
  readonly path: Path;
  readonly step: number;
  readonly value: unknown;
  readonly take: (value: unknown) => void;
}

function ValueInput({ field, path, step, value, take }: ValueProps) {
  const word = `page-maker-key-${field.key.replace("_", "-")}`;
  const { optional, initial } = field;
  switch (field.kind) {
    case "number": {
      const { least, most, whole } = field;
      const shown = (value ?? initial ?? undefined) as number | undefined;
      return <NumberInput {...{ word, path, least, most, whole, optional, take }} value={shown} />;
    }
    case "choice": {
      const options = field.options.map((one) => [one, t("lesson-construct", { construct: one })] as const);
      const none = [["", t("page-maker-none")]] as const;
      const choose = (chosen: string) => take(chosen || undefined);
      return (
        <ChoiceInput {...{ word, path }} value={String(value ?? "")} options={[...none, ...options]} take={choose} />
      );
    }
    case "text":
      return (
        <WordInput
          {...{ word, path, step }}
          value={String(value ?? initial ?? "")}
          take={(one) => take(one || (optional ? undefined : ""))}
        />
      );
    case "texts":
      return <Lines {...{ word, path, step }} value={(value ?? []) as string[]} take={take} />;
    case "event":
      return <EventInput path={path} step={step} event={value as Values} take={take} />;
    case "events":
      return <Events path={path} step={step} events={(value ?? []) as Values[]} take={take} />;
  }
}

interface WordProps {
  readonly word: string;
  readonly path: Path;
  readonly step: number;
  readonly value: string;
  readonly take: (value: string) => void;
}

/** A name or a text; what may be meant is offered. */
function WordInput({ word, path, step, value, take }: WordProps) {
  const list = useId();
  const known = useKnown(step, path.at(-1));
  return (
    <Field word={word} path={path}>
      {(id, described) => (
        <>
          <input
            id={id}
            list={known.length > 0 ? list : undefined}
            value={value}
            maxLength={200}
            onInput={({ currentTarget }) => take(currentTarget.value)}
            {...described}
          />
          <datalist id={list}>
            {known.map((one) => (
              <option key={one} value={one} />
            ))}
          </datalist>
        </>
      )}
    </Field>
  );
}

/** What may be meant: the goals and lines of the world, or the skills. */
function useKnown(step: number, key: string | number | undefined): readonly string[] {
  const { examined, skills } = usePage().lessonMaking;
  const known = examined.value.steps?.[step];
  if (key === "line") return known?.lines ?? [];
  if (key === "name") return known?.goals ?? [];
  return key === "skill" ? skills.value : [];
}

/** Texts, one in each line; or ticks, for the goals of the world. */
function Lines({
  word,
  path,
  step,
  value,
  take,
}: Omit<WordProps, "value" | "take"> & {
  readonly value: readonly string[];
  readonly take: (value: readonly string[]) => void;
}) {
  const { examined } = usePage().lessonMaking;
  const goals = path.at(-1) === "goals" ? (examined.value.steps?.[step]?.goals ?? []) : [];
  if (goals.length > 0) {
    const all = [...new Set([...goals, ...value])];
    return (
      <fieldset class="maker-goals">
        <legend>{t("page-maker-key-goals")}</legend>
        {all.map((goal) => (
          <Tick
            key={goal}
            text={worldName(goal)}
            value={value.includes(goal)}
            take={(on) => take(on ? [...value, goal] : value.filter((one) => one !== goal))}
          />
        ))}
        <Problems path={path} />
      </fieldset>
    );
  }
  const read = (text: string) => take(text.split("\n").filter((one, at, lines) => one || at < lines.length - 1));
  return (
    <Field word={word} path={path} help="page-maker-lines-help">
      {(id, described) => (
        <textarea
          id={id}
          rows={3}
          value={value.join("\n")}
          onInput={({ currentTarget }) => read(currentTarget.value)}
          {...described}
        />
      )}
    </Field>
  );
}

interface EventProps {
  readonly path: Path;
  readonly step: number;
  readonly event: Values;
  readonly take: (event: Values) => void;
}

function EventInput({ path, step, event, take }: EventProps) {
  const kind = String(event?.event ?? "");
  return (
    <div class="maker-event">
      <ChoiceInput
        word="page-maker-event"
        path={[...path, "event"]}
        value={kind}
        options={kindsOf("event").map((one) => [one, t(`page-maker-event-${one}`)] as const)}
        take={(chosen) => take(newOf("event", chosen))}
      />
      {fieldsOf("event", kind).map((field) => (
        <ValueInput
          key={`${kind} ${field.key}`}
          field={field}
          path={[...path, field.key]}
          step={step}
          value={event[field.key]}
          take={(value) => take(withValue(event, field.key, value))}
        />
      ))}
    </div>
  );
}

function Events({
  path,
  step,
  events,
  take,
}: Omit<EventProps, "event" | "take"> & {
  readonly events: readonly Values[];
  readonly take: (events: readonly Values[]) => void;
}) {
  return (
    <div class="maker-events">
      {events.map((event, at) => (
        <Part
          key={at}
          title={t("page-maker-event-number", { number: at + 1 })}
          remove={() => take(events.toSpliced(at, 1))}
        >
          <EventInput
            path={[...path, at]}
            step={step}
            event={event}
            take={(changed) => take(events.with(at, changed))}
          />
        </Part>
      ))}
      <Add word="page-maker-add-event" onClick={() => take([...events, newOf("event", "stands")])} />
    </div>
  );
}

/** Values with one of them changed; without it if it is empty. */
function withValue(values: Values, key: string, value: unknown): Values {
  const { [key]: _old, ...others } = values;
  return value === undefined ? others : { ...others, [key]: value };
}
