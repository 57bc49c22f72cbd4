/** What only the teacher has: notes, the trial of the solutions, and the whole lesson as a file. */

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { TriedProgram } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import type { LessonEdit } from "../lessons/lesson-edit";
import { Translated } from "./inputs";

const LONGEST_NOTES = 20_000;

export function Teacher({ draft }: { draft: LessonEdit }) {
  const making = usePage().lessonMaking;
  const { teaches } = usePage().lessons;
  return (
    <>
      <p class="dim">{t("page-maker-teacher-help")}</p>
      <Translated
        word="page-maker-notes"
        path={["notes"]}
        text={draft.notes}
        take={(notes) => making.edit((one) => ({ ...one, notes }))}
        isLong
        longest={LONGEST_NOTES}
      />
      <Trial />
      <section class="maker-group">
        <h3>{t("page-maker-downloads")}</h3>
        <p class="dim">{t("page-maker-downloads-help")}</p>
        <div class="maker-buttons">
          <button type="button" class="button bordered" onClick={() => making.saveAndDownload("pupils")}>
            <Icon name="download" />
            {t("page-maker-download-pupils")}
          </button>
          {teaches.value && (
            <button type="button" class="button bordered" onClick={() => making.saveAndDownload("teacher")}>
              <Icon name="download" />
              {t("page-maker-download-teacher")}
            </button>
          )}
        </div>
      </section>
    </>
  );
}

function Trial() {
  const making = usePage().lessonMaking;
  const tried = making.tried.value;
  const { done = 0, count = 0, running = false, programs = [], problem } = tried ?? {};
  return (
    <section class="maker-group">
      <h3>{t("page-maker-trial")}</h3>
      <p class="dim">{t("page-maker-trial-help")}</p>
      <div class="maker-buttons">
        {running ? (
          <button type="button" class="button bordered" onClick={() => making.stopTrying()}>
            <Icon name="stop" />
            {t("page-maker-trial-stop")}
          </button>
        ) : (
          <button type="button" class="button bordered" onClick={() => making.tryIt()}>
            <Icon name="run" />
            {t("page-maker-trial-start")}
          </button>
        )}
        {running && <progress value={done} max={Math.max(1, count)} aria-label={t("page-maker-trial-start")} />}
      </div>
      <div role="status">
        {tried && count > 0 && <p>{t("page-maker-trial-done", { done, count })}</p>}
        {tried && !running && count === 0 && <p>{t("page-maker-trial-none")}</p>}
        {problem && <p class="form-problem">{say(problem)}</p>}
        <ul class="maker-tried">
          {programs.map((one, index) => (
            <Tried key={index} program={one} />
          ))}
        </ul>
      </div>
    </section>
  );
}

function Tried({ program: { sort, step, right = 0, attempts = 0, problems = [] } }: { program: TriedProgram }) {
  const isRight = sort !== "none" && problems.length === 0;
  return (
    <li class={isRight ? "met" : "failed"}>
      <Icon name={isRight ? "check" : sort === "none" ? "warning" : "close"} />
      <span>
        {t(`page-maker-tried-${sort}`, { step, right, attempts })}
        {problems.map((one) => (
          <span key={say(one)} class="form-problem">
            {say(one)}
          </span>
        ))}
      </span>
    </li>
  );
}
