/** The editor of a lesson: its parts on the left, the chosen one beside them. */

import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { say, t, translated } from "../../i18n";
import { usePage } from "../../model/page";
import { IconButton } from "../../ui/button";
import { FormContext, type Path } from "../../ui/form/form";
import { Add } from "../../ui/form/parts";
import type { LessonEdit } from "../lessons/lesson-edit";
import { inLanguage } from "../lessons/lessons";
import { MOST_STEPS, type Section } from "../lessons/making";
import { About } from "./about";
import { formOf, Languages } from "./inputs";
import { Step } from "./step";
import { Teacher } from "./teacher";
import "./editor.css";

export function LessonEditor() {
  const making = usePage().lessonMaking;
  const sets = usePage().blockSets;
  const form = useRef<HTMLDivElement>(null);
  useEffect(() => sets.list(), []);
  const draft = making.draft.value;
  const section = making.section.value;
  useEffect(() => {
    form.current?.scrollTo(0, 0);
  }, [section]);
  if (!draft) return null;
  return (
    <div class="maker">
      <Summary />
      <Parts draft={draft} />
      <div class="maker-form" ref={form} role="group" aria-label={titleOf(draft, section)}>
        <div class="maker-head">
          <h3>{titleOf(draft, section)}</h3>
          {typeof section === "number" && <StepTools draft={draft} index={section} />}
          <Languages />
        </div>
        <FormContext.Provider value={formOf(making)}>
          <Shown key={section} draft={draft} section={section} />
        </FormContext.Provider>
      </div>
      <Foot draft={draft} />
    </div>
  );
}

function Shown({ draft, section }: { draft: LessonEdit; section: Section }) {
  if (section === "about") return <About content={draft.content} />;
  if (section === "teacher") return <Teacher draft={draft} />;
  const step = draft.content.step[section];
  return step ? <Step step={step} index={section} /> : null;
}

function titleOf({ content }: LessonEdit, section: Section): string {
  if (typeof section === "string") return t(`page-maker-part-${section}`);
  const title = inLanguage(content.step[section]?.title);
  return t("page-maker-step", { number: section + 1, title: title || t("page-maker-new-step") });
}

function Parts({ draft }: { draft: LessonEdit }) {
  const making = usePage().lessonMaking;
  const { step: steps } = draft.content;
  const sections: readonly Section[] = ["about", ...steps.map((_, index) => index), "teacher"];
  return (
    <nav class="maker-parts" aria-label={t("page-maker-parts")}>
      {sections.map((section) => (
        <button
          key={section}
          type="button"
          class="button"
          aria-current={section === making.section.value ? "true" : undefined}
          onClick={() => (making.section.value = section)}
        >
          {titleOf(draft, section)}
        </button>
      ))}
      <Add words={t("page-maker-add-step")} off={steps.length >= MOST_STEPS} onClick={() => making.addStep()} />
    </nav>
  );
}

function StepTools({ draft, index }: { draft: LessonEdit; index: number }) {
  const making = usePage().lessonMaking;
  const last = draft.content.step.length - 1;
  return (
    <span class="maker-tools">
      <IconButton icon="up" word="page-maker-step-up" off={index === 0} onClick={() => making.moveStep(index, -1)} />
      <IconButton
        icon="down"
        word="page-maker-step-down"
        off={index === last}
        onClick={() => making.moveStep(index, 1)}
      />
      <IconButton
        icon="trash"
        word="page-maker-step-delete"
        off={last === 0}
        onClick={() => making.deleteStep(index)}
      />
    </span>
  );
}

/** The mistakes that keep the lesson from being saved, each with the way to its place. */
function Summary() {
  const making = usePage().lessonMaking;
  const place = useRef<HTMLDivElement>(null);
  const problems = making.problemsAt([]);
  const hasSome = problems.length > 0;
  useLayoutEffect(() => {
    if (hasSome) place.current?.focus();
  }, [hasSome]);
  if (!hasSome) return null;
  return (
    <div class="maker-summary" role="alert" tabIndex={-1} ref={place}>
      <strong>{t("page-maker-problems", { count: problems.length })}</strong>
      <ul>
        {problems.map(({ path, message }) => (
          <li key={`${path.join(" ")} ${say(message)}`}>
            <button type="button" class="maker-link" onClick={() => (making.section.value = sectionOf(path))}>
              {placeOf(path)}
            </button>{" "}
            {say(message)}
          </li>
        ))}
      </ul>
    </div>
  );
}

function sectionOf([first, index]: Path): Section {
  return first === "step" && typeof index === "number" ? index : "about";
}

/** A place in words, such as “Step 2 · Title”. */
function placeOf(path: Path): string {
  const [key = ""] = path.filter((one, at) => typeof one === "string" && !(at === 0 && one === "step"));
  const word = key ? translated(`page-maker-place-${key}`, String(key)) : "";
  const section = sectionOf(path);
  const part = typeof section === "number" ? t("page-maker-place-step", { number: section + 1 }) : "";
  return [part, word].filter(Boolean).join(" · ") || t("page-maker-part-about");
}

function Foot({ draft }: { draft: LessonEdit }) {
  const making = usePage().lessonMaking;
  return (
    <div class="maker-foot">
      <span class="dim">{t(making.isSaved.value ? "page-maker-is-saved" : "page-maker-not-saved")}</span>
      {!making.isSaved.value && (
        <button type="button" class="button bordered" onClick={() => making.discard()}>
          {t("page-maker-discard")}
        </button>
      )}
      <button type="button" class="button bordered" onClick={() => making.close()}>
        {t("page-shell-close")}
      </button>
      <button type="button" class="button filled" disabled={!draft} onClick={() => making.save()}>
        {t("page-maker-save")}
      </button>
    </div>
  );
}
