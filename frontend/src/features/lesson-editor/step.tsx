/** A step of a lesson: its text, its program and world, its checks, hints and question. */

import { language, t } from "../../i18n";
import { usePage } from "../../model/page";
import { choice } from "../../ui/form/choice";
import { FormField } from "../../ui/form/field";
import { titleOf } from "../block-sets/block-sets";
import type { Phase, StepContent } from "../lessons/lesson-edit";
import { inLanguage } from "../lessons/lessons";
import { Markdown } from "../lessons/markdown-later";
import { Checks } from "./checks";
import { Hints } from "./hints";
import { Translated } from "./inputs";
import { Presses } from "./presses";
import { ProgramInput } from "./program";
import { Puzzle } from "./puzzle";
import { Quiz } from "./quiz";

const PHASES: readonly Phase[] = ["predict", "run", "investigate", "modify", "make"];

interface Props {
  readonly step: StepContent;
  readonly index: number;
}

export function Step({ step, index }: Props) {
  const making = usePage().lessonMaking;
  const path = ["step", index];
  return (
    <>
      <div class="maker-row">
        <Translated
          word="page-maker-step-title"
          path={[...path, "title"]}
          text={step.title}
          take={(title) => making.editStep(index, { title })}
        />
        <FormField
          label={t("page-maker-phase")}
          path={[...path, "phase"]}
          value={step.phase}
          {...choice(PHASES.map((one) => [one, t(`page-lesson-phase-${one}`)] as const))}
          take={(phase) => making.editStep(index, { phase: phase as Phase })}
        />
      </div>
      <Instructions step={step} index={index} />
      <ProgramInput index={index} which="program" />
      <div class="maker-row">
        <World step={step} index={index} />
        <Blocks step={step} index={index} />
        <FormField
          label={t("page-maker-variants")}
          path={[...path, "variants"]}
          shape={{ kind: "number", least: 0, most: 100, step: 1 }}
          value={step.variants ?? 0}
          take={(variants) => making.editStep(index, { variants: variants ?? undefined })}
        />
        <FormField
          label={t("page-maker-seconds")}
          path={[...path, "seconds"]}
          shape={{ kind: "number", least: 1, most: 600 }}
          value={step.seconds ?? 60}
          take={(seconds) => making.editStep(index, { seconds: seconds ?? undefined })}
        />
      </div>
      <Presses step={step} index={index} />
      <Checks step={step} index={index} />
      <Hints step={step} index={index} />
      <Quiz step={step} index={index} />
      <Puzzle step={step} index={index} />
      <section class="maker-group">
        <h3>{t("page-maker-solution-title")}</h3>
        <ProgramInput index={index} which="solution" />
      </section>
    </>
  );
}

/** The text in Markdown, and beside it what pupils see. */
function Instructions({ step, index }: Props) {
  const making = usePage().lessonMaking;
  const shown = step.text[making.writing.value] || inLanguage(step.text);
  return (
    <div class="maker-beside">
      <Translated
        word="page-maker-text"
        path={["step", index, "text"]}
        text={step.text}
        take={(text) => making.editStep(index, { text })}
        isLong
        longest={8000}
      />
      <section class="maker-preview" aria-label={t("page-maker-preview")}>
        <h3>{t("page-maker-preview")}</h3>
        {shown ? (
          <Markdown
            text={shown}
            lesson={making.draft.value?.lesson ?? ""}
            drawings={making.examined.value.drawings ?? {}}
          />
        ) : (
          <p class="dim">{t("page-maker-text-help")}</p>
        )}
      </section>
    </div>
  );
}

function World({ step, index }: Props) {
  const making = usePage().lessonMaking;
  const { project } = usePage();
  const names = project.worlds.value.map((one) => one.name);
  const all = step.world && !names.includes(step.world) ? [...names, step.world] : names;
  const before = [["", t(index > 0 ? "page-maker-as-before" : "page-maker-robots-world")]] as const;
  return (
    <FormField
      label={t("page-maker-world")}
      path={["step", index, "world"]}
      value={step.world ?? ""}
      {...choice([...before, ...all.map((name) => [name, project.worldTitle(name)] as const)])}
      take={(world) => making.editStep(index, { world: world || undefined })}
    />
  );
}

/** One of our block sets; or blocks that were chosen for a project, one by one. */
function Blocks({ step, index }: Props) {
  const making = usePage().lessonMaking;
  const sets = usePage().blockSets;
  const before = [["", t(index > 0 ? "page-maker-as-before" : "page-maker-all-blocks")]] as const;
  const ours = sets.ours.value.map((one) => [one.name ?? "", titleOf(one)] as const);
  const lists = [sets.shown.value, ...sets.carried.value, ...sets.own.value].flatMap((one) => {
    const blocks = one.show?.blocks ?? [];
    const isPlain = blocks.length > 0 && blocks.length <= 200 && !one.show?.categories?.length && !one.hide;
    const isOurs = sets.ours.value.some((other) => other.name === one.name);
    return isPlain && !isOurs ? [[JSON.stringify(blocks), titleOf(one)] as const] : [];
  });
  const now = typeof step.blocks === "object" ? JSON.stringify(step.blocks) : (step.blocks ?? "");
  const known = new Map([...before, ...ours, ...lists]);
  if (!known.has(now)) {
    const count = typeof step.blocks === "object" ? step.blocks.length : 0;
    known.set(now, count ? t("page-maker-some-blocks", { count }) : now);
  }
  return (
    <FormField
      key={language.value}
      label={t("page-maker-blocks")}
      path={["step", index, "blocks"]}
      value={now}
      {...choice([...known])}
      take={(chosen) => making.editStep(index, { blocks: blocksOf(chosen) })}
    />
  );
}

function blocksOf(chosen: string): StepContent["blocks"] {
  if (chosen.startsWith("[")) return JSON.parse(chosen) as string[];
  return chosen || undefined;
}
