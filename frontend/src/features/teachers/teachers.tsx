/** What the start page has for teachers: their classes, a new one, and what helps before and after a lesson. */

import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { chooseFile } from "../../ui/files";
import { Icon, type IconName } from "../../ui/icons";
import { ClassCard } from "./class-card";
import { CLASS_FILE } from "./classes";
import { StartClass } from "./start-class";
import { Topics } from "./topics";
import "./teachers.css";

export function Teachers() {
  const { classes, lessons, blockSets } = usePage();
  const main = useRef<HTMLElement>(null);
  const teaches = lessons.teaches.value;
  useLayoutEffect(() => {
    if (!teaches) main.current?.focus();
  }, []);
  // A teacher may be quicker than the connection, which says whether the user teaches.
  useEffect(() => {
    if (!teaches) return;
    classes.list();
    blockSets.list();
    lessons.list();
  }, [teaches]);
  return (
    <main ref={main} class="teachers" tabIndex={-1} aria-labelledby="teachers">
      <header>
        <h1 id="teachers">{t("page-start-teachers")}</h1>
        <p class="dim">{t("page-teachers-about")}</p>
      </header>
      <div class="teachers-main">
        {teaches ? <MyClasses /> : <p class="dim">{t("page-teachers-elsewhere")}</p>}
        <Topics />
      </div>
      {teaches && (
        <div class="teachers-side">
          <StartClass />
          <Kept />
        </div>
      )}
    </main>
  );
}

function MyClasses() {
  const { classes } = usePage();
  const entries = classes.entries.value;
  return (
    <section class="teachers-classes" aria-labelledby="teachers-classes">
      <div class="start-head">
        <h2 id="teachers-classes">{t("page-teachers-classes")}</h2>
        <button
          type="button"
          class="more-link start-all"
          disabled={classes.busy.value !== ""}
          onClick={() => chooseFile(CLASS_FILE, (file) => void classes.takeIn(file))}
        >
          <Icon name="upload" />
          {t("page-teachers-open-file")}
        </button>
      </div>
      <p role="alert" class={classes.problem.value ? "teachers-problem" : "hidden"}>
        {classes.problem.value && say(classes.problem.value)}
      </p>
      {entries?.length === 0 && <p class="dim">{t("page-teachers-none")}</p>}
      <ul>
        {entries?.map((entry) => (
          <ClassCard key={entry.title} entry={entry} />
        ))}
      </ul>
    </section>
  );
}

const KEPT: readonly (readonly [string, IconName])[] = [
  ["names", "teachers"],
  ["work", "projects"],
  ["here", "simulated"],
  ["until", "trash"],
];

/** What is kept about children. */
function Kept() {
  return (
    <section class="start-card teachers-kept" aria-labelledby="teachers-kept">
      <h2 id="teachers-kept">{t("page-teachers-kept")}</h2>
      <ul>
        {KEPT.map(([topic, icon]) => (
          <li key={topic}>
            <Icon name={icon} />
            <p>{t(`page-teachers-kept-${topic}`)}</p>
          </li>
        ))}
      </ul>
    </section>
  );
}
