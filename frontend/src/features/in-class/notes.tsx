/** What a page shows of the class: the pupil's name and hand, the teacher's hint and questions, eyes up. */

import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { InClass } from "../../protocol/classroom";
import { IconButton } from "../../ui/button";
import { hold } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { RobotPicture } from "../../ui/robots/picture";
import { OfferNote } from "./offer-note";
import { PairNote } from "./pair-note";
import "./notes.css";

/** It has to fit on a tile of the wall. */
const LONGEST_QUESTION = 60;

/** In the bar: whose page it is, and the raised hand. */
export function PupilChip() {
  const news = usePage().classNews;
  const now = news.now.value;
  if (!now) return null;
  return (
    <span class="pupil-chip">
      {now.role === "pupil" ? (
        <a href="record" title={t("page-record-own")}>
          {now.name}
        </a>
      ) : (
        <strong>{now.name}</strong>
      )}
      {now.role === "pupil" && (
        <button
          type="button"
          class="button bordered"
          aria-pressed={now.hand}
          title={t("page-class-hand")}
          aria-label={t("page-class-hand")}
          onClick={() => news.askForHelp(!now.hand)}
        >
          <Icon name="hand" />
          <span>{t("page-class-hand")}</span>
        </button>
      )}
    </span>
  );
}

/** The notes of the class over the page. */
export function ClassNotes() {
  const now = usePage().classNews.now.value;
  if (!now) return null;
  return (
    <>
      <div class="class-notes" role="log" aria-label={t("page-class-notes")}>
        {now.role === "pupil" ? <ForPupil now={now} /> : <ForTeacher now={now} />}
      </div>
      {now.eyes_up && <EyesUp />}
    </>
  );
}

function ForPupil({ now }: { now: InClass }) {
  const news = usePage().classNews;
  return (
    <>
      <PairNote />
      <OfferNote />
      {now.hand && <Question key={now.question} known={now.question ?? ""} />}
      {now.hint && now.hints !== news.read.value && (
        <Note look="hint">
          <Icon name="hint" />
          <p>
            <strong>{t("page-class-hint-from")}</strong>
            <span>{now.hint}</span>
          </p>
          <IconButton icon="close" word="page-shell-dismiss" onClick={() => news.putAway()} />
        </Note>
      )}
      {now.writing === "asked" && (
        <Note>
          <p>{t("page-class-asked")}</p>
          <button type="button" class="button filled" onClick={() => news.letTeacherWrite(true)}>
            {t("page-class-let")}
          </button>
          <button type="button" class="button bordered" onClick={() => news.letTeacherWrite(false)}>
            {t("page-class-let-not")}
          </button>
        </Note>
      )}
      {now.writing === "yes" && (
        <Note>
          <p>{t("page-class-writes")}</p>
          <button type="button" class="button bordered" onClick={() => news.letTeacherWrite(false)}>
            {t("page-class-enough")}
          </button>
        </Note>
      )}
    </>
  );
}

function ForTeacher({ now }: { now: InClass }) {
  const news = usePage().classNews;
  const [text, button, wanted] = {
    no: ["page-class-looking", "page-class-ask", true],
    asked: ["page-class-waiting", "page-class-ask-not", false],
    yes: ["page-class-may", "page-class-stop-writing", false],
  }[now.writing] as [string, string, boolean];
  return (
    <Note>
      <p>{t(text, { name: now.name })}</p>
      <button type="button" class="button bordered" onClick={() => news.askToWrite(wanted)}>
        {t(button)}
      </button>
    </Note>
  );
}

function Note({ children, look = "" }: { children: ComponentChildren; look?: string }) {
  return <section class={`toast note ${look}`}>{children}</section>;
}

/** What the pupil needs help with, which the teacher sees on the wall. The hand is raised without it, too. */
function Question({ known }: { known: string }) {
  const news = usePage().classNews;
  const text = useSignal(known);
  const field = useRef<HTMLInputElement>(null);
  // The hand has just been raised: what is typed now is the question.
  useLayoutEffect(() => {
    if (!known) field.current?.focus();
  }, []);
  const isTold = known !== "" && text.value.trim() === known;
  return (
    <form
      class="toast note question"
      onSubmit={(event) => {
        event.preventDefault();
        news.askForHelp(true, text.peek().trim());
      }}
    >
      <label>
        <span>{t(isTold ? "page-class-told" : "page-class-question")}</span>
        <input
          ref={field}
          type="text"
          maxLength={LONGEST_QUESTION}
          value={text.value}
          onInput={({ currentTarget }) => (text.value = currentTarget.value)}
        />
      </label>
      <button type="submit" class="button filled" disabled={isTold || !text.value.trim()}>
        {t("page-class-tell")}
      </button>
      <button type="button" class="button bordered" onClick={() => news.askForHelp(false)}>
        {t("page-class-no-help")}
      </button>
    </form>
  );
}

/** All pages rest while the teacher speaks. */
function EyesUp() {
  const dialog = useRef<HTMLDialogElement>(null);
  // Escape does not put it away.
  useLayoutEffect(() => (dialog.current ? hold(dialog.current, () => undefined) : undefined), []);
  return (
    <dialog ref={dialog} class="eyes-up" aria-labelledby="eyes-up">
      <RobotPicture robot="ebo" />
      <h2 id="eyes-up" tabIndex={-1}>
        {t("page-class-eyes-up")}
      </h2>
      <p>{t("page-class-eyes-up-text")}</p>
      <p class="eyes-up-safe">
        <Icon name="saved" />
        {t("page-class-eyes-up-safe")}
      </p>
    </dialog>
  );
}
