/** What a lesson is about: its title, level, length, aims and robots. */

import { useId } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { plainTitle } from "../../model/robots";
import type { LessonContent } from "../lessons/lesson-edit";
import { Add, ChoiceInput, NumberInput, Part, Problems, TextInput, Tick } from "./inputs";

const LEVELS = [1, 2, 3, 4] as const;
const MOST_AIMS = 8;

export function About({ content }: { content: LessonContent }) {
  const making = usePage().lessonMaking;
  return (
    <>
      <TextInput
        word="page-maker-title"
        path={["title"]}
        text={content.title}
        take={(title) => making.editContent({ title })}
      />
      <div class="maker-row">
        <ChoiceInput
          word="page-maker-level"
          path={["level"]}
          value={String(content.level)}
          options={LEVELS.map((one) => [String(one), t(`page-lesson-cards-level-${one}`)] as const)}
          take={(level) => making.editContent({ level: Number(level) })}
        />
        <NumberInput
          word="page-maker-minutes"
          path={["minutes"]}
          value={content.minutes}
          least={1}
          most={240}
          take={(minutes = 0) => making.editContent({ minutes })}
        />
      </div>
      <Aims content={content} />
      <Robots content={content} />
    </>
  );
}

function Aims({ content: { aims } }: { content: LessonContent }) {
  const making = usePage().lessonMaking;
  const take = (changed: LessonContent["aims"]) => making.editContent({ aims: changed });
  return (
    <section class="maker-group">
      <h3>{t("page-maker-aims")}</h3>
      <p class="dim">{t("page-maker-aims-help")}</p>
      <Problems path={["aims"]} />
      {aims.map((aim, index) => (
        <Part
          key={index}
          title={t("page-maker-aim-number", { number: index + 1 })}
          remove={() => take(aims.toSpliced(index, 1))}
        >
          <TextInput
            word="page-maker-aim"
            path={["aims", index]}
            text={aim}
            take={(text) => take(aims.with(index, text))}
          />
        </Part>
      ))}
      <Add word="page-maker-add-aim" off={aims.length >= MOST_AIMS} onClick={() => take([...aims, {}])} />
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
        <ChoiceInput
          word="page-maker-usual-robot"
          path={["robots", 0]}
          value={robots[0] ?? ""}
          options={robots.map((name) => [name, project.robotTitle(name)] as const)}
          take={(name) => take([name, ...robots.filter((one) => one !== name)])}
        />
      )}
    </section>
  );
}
