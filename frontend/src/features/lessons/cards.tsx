/** The lessons on the start page, by level, and the examples behind them. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { preferences } from "../../model/preferences";
import { plainTitle } from "../../model/robots";
import type { LessonChoice } from "../../protocol/messages";
import { chooseFile, chooseFolder } from "../../ui/files";
import { Icon } from "../../ui/icons";
import { Menu, type MenuItem } from "../../ui/menu";
import { LESSON_FILES } from "./lesson-file";
import { inLanguage, isDone } from "./lessons";
import "./cards.css";

const LEVELS = [1, 2, 3, 4] as const;
/** The level at which pupils of a stage begin. */
const BEGINNINGS = { starter: 1, explorer: 2, coder: 3 } as const;

export function LessonCards() {
  const { lessons, project, context } = usePage();
  const all = lessons.choices.value ?? [];
  const last = all.find((one) => one.project && one.project === project.entries.value?.[0]?.name);
  const chosen = useSignal<number | null>(null);
  const isReadOnly = context.program.readOnly.value !== null;
  const welcomed = project.welcome.value !== null;
  useEffect(() => {
    if (welcomed) lessons.list();
  }, [welcomed]);
  const level = chosen.value ?? last?.level ?? BEGINNINGS[preferences.value.stage];
  const shown = all.filter((one) => one.level === level);
  const next = [last, ...shown].find((one) => one?.level === level && !isDone(one));
  return (
    <section id="lessons" class="start-lessons" aria-labelledby="start-lessons" data-region="lessons" tabIndex={-1}>
      <div class="start-head">
        <h2 id="start-lessons">{t("page-lesson-cards-title")}</h2>
        <div class="start-stages" role="group" aria-label={t("page-lesson-cards-levels")}>
          {LEVELS.map((one) => (
            <button
              key={one}
              type="button"
              class="start-chip"
              aria-pressed={one === level}
              onClick={() => (chosen.value = one)}
            >
              {t(`page-lesson-cards-level-${one}`)}
            </button>
          ))}
        </div>
        {!isReadOnly && lessons.teaches.value && <AddLesson />}
      </div>
      {lessons.choices.value && shown.length === 0 && <p class="dim">{t("page-lesson-cards-none")}</p>}
      <ul class="start-cards">
        {shown.map((one) => (
          <Card key={one.name} lesson={one} isNext={one === next} isReadOnly={isReadOnly} />
        ))}
      </ul>
    </section>
  );
}

/** Adds a lesson from its file or its folder. */
function AddLesson() {
  const { lessons } = usePage();
  const items: readonly MenuItem[] = [
    {
      text: t("page-lesson-add-file"),
      icon: "upload",
      run: () => chooseFile(LESSON_FILES, (file) => void lessons.import(file)),
    },
    {
      text: t("page-lesson-add-folder"),
      icon: "projects",
      run: () => chooseFolder((files) => lessons.takeFolder(files)),
    },
  ];
  return (
    <div class="lesson-add">
      <Menu label={t("page-lesson-add")} icon="upload" groups={[{ items }]} look="bordered" side="right">
        {t("page-lesson-add")}
      </Menu>
    </div>
  );
}

interface CardProps {
  readonly lesson: LessonChoice;
  /** Whether it is the one to do now. */
  readonly isNext: boolean;
  readonly isReadOnly: boolean;
}

function Card({ lesson, isNext, isReadOnly }: CardProps) {
  const { lessons } = usePage();
  const { name, picture = "", step = 0, steps, own = false, project = "" } = lesson;
  const title = inLanguage(lesson.title);
  return (
    <li class={isNext ? "lesson-card next" : "lesson-card"}>
      <button
        type="button"
        class="start-example"
        title={lesson.aims.map(inLanguage).join("\n")}
        onClick={() => lessons.start(lesson)}
      >
        {picture ? (
          <img src={address(name, picture)} alt="" width={480} height={270} loading="lazy" />
        ) : (
          <span class="start-blank" />
        )}
        <span class="start-words">
          <strong>{title}</strong>
          <Facts lesson={lesson} />
          {project && step > 0 && <span class="lesson-badge">{t("page-lesson-go-on", { step, count: steps })}</span>}
          {own && !project && <span class="lesson-badge">{t("page-lesson-own")}</span>}
          {isNext && !own && !project && <span class="lesson-badge">{t("page-lesson-cards-next")}</span>}
        </span>
      </button>
      {(project || own || lessons.teaches.value) && (
        <span class="lesson-tools">
          <LessonMenu lesson={lesson} isReadOnly={isReadOnly} />
        </span>
      )}
    </li>
  );
}

/** What can be done with a lesson: most of it only by the teacher. */
function LessonMenu({ lesson, isReadOnly }: { lesson: LessonChoice; isReadOnly: boolean }) {
  const { lessons } = usePage();
  const making = usePage().lessonMaking;
  const { dialogs } = usePage();
  const { name, own = false, project = "" } = lesson;
  const title = inLanguage(lesson.title);
  const again: MenuItem = {
    text: t("page-lesson-again", { title }),
    icon: "restart",
    run: () => lessons.start(lesson, true),
  };
  const notes: MenuItem = {
    text: t("page-lesson-notes"),
    icon: "lesson",
    run: () => dialogs.show({ lessonNotes: name, title }),
  };
  const copy: MenuItem = { text: t("page-lesson-copy"), icon: "copy", run: () => making.copy(name) };
  const change: MenuItem = { text: t("page-maker-change"), icon: "rename", run: () => making.change(name) };
  const whole: MenuItem = {
    text: t("page-maker-download-teacher"),
    icon: "download",
    run: () => making.export(name, "teacher"),
  };
  const pupils: MenuItem = {
    text: t("page-maker-download-pupils"),
    icon: "download",
    run: () => making.export(name, "pupils"),
  };
  const remove: MenuItem = {
    text: t("page-lesson-delete-menu"),
    icon: "trash",
    run: () => dialogs.show({ deleteLesson: name, title }),
  };
  const teaches = lessons.teaches.value;
  const writes = teaches && !isReadOnly;
  const groups = [
    { items: project && !isReadOnly ? [again] : [] },
    { items: [...(teaches ? [notes] : []), ...(own && writes ? [change] : []), ...(writes ? [copy] : [])] },
    { items: own ? [...(teaches ? [whole] : []), pupils] : [] },
    { items: own && writes ? [remove] : [] },
  ].filter(({ items }) => items.length > 0);
  if (groups.length === 0) return null;
  return <Menu label={t("page-lesson-more", { title })} icon="more" groups={groups} side="right" />;
}

/** How long it takes, its usual robot, and the stars. */
function Facts({ lesson: { minutes, robots, stars, earned = 0 } }: { lesson: LessonChoice }) {
  const { project } = usePage();
  const robot = project.welcome.value?.robots.find((one) => one.name === robots[0]);
  return (
    <span class="lesson-facts dim">
      <span>
        {t("page-lesson-minutes", { minutes })} · {robot ? plainTitle(robot) : robots[0]}
      </span>
      {stars > 0 && (
        <span class={earned > 0 ? "lesson-count some" : "lesson-count"}>
          <Icon name="earned" />
          <span aria-hidden="true">{t("page-lesson-stars-short", { earned, stars })}</span>
          <span class="hidden">{t("page-lesson-stars-of", { earned, stars })}</span>
        </span>
      )}
    </span>
  );
}

function address(lesson: string, file: string): string {
  return `lessons/${encodeURIComponent(lesson)}/pictures/${encodeURIComponent(file)}`;
}
