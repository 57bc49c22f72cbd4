/** The menu of lessons: search, levels, one's own; a picture, how long it takes and for which robots. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import type { LessonOffer } from "../../protocol/classroom";
import { Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { plain } from "../../ui/plain";
import { inLanguage } from "../lessons/texts";
import type { ClassStream } from "./stream";
import { pictureOf, robotsInWords } from "./words";

const LEVELS = [1, 2, 3, 4] as const;
type Shelf = (typeof LEVELS)[number] | "own";

interface Props {
  readonly stream: ClassStream;
  /** The lesson on; undefined without one. */
  readonly now: LessonOffer | undefined;
  readonly close: () => void;
}

export function HandOutDialog({ stream, now, close }: Props) {
  const offers = stream.offers.value;
  const next = offers[offers.findIndex(({ name }) => name === now?.name) + 1];
  const wanted = useSignal("");
  const shelf = useSignal<Shelf>(shelfOf(next ?? now));
  const chosen = useSignal((next ?? now)?.name ?? "");
  const shown = found(offers, wanted.value) ?? offers.filter((offer) => isOn(offer, shelf.value));
  const own = offers.filter((offer) => offer.own).length;
  const lesson = shown.find(({ name }) => name === chosen.value) ?? shown[0];
  const handOut = (event: Event) => {
    event.preventDefault();
    if (lesson && stream.send({ kind: "HandOut", lesson: lesson.name, project: inLanguage(lesson.title) })) close();
  };
  return (
    <Dialog title={t("page-class-hand-out")} close={close} size="large">
      <form class="hand-out" onSubmit={handOut}>
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
        </div>
        <div class="hand-out-cards" role="radiogroup" aria-label={t("page-class-lessons")}>
          {shown.map((offer) => (
            <Card
              key={offer.name}
              offer={offer}
              isChosen={offer === lesson}
              mark={offer.name === now?.name ? "on" : offer === next ? "next" : offer.own ? "own" : null}
              choose={() => (chosen.value = offer.name)}
            />
          ))}
          {shown.length === 0 && <p class="dim">{t("page-class-no-such-lesson")}</p>}
        </div>
        <div class="hand-out-foot">
          <p class="dim">{t("page-class-to-everyone")}</p>
          <button type="submit" class="button filled" disabled={!lesson}>
            <Icon name="send" />
            {t("page-class-hand-out-do")}
          </button>
        </div>
      </form>
    </Dialog>
  );
}

interface CardProps {
  readonly offer: LessonOffer;
  readonly isChosen: boolean;
  readonly mark: "on" | "next" | "own" | null;
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
