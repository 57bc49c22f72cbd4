/** Lesson by lesson: when, how far, with how many tries and hints, and what the teacher has said. */

import { language, t } from "../../i18n";
import type { PupilRecord, RecordedLesson } from "../../protocol/classroom";
import { Icon } from "../../ui/icons";
import { pictureOf } from "../class-page/words";
import { inLanguage } from "../lessons/texts";
import { lessonsOf } from "./record";

export function LessonTable({ record }: { record: PupilRecord }) {
  const lessons = lessonsOf(record);
  const most = Math.max(1, ...lessons.map(({ hints = 0 }) => hints));
  return (
    <section class="record-card" aria-labelledby="record-lessons">
      <h3 id="record-lessons">{t("page-record-lessons")}</h3>
      <table class="record-lessons">
        <thead>
          <tr>
            <th scope="col">{t("page-record-date")}</th>
            <th scope="col">{t("page-handins-lesson")}</th>
            <th scope="col">{t("page-class-stars")}</th>
            <th scope="col">{t("page-class-tries")}</th>
            <th scope="col">{t("page-record-hints")}</th>
            <th scope="col">{t("page-class-mark")}</th>
          </tr>
        </thead>
        <tbody>
          {lessons.map((lesson) => (
            <Row key={lesson.name} lesson={lesson} most={most} teaches={record.teaches ?? false} />
          ))}
        </tbody>
      </table>
    </section>
  );
}

/** The pictures are at the address of a pupil's page. */
function Row({ lesson, most, teaches }: { lesson: RecordedLesson; most: number; teaches: boolean }) {
  const { title, at = 0, stars = 0, all_stars = 0, runs = 0, hints = 0 } = lesson;
  const date = new Date(at * 1000).toLocaleDateString(language.value, { day: "numeric", month: "short" });
  const picture = pictureOf(lesson);
  return (
    <tr>
      <td>{at > 0 && date}</td>
      <th scope="row">
        {picture && <img src={(teaches ? "../../" : "") + picture} alt="" width={70} height={48} loading="lazy" />}
        <span>
          {inLanguage(title)}
          <small>{storyOf(lesson)}</small>
        </span>
      </th>
      <td>
        <Icon name={stars ? "earned" : "star"} />
        {t("page-class-some-of", { count: stars, all: all_stars })}
      </td>
      <td>{runs}</td>
      <td class="record-hints">
        {hints > 0 && <i style={{ inlineSize: `${(48 * hints) / most}px` }} />}
        {hints || t("page-record-no-hints")}
      </td>
      <td>
        <strong>{marksOf(lesson)}</strong>
      </td>
    </tr>
  );
}

/** How far it is, and the teacher's last note. */
function storyOf({ done, step = 1, steps = 0, hand_ins = [] }: RecordedLesson): string {
  const note = hand_ins.findLast((handIn) => handIn.note)?.note;
  const waits = hand_ins.some((handIn) => handIn.waits);
  return [
    !done && steps > 0 && t("page-record-step", { step, steps }),
    waits && t("page-record-waits"),
    note && t("page-class-said", { question: note }),
  ]
    .filter(Boolean)
    .join(" · ");
}

/** The marks of each hand-in, and how they changed. */
function marksOf({ hand_ins = [] }: RecordedLesson): string {
  return hand_ins
    .filter(({ marks = [] }) => marks.length > 0)
    .map(({ marks = [] }) => marks.filter((mark, i) => mark !== marks[i - 1]).join(" → "))
    .join(", ");
}
