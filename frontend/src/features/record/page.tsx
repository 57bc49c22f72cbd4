/** A pupil over weeks: for the pupil, for the teacher, and on paper for a meeting with parents. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { language, t } from "../../i18n";
import type { PupilRecord, Seat } from "../../protocol/classroom";
import { Icon, type IconName } from "../../ui/icons";
import { RemoveDialog } from "../class-page/dialogs";
import { Frame } from "../class-page/frame";
import { ClassStream } from "../class-page/stream";
import { Aims } from "./aims";
import { LessonTable } from "./lessons";
import { lessonsOf, type Opened, openRecord } from "./record";
import "./record.css";

export function RecordPage() {
  const opened = useSignal<Opened>("loading");
  useEffect(() => void openRecord().then((found) => (opened.value = found)), []);
  const record = opened.value;
  if (typeof record === "string") return <Frame>{record !== "loading" && <p>{t(`page-record-${record}`)}</p>}</Frame>;
  return (
    <Frame title={t("page-record-title")} tools={<Tools record={record} />}>
      <article class="record">
        <Summary record={record} />
        {lessonsOf(record).length === 0 ? (
          <p class="record-card record-none">{t("page-record-none")}</p>
        ) : (
          <>
            <LessonTable record={record} />
            <Aims record={record} />
          </>
        )}
        <footer>
          {t("page-class-title", { title: record.title })} · {new Date().toLocaleDateString(language.value)}
        </footer>
      </article>
    </Frame>
  );
}

/** The id of the pupil whose page this is. */
function pupilHere(): string {
  return location.pathname.split("/").at(-2) ?? "";
}

function Tools({ record }: { record: PupilRecord }) {
  return (
    <div class="class-tools">
      <a class="button" href={record.teaches ? "../../teacher" : "./"}>
        <Icon name="previous" />
        {record.teaches ? t("page-class-title", { title: record.title }) : t("page-record-back")}
      </a>
      {record.teaches && <ForTeacher name={record.name} />}
      <button type="button" class="button filled" onClick={() => print()}>
        <Icon name="print" />
        {t(record.teaches ? "page-record-print-meeting" : "page-record-print")}
      </button>
    </div>
  );
}

/** Everything that is kept about the pupil can be taken along or deleted here, too. */
function ForTeacher({ name }: { name: string }) {
  const leaving = useSignal<ClassStream | null>(null);
  const id = pupilHere();
  const ask = () => {
    const stream = new ClassStream("../../wall");
    stream.open();
    stream.on("Wall", ({ pupils = [] }) => pupils.includes(id) || location.assign("../../teacher"));
    leaving.value = stream;
  };
  return (
    <>
      <button type="button" class="button" aria-haspopup="dialog" onClick={ask}>
        <Icon name="trash" />
        {t("page-record-delete")}
      </button>
      <a class="button bordered" href={`../../export.zip?pupil=${id}`}>
        <Icon name="download" />
        {t("page-class-export")}
      </a>
      {leaving.value && (
        <RemoveDialog stream={leaving.value} seats={[{ id, name } as Seat]} close={() => (leaving.value = null)} />
      )}
    </>
  );
}

function Summary({ record }: { record: PupilRecord }) {
  const lessons = lessonsOf(record);
  const sum = (of: (lesson: (typeof lessons)[number]) => number) => lessons.reduce((all, one) => all + of(one), 0);
  const handIns = lessons.flatMap((lesson) => lesson.hand_ins ?? []);
  const improved = handIns.filter((handIn) => handIn.improved).length;
  const begun = lessons.length;
  return (
    <header class="record-summary">
      <div class="record-card">
        <h2>
          <bdi>{record.name}</bdi>
        </h2>
        <p class="dim">{t("page-class-title", { title: record.title })}</p>
      </div>
      <Figure
        icon="lesson"
        word={t("page-record-finished")}
        figure={lessons.filter(({ done }) => done).length}
        more={t("page-record-of-begun", { count: begun })}
      />
      <Figure
        icon="star"
        word={t("page-class-stars")}
        figure={sum(({ stars = 0 }) => stars)}
        more={t("page-record-of", { count: sum(({ all_stars = 0 }) => all_stars) })}
      />
      <Figure
        icon="hint"
        word={t("page-record-hints")}
        figure={sum(({ hints = 0 }) => hints)}
        more={t("page-record-in-lessons", { count: begun })}
      />
      <Figure
        icon="handedIn"
        word={t("page-class-hand-ins")}
        figure={handIns.length}
        more={improved ? t("page-record-improved", { count: improved }) : ""}
      />
    </header>
  );
}

function Figure({ icon, word, figure, more }: { icon: IconName; word: string; figure: number; more: string }) {
  return (
    <div class="record-card">
      <p class="record-word">
        <Icon name={icon} />
        {word}
      </p>
      <p>
        <strong class="record-figure">{figure}</strong> {more}
      </p>
    </div>
  );
}
