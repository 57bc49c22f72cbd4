/** The checks of a step: each in words, with a small form for its values. */

import { say, t, worldName } from "../../i18n";
import { usePage } from "../../model/page";
import { choice } from "../../ui/form/choice";
import { type FieldProps, FormField, Problems } from "../../ui/form/field";
import type { Path } from "../../ui/form/form";
import { Tick } from "../../ui/form/inputs";
import { Parts } from "../../ui/form/parts";
import type { Field } from "../../ui/form/schema";
import type { StepContent, Texts, Values } from "../lessons/lesson-edit";
import { fieldsOf, kindsOf, kindWords, newOf } from "./fields";
import { Translated } from "./inputs";

const MOST = 12;
const NEW: Values = { kind: "ends" };

export function Checks({ step, index }: { step: StepContent; index: number }) {
  const making = usePage().lessonMaking;
  return (
    <section class="maker-group">
      <h3>{t("page-maker-checks")}</h3>
      <p class="dim">{t("page-maker-checks-help")}</p>
      <Parts
        values={step.check ?? []}
        take={(check) => making.editStep(index, { check })}
        title={(number) => t("page-maker-check", { number })}
        add={t("page-maker-add-check")}
        fresh={() => NEW}
        most={MOST}
      >
        {(check, take, at) => <Check check={check} step={index} index={at} take={take} />}
      </Parts>
    </section>
  );
}

interface CheckProps {
  readonly check: Values;
  readonly step: number;
  readonly index: number;
  readonly take: (check: Values) => void;
}

function Check({ check, step, index, take }: CheckProps) {
  const { examined } = usePage().lessonMaking;
  const words = examined.value.steps?.[step]?.checks?.[index];
  const path = ["step", step, "check", index];
  const { kind, say: said, optional, name, robot } = check;
  const kept = { ...(said != null && { say: said }), ...(name != null && { name }), ...(robot != null && { robot }) };
  const choose = (chosen: string) => take({ ...newOf("kind", chosen), ...kept, optional });
  const kinds = kindsOf("kind").includes(String(kind)) ? kindsOf("kind") : [...kindsOf("kind"), String(kind)];
  return (
    <>
      <p class="maker-sentence" aria-live="polite">
        {words ? say(words) : t("page-maker-check-unfinished")}
      </p>
      <FormField
        label={t("page-maker-kind")}
        path={[...path, "kind"]}
        shape={{ kind: "choice", options: kinds }}
        words={kindWords}
        value={String(kind)}
        take={choose}
      />
      <div class="maker-row">
        <ValueFields tag="kind" values={check} path={path} step={step} take={take} />
      </div>
      <Translated
        word="page-maker-say"
        path={[...path, "say"]}
        text={said as Texts | undefined}
        take={(text) => take({ ...check, say: text })}
      />
      <Tick text={t("page-maker-optional")} value={optional === true} take={(on) => take({ ...check, optional: on })} />
      <OwnProblems path={path} />
    </>
  );
}

/** The mistakes of a check that belong to none of its values. */
function OwnProblems({ path }: { path: Path }) {
  const making = usePage().lessonMaking;
  const isOwn = making.problemsAt(path).some((problem) => problem.path.length === path.length);
  return isOwn ? <Problems path={path} /> : null;
}

interface ValuesProps {
  readonly tag: "kind" | "event";
  readonly values: Values;
  readonly path: Path;
  readonly step: number;
  readonly take: (values: Values) => void;
}

/** A field for each value that a check or an event of this kind takes. */
function ValueFields({ tag, values, path, step, take }: ValuesProps) {
  const kind = values[tag];
  return fieldsOf(tag, kind).map((field) => (
    <ValueField
      key={`${kind} ${field.key}`}
      field={field}
      path={[...path, field.key]}
      step={step}
      value={values[field.key] ?? field.initial}
      take={(value) => take(withValue(values, field.key, value))}
    />
  ));
}

interface ValueProps {
  readonly field: Field;
  readonly path: Path;
  readonly step: number;
  readonly value: unknown;
  readonly take: (value: unknown) => void;
}

function ValueField({ field, path, step, value, take }: ValueProps) {
  const { key, optional, shape } = field;
  const known = useKnown(step, key);
  const common = { label: t(`page-maker-key-${key.replaceAll("_", "-")}`), path, optional, take };
  if (shape.kind === "union") return <EventFields path={path} step={step} event={value as Values} take={take} />;
  if (shape.kind === "list" && shape.item.kind === "union") {
    return <Events path={path} step={step} events={(value ?? []) as Values[]} take={take} />;
  }
  if (shape.kind === "list") {
    const texts = (value ?? []) as readonly string[];
    if (known.length > 0) return <Goals path={path} goals={known} value={texts} take={take} />;
    return <FormField {...common} shape={shape} help={t("page-maker-lines-help")} value={texts} />;
  }
  if (shape.kind === "choice") {
    const options = { ...shape, options: ["", ...shape.options] };
    const words = (option: string) => (option ? t("lesson-construct", { construct: option }) : t("page-maker-none"));
    return (
      <FormField
        {...common}
        shape={options}
        words={words}
        value={String(value ?? "")}
        take={(one) => take(one || null)}
      />
    );
  }
  return <FormField {...({ ...common, shape, known, value: value ?? null } as FieldProps)} />;
}

/** What may be meant: the goals and lines of the world, or the skills. */
function useKnown(step: number, key: string): readonly string[] {
  const { examined, skills } = usePage().lessonMaking;
  const { lines = [], goals = [] } = examined.value.steps?.[step] ?? {};
  if (key === "line") return lines;
  if (key === "name" || key === "goals") return goals;
  return key === "skill" ? skills.value : [];
}

interface GoalsProps {
  readonly path: Path;
  readonly goals: readonly string[];
  readonly value: readonly string[];
  readonly take: (value: readonly string[]) => void;
}

/** The goals of the world, to tick. */
function Goals({ path, goals, value, take }: GoalsProps) {
  return (
    <fieldset class="maker-goals">
      <legend>{t("page-maker-key-goals")}</legend>
      {[...new Set([...goals, ...value])].map((goal) => (
        <Tick
          key={goal}
          text={worldName(goal)}
          value={value.includes(goal)}
          take={(on) => take(on ? [...value, goal] : value.filter((other) => other !== goal))}
        />
      ))}
      <Problems path={path} />
    </fieldset>
  );
}

interface EventProps {
  readonly path: Path;
  readonly step: number;
  readonly event: Values;
  readonly take: (event: Values) => void;
}

function EventFields({ path, step, event, take }: EventProps) {
  const kinds = kindsOf("event").map((kind) => [kind, t(`page-maker-event-${kind}`)] as const);
  return (
    <div class="maker-event">
      <FormField
        label={t("page-maker-event")}
        path={[...path, "event"]}
        value={String(event?.event ?? "")}
        {...choice(kinds)}
        take={(kind) => take(newOf("event", kind))}
      />
      <ValueFields tag="event" values={event ?? {}} path={path} step={step} take={take} />
    </div>
  );
}

interface EventsProps {
  readonly path: Path;
  readonly step: number;
  readonly events: readonly Values[];
  readonly take: (events: readonly Values[]) => void;
}

function Events({ path, step, events, take }: EventsProps) {
  return (
    <div class="maker-events">
      <Parts
        values={events}
        take={take}
        title={(number) => t("page-maker-event-number", { number })}
        add={t("page-maker-add-event")}
        fresh={() => newOf("event", "stands")}
      >
        {(event, takeEvent, at) => <EventFields path={[...path, at]} step={step} event={event} take={takeEvent} />}
      </Parts>
    </div>
  );
}

/** Values with one of them changed; without it if it is empty. */
function withValue(values: Values, key: string, value: unknown): Values {
  const { [key]: _old, ...others } = values;
  return value == null ? others : { ...others, [key]: value };
}
