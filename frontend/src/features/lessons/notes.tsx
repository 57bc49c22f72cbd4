/** What a lesson has for the teacher: notes, the solution of each step, and typical wrong programs. */

import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import type { LessonDialogName } from "../../model/dialogs";
import { usePage } from "../../model/page";
import type { LessonNotes, SolvedStep, WrongProgram } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { inLanguage, sayWords } from "./lessons";
import { Markdown } from "./markdown-later";
import "./notes.css";

interface Props {
  readonly of: Extract<LessonDialogName, { lessonNotes: string }>;
}

export function LessonNotesDialog({ of: { lessonNotes, title } }: Props) {
  const { dialogs, lessons } = usePage();
  const save = () => lessons.saveWorksheet(lessonNotes);
  useEffect(() => lessons.readNotes(lessonNotes), [lessonNotes]);
  const notes = lessons.notes.value;
  return (
    <Dialog title={t("page-lesson-notes-title", { title })} close={() => dialogs.close()} size="large">
      {notes && <Notes notes={notes} />}
      <div class="actions">
        <button type="button" class="button bordered" onClick={save} title={t("page-lesson-worksheet-help")}>
          {t("page-lesson-worksheet")}
        </button>
      </div>
    </Dialog>
  );
}

function Notes({ notes: of }: { notes: LessonNotes }) {
  const { lesson, notes = {}, drawings = {}, steps = [] } = of;
  const text = withoutTitle(inLanguage(notes));
  const solved = steps.some(({ solution, wrong }) => solution || wrong?.length);
  if (!text && !solved) return <p class="dim">{t("page-lesson-notes-none")}</p>;
  return (
    <div class="lesson-notes">
      {text && <Markdown text={text} lesson={lesson} drawings={drawings} />}
      {steps.map((step, index) => (
        <Step key={index} number={index + 1} step={step} />
      ))}
    </div>
  );
}

function Step({ number, step: { title, solution = "", wrong = [] } }: { number: number; step: SolvedStep }) {
  return (
    <section>
      <h3>{t("page-maker-step", { number, title: inLanguage(title) })}</h3>
      {solution ? (
        <>
          <h4>{t("page-lesson-notes-solution")}</h4>
          <Program text={solution} />
        </>
      ) : (
        <p class="dim">{t("page-lesson-notes-no-solution")}</p>
      )}
      {wrong.length > 0 && (
        <details>
          <summary>
            {t("page-lesson-notes-wrong")} ({wrong.length})
          </summary>
          {wrong.map((one, index) => (
            <Wrong key={index} wrong={one} />
          ))}
        </details>
      )}
    </section>
  );
}

function Wrong({ wrong: { program, check, hint = [] } }: { wrong: WrongProgram }) {
  return (
    <div class="lesson-wrong">
      <p>{t("page-lesson-notes-fails", { check: sayWords(check) })}</p>
      <Program text={program} />
      <p>{t("page-lesson-notes-hint")}</p>
      <ul>
        {hint.map((level, index) => (
          <li key={index}>{sayWords(level)}</li>
        ))}
      </ul>
    </div>
  );
}

function Program({ text }: { text: string }) {
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: a keyboard user must be able to scroll it
    <pre tabIndex={0}>
      <code>{text.trimEnd()}</code>
    </pre>
  );
}

/** Notes usually begin with the title, which the dialog shows. */
function withoutTitle(text: string): string {
  return text.replace(/^#[^#\n]*\n+/, "");
}
