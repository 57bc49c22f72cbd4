/** What a lesson is about: its title, level, length, aims and robots. */

import { useId } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { plainTitle } from "../../model/robots";
import { choice } from "../../ui/form/choice";
import { FormField, Problems } from "../../ui/form/field";
import { Tick } from "../../ui/form/inputs";
import { Parts } from "../../ui/form/parts";
import type { LessonContent } from "../lessons/lesson-edit";
import { Translated } from "./inputs";

const LEVELS = [1, 2, 3, 4] as const;
const MOST_AIMS = 8;

export function About({ content }: { content: LessonContent }) {
  const making = usePage().lessonMaking;
  return (
    <>
      <Translated
        word="page-maker-title"
        path={["title"]}
        text={content.title}
        take={(title) => making.editContent({ title })}
      />
      <div class="maker-row">
        <FormField
          label={t("page-maker-level")}
          path={["level"]}
          value={String(content.level)}
          {...choice(LEVELS.map((level) => [String(level), t(`page-lesson-cards-level-${level}`)] as const))}
          take={(level) => making.editContent({ level: Number(level) })}
        />
        <FormField
          label={t("page-maker-minutes")}
          path={["minutes"]}
          shape={{ kind: "number", least: 1, most: 240, step: 1 }}
          value={content.minutes}
          take={(minutes) => making.editContent({ minutes: minutes ?? 0 })}
        />
      </div>
      <Aims content={content} />
      <Robots content={content} />
    </>
  );
}

function Aims({ content: { aims } }: { content: LessonContent }) {
  const making = usePage().lessonMaking;
  return (
    <section class="maker-group">
      <h3>{t("page-maker-aims")}</h3>
      <p class="dim">{t("page-maker-aims-help")}</p>
      <Problems path={["aims"]} />
      <Parts
        values={aims}
        take={(changed) => making.editContent({ aims: changed })}
        title={(number) => t("page-maker-aim-number", { number })}
        add={t("page-maker-add-aim")}
        fresh={() => ({})}
        most={MOST_AIMS}
      >
        {(aim, take, index) => <Translated word="page-maker-aim" path={["aims", index]} text={aim} take={take} />}
      </Parts>
    </section>
  );
}

/** The simulated robots; the first one is that with which most pupils work. */
function Robots({ content: { robots } }: { content: LessonContent }) {
  const making = usePage().lessonMaking;
  const { project } = usePage();
  const heading = useId();
  const all = project.welcome.value?.robots ?? [];
  const known = all.filter((one) => one.simulated || robots.includes(one.name));
  const take = (changed: readonly string[]) => making.editContent({ robots: changed });
  const others = robots.filter((name) => !known.some((one) => one.name === name));
  return (
    <section class="maker-group" role="group" aria-labelledby={heading}>
      <h3 id={heading}>{t("page-maker-robots")}</h3>
      <p class="dim">{t("page-maker-robots-help")}</p>
      <div class="maker-ticks">
        {[...known.map((one) => [one.name, plainTitle(one)] as const), ...others.map((one) => [one, one] as const)].map(
          ([name, title]) => (
            <Tick
              key={name}
              text={title}
              value={robots.includes(name)}
              take={(on) => take(on ? [...robots, name] : robots.filter((one) => one !== name))}
            />
          ),
        )}
      </div>
      <Problems path={["robots"]} />
      {robots.length > 1 && (
        <FormField
          label={t("page-maker-usual-robot")}
          path={["robots", 0]}
          value={robots[0] ?? ""}
          {...choice(robots.map((name) => [name, project.robotTitle(name)] as const))}
          take={(name) => take([name, ...robots.filter((robot) => robot !== name)])}
        />
      )}
    </section>
  );
}
