/** A pupil's record: for the pupil, for the teacher, and on paper for a meeting with parents. */

import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useMemo, useRef } from "preact/hooks";

import { language, t } from "../../i18n";
import type { PupilRecord, RecordedLesson, Seat } from "../../protocol/classroom";
import { Icon, type IconName } from "../../ui/icons";
import { RemoveDialog } from "../class-page/dialogs";
import { Frame } from "../class-page/frame";
import { ClassStream } from "../class-page/stream";
import { Aims } from "./aims";
import { ChosenRecord, inTerm, termInWords } from "./choice";
import { LessonTable } from "./lessons";
import { fetchRecord, lessonsOf, type RecordOrState } from "./record";
import "./record.css";

/** More lessons than these have no room in the card. */
const MOST_BARS = 16;

export function RecordPage() {
  const opened = useSignal<RecordOrState>("loading");
  const chosen = useMemo(() => new ChosenRecord(), []);
  useEffect(() => void fetchRecord().then((found) => (opened.value = found)), []);
  const record = opened.value;
  if (typeof record === "string") return <Frame>{record !== "loading" && <p>{t(`page-record-${record}`)}</p>}</Frame>;
  const counted = inTerm(record, chosen.now.value);
  const term = termInWords(chosen.now.value);
  return (
    <Frame title={t("page-record-title")} tools={<Tools record={record} />}>
      <article class="record">
        <Term chosen={chosen} />
        <Summary record={counted} term={term} />
        {lessonsOf(counted).length === 0 ? (
          <p class="record-card record-none">{t(term ? "page-record-none-then" : "page-record-none")}</p>
        ) : (
          <>
            <LessonTable record={counted} />
            <Aims record={counted} chosen={chosen} />
          </>
        )}
        <footer>
          {[t("page-class-title", { title: record.title }), new Date().toLocaleDateString(language.value), term]
            .filter(Boolean)
            .join(" · ")}
        </footer>
      </article>
    </Frame>
  );
}

/** The days of the term; without them, everything is counted. */
function Term({ chosen }: { chosen: ChosenRecord }) {
  const { from, to } = chosen.now.value;
  return (
    <form class="record-term" aria-label={t("page-record-term")} title={t("page-record-term-help")}>
      <label>
        {t("page-record-from")}
        <input
          type="date"
          value={from}
          max={to}
          onChange={({ currentTarget }) => chosen.choose({ from: currentTarget.value })}
        />
      </label>
      <label>
        {t("page-record-to")}
        <input
          type="date"
          value={to}
          min={from}
          onChange={({ currentTarget }) => chosen.choose({ to: currentTarget.value })}
        />
      </label>
      {(from || to) && (
        <button type="button" class="button" onClick={() => chosen.choose({ from: "", to: "" })}>
          {t("page-record-always")}
        </button>
      )}
    </form>
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

function Summary({ record, term }: { record: PupilRecord; term: string }) {
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
        {term && <p class="dim">{term}</p>}
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
      >
        <HintBars lessons={lessons} />
      </Figure>
      <Figure
        icon="handedIn"
        word={t("page-class-hand-ins")}
        figure={handIns.length}
        more={improved ? t("page-record-improved", { count: improved }) : ""}
      />
    </header>
  );
}

/** How many hints each lesson needed, in the order in which they were worked on; the table has them in numbers. */
function HintBars({ lessons }: { lessons: readonly RecordedLesson[] }) {
  const most = Math.max(1, ...lessons.map(({ hints = 0 }) => hints));
  return (
    <span class="record-bars" aria-hidden="true">
      {lessons.slice(-MOST_BARS).map(({ name, hints = 0 }) => (
        <i key={name} class={hints ? "" : "none"} style={{ "--share": hints / most }} />
      ))}
    </span>
  );
}

interface FigureProps {
  readonly icon: IconName;
  readonly word: string;
  readonly figure: number;
  readonly more: string;
  readonly children?: ComponentChildren;
}

function Figure({ icon, word, figure, more, children }: FigureProps) {
  return (
    <div class="record-card">
      <p class="record-word">
        <Icon name={icon} />
        {word}
      </p>
      <p>
        <strong class="record-figure">{figure}</strong> {more}
      </p>
      {children}
    </div>
  );
}
