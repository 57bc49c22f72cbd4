/** The menu of lessons: search, levels, one's own; a picture, how long it takes and for which robots. */

import { type Signal, useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";

import { t } from "../../i18n";
import type { LessonOffer, Seat } from "../../protocol/classroom";
import { Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { plain } from "../../ui/plain";
import { inLanguage } from "../lessons/texts";
import { AddLesson } from "./add-lesson";
import { DeleteLesson } from "./delete-lesson";
import { nextAfter } from "./overview";
import { PupilTick } from "./pupil-tick";
import type { ClassStream } from "./stream";
import { pictureOf, robotsInWords } from "./words";

const LEVELS = [1, 2, 3, 4] as const;
type Shelf = (typeof LEVELS)[number] | "own";
type Mark = "on" | "next" | "own";

interface Props {
  readonly stream: ClassStream;
  /** The lesson on; undefined without one. */
  readonly now: LessonOffer | undefined;
  /** The pupils, in the order in which they joined. */
  readonly seats: readonly Seat[];
  /** The id of the pupil for whom a lesson is chosen; empty for all. */
  readonly to: string;
  readonly close: () => void;
}

export function HandOutDialog({ stream, now, seats, to, close }: Props) {
  const offers = stream.offers.value;
  const next = nextAfter(offers, now);
  const wanted = useSignal("");
  const shelf = useSignal<Shelf>(shelfOf(next ?? now));
  const chosen = useSignal((next ?? now)?.name ?? "");
  const shown = found(offers, wanted.value) ?? offers.filter((offer) => isOn(offer, shelf.value));
  const own = offers.filter((offer) => offer.own).length;
  // A lesson that has just been added is not among the offers yet.
  const isComing = chosen.value !== "" && !offers.some(({ name }) => name === chosen.value);
  const lesson = isComing ? undefined : (shown.find(({ name }) => name === chosen.value) ?? shown[0]);
  const choose = (name: string) => {
    wanted.value = "";
    shelf.value = "own";
    chosen.value = name;
  };
  const forget = () => {
    chosen.value = "";
    // That lesson may be the one that is on.
    if (own === 1) shelf.value = now?.own ? 1 : shelfOf(now);
  };
  // Null for all.
  const recipients = useSignal<ReadonlySet<string> | null>(to ? new Set([to]) : null);
  // A step belongs to the lesson for which it was chosen.
  const from = useSignal({ lesson: "", step: 0 });
  const step = from.value.lesson === lesson?.name ? from.value.step : 0;
  const handOut = (event: Event) => {
    event.preventDefault();
    if (!lesson) return;
    const project = inLanguage(lesson.title);
    const pupils = recipients.value && [...recipients.value];
    if (stream.send({ kind: "HandOut", lesson: lesson.name, project, pupils, step })) close();
  };
  return (
    <Dialog title={t("page-class-hand-out")} close={close} size="large">
      <form class="hand-out" onSubmit={handOut}>
        <Shelves {...{ wanted, shelf }} own={own}>
          <AddLesson offers={offers} choose={choose} />
          {lesson?.own && <DeleteLesson lesson={lesson} done={forget} />}
        </Shelves>
        <div class="hand-out-cards" role="radiogroup" aria-label={t("page-class-lessons")}>
          {shown.map((offer) => (
            <Card
              key={offer.name}
              offer={offer}
              isChosen={offer === lesson}
              mark={markOf(offer, now, next)}
              choose={() => (chosen.value = offer.name)}
            />
          ))}
          {shown.length === 0 && <p class="dim">{t("page-class-no-such-lesson")}</p>}
        </div>
        <Recipients
          {...{ seats, lesson, recipients, step }}
          choose={(step) => (from.value = { lesson: lesson?.name ?? "", step })}
        />
      </form>
    </Dialog>
  );
}

interface ShelvesProps {
  readonly wanted: Signal<string>;
  readonly shelf: Signal<Shelf>;
  /** How many lessons are the teacher's own. */
  readonly own: number;
  /** Beside them. */
  readonly children: ComponentChildren;
}

/** The search, and the lessons of a level or one's own. */
function Shelves({ wanted, shelf, own, children }: ShelvesProps) {
  return (
    <div class="hand-out-head">
      <label class="hand-out-search">
        <Icon name="find" />
        <input
          type="search"
          aria-label={t("page-class-find-lesson")}
          placeholder={t("page-class-find-lesson")}
          value={wanted.value}
          onInput={({ currentTarget }) => (wanted.value = currentTarget.value)}
        />
      </label>
      <div class="chips" role="group" aria-label={t("page-lesson-cards-levels")}>
        {[...LEVELS, ...(own ? (["own"] as const) : [])].map((one) => (
          <button
            key={one}
            type="button"
            class="chip"
            aria-pressed={!wanted.value && one === shelf.value}
            onClick={() => {
              wanted.value = "";
              shelf.value = one;
            }}
          >
            {one === "own" ? t("page-class-own-lessons", { count: own }) : t("page-class-level", { level: one })}
          </button>
        ))}
      </div>
      {children}
    </div>
  );
}

interface RecipientsProps {
  readonly seats: readonly Seat[];
  readonly lesson: LessonOffer | undefined;
  /** The ids of those who get the lesson; null for all. */
  readonly recipients: Signal<ReadonlySet<string> | null>;
  /** The step to begin with; 0 for where each pupil is. */
  readonly step: number;
  readonly choose: (step: number) => void;
}

/** Who gets the lesson, and from which step. */
function Recipients({ seats, lesson, recipients, step, choose }: RecipientsProps) {
  const chosen = recipients.value;
  return (
    <>
      {chosen && <RecipientTicks seats={seats} chosen={chosen} choose={(ids) => (recipients.value = ids)} />}
      <div class="hand-out-foot">
        <select
          aria-label={t("page-class-receiving")}
          value={chosen ? "some" : "all"}
          onChange={({ currentTarget }) => (recipients.value = currentTarget.value === "some" ? new Set() : null)}
        >
          <option value="all">{t("page-class-to-all")}</option>
          <option value="some">{t("page-class-to-some", { count: chosen?.size ?? 0 })}</option>
        </select>
        <select
          aria-label={t("page-class-from")}
          value={step}
          onChange={({ currentTarget }) => choose(Number(currentTarget.value))}
        >
          <option value={0}>{t("page-class-from-own")}</option>
          {lesson?.steps.map((title, i) => (
            <option key={i} value={i + 1}>
              {t("page-class-from-step", { step: i + 1, title: inLanguage(title) })}
            </option>
          ))}
        </select>
        <p class="dim">{t(chosen ? "page-class-to-these" : "page-class-to-everyone")}</p>
        <button type="submit" class="button filled" disabled={!lesson || chosen?.size === 0}>
          <Icon name="send" />
          {t("page-class-hand-out-do")}
        </button>
      </div>
    </>
  );
}

interface RecipientTicksProps {
  readonly seats: readonly Seat[];
  readonly chosen: ReadonlySet<string>;
  readonly choose: (chosen: ReadonlySet<string>) => void;
}

/** The pupils to choose from. */
function RecipientTicks({ seats, chosen, choose }: RecipientTicksProps) {
  return (
    <fieldset class="hand-out-pupils">
      <legend>{t("page-class-receiving")}</legend>
      {seats.map((seat) => (
        <PupilTick key={seat.id} {...{ seat, chosen, choose }} />
      ))}
    </fieldset>
  );
}

interface CardProps {
  readonly offer: LessonOffer;
  readonly isChosen: boolean;
  readonly mark: Mark | null;
  readonly choose: () => void;
}

function Card({ offer, isChosen, mark, choose }: CardProps) {
  const picture = pictureOf(offer);
  const { minutes, robots } = offer;
  return (
    <label class="hand-out-card">
      <input type="radio" name="lesson" checked={isChosen} onChange={choose} />
      {picture ? <img src={picture} alt="" width={240} height={135} loading="lazy" /> : <span class="hand-out-blank" />}
      {mark && <span class="hand-out-mark">{t(`page-class-lesson-${mark}`)}</span>}
      <strong>{inLanguage(offer.title)}</strong>
      <small>{[t("page-lesson-minutes", { minutes }), robotsInWords(robots)].join(" · ")}</small>
    </label>
  );
}

function markOf(offer: LessonOffer, now: LessonOffer | undefined, next: LessonOffer | undefined): Mark | null {
  if (offer.name === now?.name) return "on";
  if (offer === next) return "next";
  return offer.own ? "own" : null;
}

function shelfOf(offer: LessonOffer | undefined): Shelf {
  if (offer?.own) return "own";
  return LEVELS.find((level) => level === offer?.level) ?? 1;
}

function isOn(offer: LessonOffer, shelf: Shelf): boolean {
  return shelf === "own" ? (offer.own ?? false) : !offer.own && offer.level === shelf;
}

/** The lessons with these words in their titles or steps; null without any words. */
function found(offers: readonly LessonOffer[], words: string): LessonOffer[] | null {
  const wanted = plain(words).split(/\s+/).filter(Boolean);
  if (wanted.length === 0) return null;
  return offers.filter(({ title, steps }) => {
    const text = plain([title, ...steps].map((one) => inLanguage(one)).join(" "));
    return wanted.every((word) => text.includes(word));
  });
}
