/** A pupil's record: for the pupil, for the teacher, and on paper for a meeting with parents. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { language, t } from "../../i18n";
import type { PupilRecord, RecordedLesson, Seat } from "../../protocol/classroom";
import { Icon, type IconName } from "../../ui/icons";
import { RemoveDialog } from "../class-page/dialogs";
import { Frame } from "../class-page/frame";
import { ClassStream } from "../class-page/stream";
import { Aims } from "./aims";
import { LessonTable } from "./lessons";
import { fetchRecord, lessonsOf, type RecordOrState } from "./record";
import "./record.css";

export function RecordPage() {
  const opened = useSignal<RecordOrState>("loading");
  useEffect(() => void fetchRecord().then((found) => (opened.value = found)), []);
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

/** The teacher can also download or delete everything that is kept about the pupil here. */
function ForTeacher({ name }: { name: string }) {
  const stream = useRef<ClassStream | null>(null);
  const isAsking = useSignal(false);
  const id = pupilHere();
  const ask = () => {
    stream.current ??= openWall(id);
    isAsking.value = true;
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
      {isAsking.value && stream.current && (
        <RemoveDialog stream={stream.current} seats={[{ id, name } as Seat]} close={() => (isAsking.value = false)} />
      )}
    </>
  );
}

/** The wall's stream, which leaves this page once the pupil is deleted. */
function openWall(pupil: string): ClassStream {
  const stream = new ClassStream("../../wall");
  stream.open();
  stream.on("Wall", ({ pupils = [] }) => pupils.includes(pupil) || location.assign("../../teacher"));
  return stream;
}

function Summary({ record }: { record: PupilRecord }) {
  const lessons = lessonsOf(record);
  const sum = (of: (lesson: RecordedLesson) => number) => lessons.reduce((all, one) => all + of(one), 0);
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
