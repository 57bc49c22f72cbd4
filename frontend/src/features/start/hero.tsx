/** The first thing to do: go on with the last project, or try the first program. */

import type { ComponentChildren } from "preact";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { preferences } from "../../model/preferences";
import type { ExampleChoice, LessonChoice, ProjectEntry } from "../../protocol/messages";
import { day } from "../../ui/dates";
import { Icon } from "../../ui/icons";
import { RobotPicture } from "../../ui/robots/picture";
import { pictureOf } from "../examples/pictures";
import { exampleText, exampleTitle } from "../examples/words";
import { inLanguage, isDone } from "../lessons/lessons";
import { projectPicture } from "./project-picture";
import { tryExample } from "./try-example";

/** The program that newcomers try. */
const FIRST = "first-square";
/** The robot that is shown to a user who has not chosen one. */
const USUAL = "sim-ebo";

export function Hero() {
  const { project, lessons, classNews } = usePage();
  const [last] = project.entries.value ?? [];
  const first = project.welcome.value?.examples.find(({ name }) => name === FIRST);
  const choices = lessons.choices.value ?? [];
  const lesson = choices.find((one) => one.project && one.project === last?.name);
  const handedOut = choices.find(({ name }) => name === classNews.now.value?.lesson);
  if (handedOut && (handedOut === lesson || !isDone(handedOut))) return <HandedOut lesson={handedOut} />;
  if (last) return lesson ? <GoOn lesson={lesson} last={last} /> : <Continue last={last} />;
  return project.entries.value && first ? <FirstProgram example={first} /> : <div class="start-hero" />;
}

function Continue({ last }: { last: ProjectEntry }) {
  const { project } = usePage();
  return (
    <Card
      over={t("page-start-last", { day: day(last.changed) })}
      title={last.name}
      text={t("page-start-continue-text")}
      picture={projectPicture(last)}
    >
      <button type="button" class="start-big" onClick={() => project.open(last.name)}>
        <Icon name="run" />
        {t("page-start-continue")}
      </button>
    </Card>
  );
}

/** The last project belongs to a lesson: its step, and the stars earned so far. */
function GoOn({ lesson, last }: { lesson: LessonChoice; last: ProjectEntry }) {
  const { project } = usePage();
  const { level } = lesson;
  return (
    <Card
      over={`${t("page-lesson-level", { level })} · ${day(last.changed)}`}
      title={inLanguage(lesson.title)}
      text={placeIn(lesson)}
      picture={projectPicture(last) ?? lessonPicture(lesson)}
    >
      <Stars lesson={lesson} />
      <button type="button" class="start-big" onClick={() => project.open(last.name)}>
        <Icon name="run" />
        {t("page-start-continue")}
      </button>
    </Card>
  );
}

/** What the teacher has handed out, until it is done. */
function HandedOut({ lesson }: { lesson: LessonChoice }) {
  const { project, lessons } = usePage();
  const begun = project.entries.value?.find(({ name }) => name === lesson.project);
  return (
    <Card
      over={t("page-start-handed-out")}
      title={inLanguage(lesson.title)}
      text={begun ? placeIn(lesson) : t("page-lesson-minutes", { minutes: lesson.minutes })}
      picture={(begun && projectPicture(begun)) ?? lessonPicture(lesson)}
    >
      <Stars lesson={lesson} />
      <button type="button" class="start-big" onClick={() => lessons.start(lesson)}>
        <Icon name="run" />
        {t(begun ? "page-start-continue" : "page-start-begin")}
      </button>
    </Card>
  );
}

function Stars({ lesson: { earned = 0, stars } }: { lesson: LessonChoice }) {
  if (stars === 0) return null;
  return (
    <span class="start-stars">
      {Array.from({ length: stars }, (_, index) => (
        <Icon key={index} name={index < earned ? "earned" : "star"} />
      ))}
      <span class="hidden">{t("page-lesson-stars-of", { earned, stars })}</span>
    </span>
  );
}

function placeIn({ step = 1, steps }: LessonChoice): string {
  return t("page-lesson-step-of", { step: Math.max(1, step), count: steps });
}

function lessonPicture({ name, picture }: LessonChoice): string | undefined {
  return picture && `lessons/${encodeURIComponent(name)}/pictures/${encodeURIComponent(picture)}`;
}

function FirstProgram({ example }: { example: ExampleChoice }) {
  const page = usePage();
  return (
    <Card
      over={t("page-start-first")}
      title={exampleTitle(example)}
      text={`${exampleText(example)} ${t("page-start-first-text")}`}
      picture={pictureOf(example.name)}
    >
      <button type="button" class="start-big" onClick={() => void tryExample(page, example)}>
        <Icon name="run" />
        {t("page-start-try")}
      </button>
    </Card>
  );
}

interface CardProps {
  readonly over: string;
  readonly title: string;
  readonly text: string;
  readonly picture: string | undefined;
  readonly children: ComponentChildren;
}

function Card({ over, title, text, picture, children }: CardProps) {
  return (
    <section class="start-hero" aria-labelledby="start-title" data-region="start">
      {picture ? <img src={picture} alt="" /> : <RobotPicture robot={preferences.value.robot || USUAL} />}
      <div class="start-hero-text">
        <span class="start-over">{over}</span>
        <h1 id="start-title">{title}</h1>
        <p>{text}</p>
        {children}
      </div>
    </section>
  );
}
