/** A pupil on the wall: a picture, the name, the state and the steps of the lesson. */

import type { Phrase } from "../../i18n";
import { say, t } from "../../i18n";
import type { Seat } from "../../protocol/classroom";
import { Icon } from "../../ui/icons";
import { Menu, type MenuGroup, type MenuItem } from "../../ui/menu";
import { inLanguage } from "../lessons/texts";
import { type Drawing, SmallWorld } from "./small-world";
import { isOld, minutes, STATE_ICONS, type State, stateOf } from "./states";
import type { ClassStream } from "./stream";
import { missedInWords } from "./words";

interface Props {
  readonly stream: ClassStream;
  readonly drawing: Drawing;
  readonly seat: Seat;
  /** How much larger than usual the picture is drawn. */
  readonly scale: number;
  readonly isProjected: boolean;
  /** Whether the Tab key leads here. */
  readonly isCurrent: boolean;
  readonly hint: () => void;
  /** Choose a lesson for this pupil. */
  readonly handOut: () => void;
  readonly remove: () => void;
}

/** The states in which nothing new is in the picture. */
const GREY: ReadonlySet<State> = new Set(["away", "not-begun"]);

/*
 * What depends on the state has a class of its own: in Chromium, styles that depend on the class of a tile can stay as
 * they were if the tile has moved meanwhile.
 */
export function Tile({ stream, drawing, seat, scale, isProjected, isCurrent, hint, handOut, remove }: Props) {
  const { id, name = "" } = seat;
  const state = stateOf(seat);
  const finding = findingInWords(seat);
  return (
    <div
      role="row"
      class={`tile ${state}`}
      tabIndex={isCurrent ? 0 : -1}
      data-pupil={id}
      aria-label={[name, stateInWords(seat), stepInWords(seat), finding].filter(Boolean).join(". ")}
    >
      {/* biome-ignore lint/a11y/useFocusableInteractive: the focus goes from row to row */}
      <div class="tile-picture" role="gridcell">
        <SmallWorld
          drawing={drawing}
          plan={stream.plans.value.get(id)}
          seat={seat}
          isGrey={isOld(seat) || GREY.has(state)}
          label={t("page-class-world-of", { name })}
          base={`p/${id}/`}
          scale={scale}
        />
        {finding && <p class={state === "help" || seat.shows ? "tile-finding said" : "tile-finding"}>{finding}</p>}
        <div class="tile-tools">
          <a class="button filled" href={pageOf(seat)} target="_blank" rel="noopener opener" tabIndex={-1}>
            {t("page-class-look")}
          </a>
          <button type="button" class="button tile-tool" tabIndex={-1} onClick={hint}>
            <Icon name="hint" />
            <span>{t("page-class-hint")}</span>
          </button>
          <Menu
            label={t("page-class-more", { name })}
            icon="more"
            side="right"
            look="tile-tool"
            tabIndex={-1}
            groups={moreOf(stream, id, isProjected, handOut, remove)}
          />
        </div>
      </div>
      {/* biome-ignore lint/a11y/useFocusableInteractive: the focus goes from row to row */}
      <div class="tile-words" role="gridcell">
        <p class="tile-head">
          <bdi class="tile-name">{name}</bdi>
          <StateChip seat={seat} />
        </p>
        <StepBar seat={seat} />
      </div>
    </div>
  );
}

function moreOf(
  stream: ClassStream,
  id: string,
  isProjected: boolean,
  handOut: () => void,
  remove: () => void,
): MenuGroup[] {
  const newPictures: MenuItem = {
    text: t("page-class-renew-pin"),
    icon: "image",
    run: () => stream.send({ kind: "RenewPin", pupil: id }),
  };
  return [
    {
      items: [
        { text: t("page-class-hand-out-one"), icon: "lesson", run: handOut },
        {
          text: t(isProjected ? "page-class-unproject" : "page-class-project"),
          icon: "projector",
          run: () => stream.send({ kind: "ShowOnProjector", pupil: isProjected ? null : id }),
        },
      ],
    },
    {
      items: [
        // At a hub, pupils log in without pictures.
        ...(stream.wall.value?.word ? [newPictures] : []),
        { text: t("page-record-of-pupil"), icon: "lesson", run: () => location.assign(`p/${id}/record`) },
        { text: t("page-class-export"), icon: "download", run: () => location.assign(`export.zip?pupil=${id}`) },
        { text: t("page-class-remove"), icon: "trash", run: remove },
      ],
    },
  ];
}

function StateChip({ seat }: { seat: Seat }) {
  const state = stateOf(seat);
  return (
    <span class={`tile-state ${state}`}>
      <Icon name={STATE_ICONS[state]} />
      <span>{stateInWords(seat)}</span>
    </span>
  );
}

export function stateInWords(seat: Seat): string {
  const state = stateOf(seat);
  return t(`page-class-state-${state}`, { minutes: minutes(seat.stuck) });
}

/** A bar for each step: behind the pupil, or the one that is open. */
function StepBar({ seat: { step = 0, steps = 0, done = [], begun } }: { seat: Seat }) {
  return (
    <div class="tile-steps" aria-hidden="true">
      {Array.from({ length: Math.max(1, steps) }, (_, i) => (
        <i key={i} class={begun ? (done[i] ? "done" : i + 1 === step ? "now" : "") : ""} />
      ))}
    </div>
  );
}

function stepInWords({ lesson, step = 0, steps = 0, stars = 0, project = "" }: Seat): string {
  if (!step || !lesson) return project;
  return t("page-class-step", { title: inLanguage(lesson), step, steps, stars });
}

/** What there is to say about a pupil: the question, what is shown, a mistake, or what the last run missed. */
export function findingInWords({ hand, question, shows, error, missed }: Seat): string {
  if (hand && question) return t("page-class-said", { question });
  if (shows) return t("page-class-shows", { project: shows });
  if (error) return say(error as unknown as Phrase);
  return missed ? missedInWords(missed) : "";
}

/** The pupil's page, with the project that the pupil sees. */
export function pageOf({ id, project }: Seat): string {
  return project ? `p/${id}/#${new URLSearchParams({ project })}` : `p/${id}/`;
}
