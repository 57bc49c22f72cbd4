/** The hand-ins of a class: the list of a step at the left, one hand-in at the right. */

import { useEffect } from "preact/hooks";

import { language, t } from "../../i18n";
import { Icon } from "../../ui/icons";
import { Menu } from "../../ui/menu";
import { Frame, Problem } from "../class-page/frame";
import { inLanguage } from "../lessons/texts";
import { HandInTable } from "./list";
import { ShownWork } from "./shown";
import type { HandInStream } from "./stream";
import "./hand-ins.css";

export function HandInsPage({ stream }: { stream: HandInStream }) {
  useEffect(() => stream.open(), []);
  if (stream.state.value === "refused")
    return (
      <Frame>
        <p>{t("page-class-no-key")}</p>
      </Frame>
    );
  return (
    <Frame title={t("page-handins-title")} tools={<Tools stream={stream} />}>
      <Problem isLost={stream.state.value === "lost"} problem={stream.refused.value ?? stream.steps.value?.failure} />
      <div class="hand-ins">
        <section class="hand-ins-list" aria-label={t("page-handins-title")}>
          <Steps stream={stream} />
          <HandInTable stream={stream} />
        </section>
        <ShownWork stream={stream} />
      </div>
    </Frame>
  );
}

function Tools({ stream }: { stream: HandInStream }) {
  const marked = stream.marked.value.map(({ pupil }) => pupil);
  return (
    <div class="class-tools">
      <a class="button" href="teacher">
        <Icon name="previous" />
        {t("page-handins-wall")}
      </a>
      <CheckButton stream={stream} />
      <TableMenu stream={stream} />
      <button
        type="button"
        class="button filled"
        disabled={marked.length === 0}
        onClick={() => stream.handBack(marked)}
      >
        <Icon name="move" />
        {t("page-handins-back-all", { count: marked.length })}
      </button>
    </div>
  );
}

/** Checks all hand-ins of the step; meanwhile how far it is, and a way to stop it. */
function CheckButton({ stream }: { stream: HandInStream }) {
  const checking = stream.steps.value?.checking;
  const lines = stream.list.value?.lines ?? [];
  if (checking) {
    const { done = 0, total = 0 } = checking;
    return (
      <span class="hand-ins-checking" role="status">
        <progress max={total || 1} value={total ? done : undefined} aria-label={t("page-handins-checking")} />
        {t("page-handins-progress", { done, total })}
        <button type="button" class="button bordered" onClick={() => stream.send({ kind: "EndChecking" })}>
          <Icon name="stop" />
          {t("page-handins-stop")}
        </button>
      </span>
    );
  }
  const unchecked = lines.filter(({ checked }) => !checked).length;
  return (
    <button
      type="button"
      class={unchecked ? "button filled" : "button bordered"}
      disabled={lines.length === 0}
      onClick={() => stream.check()}
    >
      <Icon name={unchecked ? "check" : "restart"} />
      {unchecked ? t("page-handins-check", { count: unchecked }) : t("page-handins-check-again")}
    </button>
  );
}

function TableMenu({ stream }: { stream: HandInStream }) {
  const place = stream.place.value;
  if (!place) return null;
  const load = (file: string, more: Record<string, string> = {}) => {
    const query = new URLSearchParams({
      lesson: place.lesson,
      step: String(place.step),
      language: language.value,
      ...more,
    });
    return () => (file === "results.html" ? window.open(`${file}?${query}`) : location.assign(`${file}?${query}`));
  };
  const items = [
    { text: t("page-handins-csv"), run: load("marks.csv") },
    { text: t("page-handins-moodle"), run: load("marks.csv", { platform: "moodle" }) },
    { text: t("page-handins-results"), run: load("results.csv") },
    { text: t("page-handins-report"), run: load("results.html") },
  ];
  return (
    <Menu label={t("page-handins-tables")} icon="download" side="right" groups={[{ items }]}>
      <span>{t("page-handins-tables")}</span>
    </Menu>
  );
}

/** The steps that can be handed in, with how many have been. */
function Steps({ stream }: { stream: HandInStream }) {
  const { steps = [] } = stream.steps.value ?? {};
  const place = stream.place.value;
  const list = stream.list.value;
  const lessons = [...new Map(steps.map(({ lesson, title }) => [lesson, title])).entries()];
  const choose = (lesson: string) => {
    const first = steps.find((step) => step.lesson === lesson);
    if (first) stream.choose(first);
  };
  if (!place) return <p class="hand-ins-none">{t("page-handins-no-lesson")}</p>;
  return (
    <header class="hand-ins-head">
      {lessons.length > 1 ? (
        <label>
          <span class="hidden">{t("page-handins-lesson")}</span>
          <select value={place.lesson} onChange={({ currentTarget }) => choose(currentTarget.value)}>
            {lessons.map(([lesson, title]) => (
              <option key={lesson} value={lesson}>
                {inLanguage(title)}
              </option>
            ))}
          </select>
        </label>
      ) : (
        <h2>{inLanguage(lessons[0]?.[1])}</h2>
      )}
      {list && <p class="dim">{t("page-handins-starts", { count: list.starts })}</p>}
      <div class="hand-ins-steps" role="group" aria-label={t("page-handins-steps")}>
        {steps
          .filter(({ lesson }) => lesson === place.lesson)
          .map((one) => (
            <button
              key={one.step}
              type="button"
              class="hand-ins-step"
              aria-pressed={one.step === place.step}
              onClick={() => stream.choose(one)}
            >
              {one.step} {inLanguage(one.step_title)} <strong>{one.count ?? 0}</strong>
            </button>
          ))}
      </div>
    </header>
  );
}
