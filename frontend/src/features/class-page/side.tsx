/** Beside the tiles: who waits for the teacher, where the class is, and what is ready to be looked at. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import type { LessonOffer, Seat, WaitingHandIn } from "../../protocol/classroom";
import { Icon, type IconName } from "../../ui/icons";
import { inLanguage } from "../lessons/texts";
import { handInPage } from "./hand-in-address";
import {
  commonMistake,
  type FinishedWork,
  finishedWork,
  nextAfter,
  placesIn,
  readyFor,
  showing,
  waiting,
} from "./overview";
import { minutes, STATE_ICONS, stateOf } from "./states";
import type { ClassStream } from "./stream";
import { findingInWords, pageOf } from "./tile";
import { missedInWords } from "./words";

/** Who is shown in each list; the wall has the others. */
const MOST_WAITING = 3;
const MOST_FINISHED = 5;

interface Props {
  readonly stream: ClassStream;
  readonly seats: readonly Seat[];
  readonly lesson: LessonOffer | undefined;
  readonly handOut: () => void;
}

export function Side({ stream, seats, lesson, handOut }: Props) {
  return (
    <aside class="wall-side" aria-label={t("page-class-side")} data-wall-region>
      <Waiting seats={seats} />
      <Where stream={stream} seats={seats} lesson={lesson} handOut={handOut} />
      <HandIns stream={stream} seats={seats} />
      <Shown stream={stream} />
    </aside>
  );
}

function Title({ icon, text, more }: { icon: IconName; text: string; more?: string }) {
  return (
    <h2 class="wall-card-title">
      <Icon name={icon} />
      <span>{text}</span>
      {more && <small>{more}</small>}
    </h2>
  );
}

function Waiting({ seats }: Pick<Props, "seats">) {
  const all = [...waiting(seats).map(calling), ...showing(seats).map(shownBy)];
  return (
    <section class="wall-card" aria-label={t("page-class-waiting-for-you")}>
      <Title icon="hand" text={t("page-class-waiting-for-you")} />
      {all.length === 0 && <p class="dim">{t("page-class-none-waiting")}</p>}
      <ul>
        {all.slice(0, MOST_WAITING).map(({ key, look, icon, seat, why }) => (
          <li key={key} class={`waiting ${look}`}>
            <Icon name={icon} />
            <span>
              <bdi>{seat.name}</bdi>
              <small>{why}</small>
            </span>
            <a class="button" href={pageOf(seat)} target="_blank" rel="noopener opener">
              {t("page-class-look")}
            </a>
          </li>
        ))}
      </ul>
      {all.length > MOST_WAITING && (
        <p class="dim">{t("page-class-more-wait", { count: all.length - MOST_WAITING })}</p>
      )}
    </section>
  );
}

/** Why a pupil waits for the teacher, and what the teacher then looks at. */
interface Entry {
  readonly key: string;
  readonly look: string;
  readonly icon: IconName;
  readonly seat: Seat;
  readonly why: string;
}

function calling(seat: Seat): Entry {
  const look = stateOf(seat);
  return { key: seat.id, look, icon: STATE_ICONS[look], seat, why: whyInWords(seat) };
}

/** The entry of a pupil who shows a project, which need not be the one that is open. */
function shownBy(seat: Seat): Entry {
  const project = seat.shows ?? "";
  const why = t("page-class-shows", { project });
  return { key: `${seat.id} shows`, look: "shows", icon: "share", seat: { ...seat, project }, why };
}

/** What pupils have shown each other; nothing before they have. */
function Shown({ stream }: Pick<Props, "stream">) {
  const seats = stream.seats.value;
  const name = (id: string) => seats.get(id)?.name ?? "";
  const shown = stream.wall.value?.shown ?? [];
  if (shown.length === 0) return null;
  return (
    <section class="wall-card" aria-label={t("page-class-shown")}>
      <Title icon="share" text={t("page-class-shown")} />
      <ul class="wall-shown dim">
        {shown.map(({ pupil, classmate, project }, i) => (
          <li key={i}>{t("page-class-shown-to", { name: name(pupil), classmate: name(classmate), project })}</li>
        ))}
      </ul>
    </section>
  );
}

function whyInWords(seat: Seat): string {
  if (stateOf(seat) === "help") {
    const waited = t("page-class-minutes", { minutes: Math.floor((seat.waits ?? 0) / 60) });
    return [waited, seat.question || findingInWords(seat)].filter(Boolean).join(" · ");
  }
  const { step = 0, tries = 0 } = seat;
  if (step && tries) return t("page-class-tried", { step, tries });
  return t("page-class-state-stuck", { minutes: minutes(seat.stuck) });
}

/** How many pupils are in each step, and what most of them miss. */
function Where({ stream, seats, lesson, handOut }: Props) {
  return (
    <section class="wall-card" aria-label={t("page-class-where")}>
      <Title icon="target" text={t("page-class-where")} />
      {lesson ? (
        <>
          <Steps seats={seats} lesson={lesson} />
          <NextLesson stream={stream} seats={seats} lesson={lesson} />
        </>
      ) : (
        <>
          <p class="dim">{t("page-class-no-lesson")}</p>
          <button type="button" class="button bordered" onClick={handOut}>
            {t("page-class-hand-out")}
          </button>
        </>
      )}
    </section>
  );
}

function Steps({ seats, lesson }: { seats: readonly Seat[]; lesson: LessonOffer }) {
  const { steps, notBegun } = placesIn(seats, lesson.name, lesson.steps.length);
  const mistake = commonMistake(seats, lesson.name);
  const most = Math.max(1, ...steps, notBegun);
  return (
    <>
      <ol class="wall-steps">
        {lesson.steps.map((title, i) => (
          <Bar key={i} text={`${i + 1} ${inLanguage(title)}`} count={steps[i] ?? 0} most={most} />
        ))}
        <Bar text={t("page-class-state-not-begun")} count={notBegun} most={most} isDim />
      </ol>
      {mistake && (
        <p class="wall-mistake">
          {t("page-class-mistake", {
            step: mistake.step,
            count: mistake.count,
            tried: mistake.tried,
            what: missedInWords(mistake.missed),
          })}
        </p>
      )}
    </>
  );
}

interface NextProps {
  readonly stream: ClassStream;
  readonly seats: readonly Seat[];
  /** The lesson on. */
  readonly lesson: LessonOffer;
}

/** Hands out the next lesson to all who have finished this one. */
function NextLesson({ stream, seats, lesson }: NextProps) {
  // Then that lesson may be the one that is on.
  const given = useSignal({ title: "", count: 0 });
  const next = nextAfter(stream.offers.value, lesson);
  const ready = readyFor(seats, lesson);
  const handOut = ({ name, title }: LessonOffer) => {
    const project = inLanguage(title);
    const pupils = ready.map(({ id }) => id);
    if (stream.send({ kind: "HandOut", lesson: name, project, pupils }))
      given.value = { title: project, count: pupils.length };
  };
  return (
    <>
      {next && ready.length > 0 && (
        <button type="button" class="button bordered wall-next" onClick={() => handOut(next)}>
          <Icon name="send" />
          {t("page-class-next-lesson", { title: inLanguage(next.title), count: ready.length })}
        </button>
      )}
      <p role="status" class={given.value.count > 0 ? "dim" : "hidden"}>
        {given.value.count > 0 && t("page-class-next-given", { ...given.value })}
      </p>
    </>
  );
}

function Bar({ text, count, most, isDim = false }: { text: string; count: number; most: number; isDim?: boolean }) {
  return (
    <li class={isDim ? "dim" : undefined}>
      <span>{text}</span>
      <i aria-hidden="true">
        <b style={{ inlineSize: `${(100 * count) / most}%` }} />
      </i>
      <strong>{count}</strong>
    </li>
  );
}

function HandIns({ stream, seats }: Pick<Props, "stream" | "seats">) {
  const { hand_ins = [], more = 0 } = stream.waiting.value;
  const all = finishedWork(seats, hand_ins);
  const pupils = new Set(all.map(({ seat }) => seat.id)).size;
  const others = Math.max(0, all.length - MOST_FINISHED) + more;
  return (
    <section class="wall-card" aria-label={t("page-class-hand-ins")}>
      <Title
        icon="handedIn"
        text={t("page-class-hand-ins")}
        more={t("page-class-some-of", { count: pupils, all: seats.length })}
      />
      {all.length === 0 ? <p class="dim">{t("page-class-no-hand-ins")}</p> : <HandInTable all={all} />}
      {others > 0 && <p class="dim">{t("page-class-more-wait", { count: others })}</p>}
      <a class="button bordered" href="hand-ins">
        <Icon name="saved" />
        {t("page-handins-title")}
      </a>
    </section>
  );
}

function HandInTable({ all }: { all: readonly FinishedWork[] }) {
  return (
    <table class="wall-hand-ins">
      <thead>
        <tr>
          <th scope="col">{t("page-class-pupil")}</th>
          <th scope="col">{t("page-class-stars")}</th>
          <th scope="col">{t("page-class-tries")}</th>
          <th scope="col">{t("page-class-mark")}</th>
        </tr>
      </thead>
      <tbody>
        {all.slice(0, MOST_FINISHED).map((work) => (
          <HandInRow key={[work.seat.id, work.left?.lesson, work.left?.step].join("/")} work={work} />
        ))}
      </tbody>
    </table>
  );
}

function HandInRow({ work: { seat, isToMark, left } }: { work: FinishedWork }) {
  const { name, lesson_name, stars = 0, all_stars = 0, tries = 0 } = seat;
  // The wall knows the stars of the lesson that is open.
  const isOpen = !left || left.lesson === lesson_name;
  const handIn = left ?? (seat.hand_in ? { lesson: lesson_name ?? "", step: seat.step ?? 0 } : null);
  return (
    <tr>
      <th scope="row">
        {handIn ? (
          <a href={handInPage({ ...handIn, pupil: seat.id })}>
            <bdi>{name}</bdi>
          </a>
        ) : (
          <bdi>{name}</bdi>
        )}
        {left && <small>{placeInWords(left, isOpen)}</small>}
      </th>
      <td>
        {isOpen ? (
          <>
            <Icon name={stars ? "earned" : "star"} />
            {t("page-class-some-of", { count: stars, all: all_stars })}
          </>
        ) : (
          "–"
        )}
      </td>
      <td>{left ? (left.tries ?? 0) : tries}</td>
      <td>{t(isToMark ? "page-class-to-mark" : "page-class-done")}</td>
    </tr>
  );
}

function placeInWords({ title, step }: WaitingHandIn, isOpen: boolean): string {
  return isOpen ? t("page-class-of-step", { step }) : t("page-class-of-lesson", { title: inLanguage(title), step });
}
