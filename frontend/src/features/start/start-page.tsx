/** The page that opens first: continue, choose a robot, try examples, and find projects. */

import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { LessonCards } from "../lessons/cards";
import { Teachers } from "../teachers/teachers";
import { Examples } from "./examples";
import { OwnHandIns } from "./hand-ins";
import { Hero } from "./hero";
import { preload } from "./preload";
import { type OpenFiles, Projects } from "./projects";
import { Robots } from "./robots";
import { TopBar } from "./top-bar";
import "./start.css";

export function StartPage({ openFiles }: { openFiles: OpenFiles }) {
  const { project, classes, classNews } = usePage();
  const main = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    // The button that led here is gone.
    if (project.entries.value) main.current?.focus();
  }, []);
  useEffect(() => project.list(), []);
  const isWelcome = project.welcome.value !== null;
  useEffect(() => {
    if (isWelcome) preload();
  }, [isWelcome]);
  return (
    <div class="start">
      <TopBar />
      {classes.shown.value ? (
        <Teachers />
      ) : (
        <main id="home" ref={main} tabIndex={-1} aria-label={t("page-start-home")}>
          <Hero />
          {classNews.now.value ? <OwnHandIns /> : <Robots />}
          <LessonCards />
          <Examples />
          <Projects openFiles={openFiles} />
        </main>
      )}
    </div>
  );
}
