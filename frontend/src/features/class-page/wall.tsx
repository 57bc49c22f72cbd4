/** The teacher's wall: all pupils at once, those who need help first. */

import { type Signal, useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useMemo, useRef } from "preact/hooks";

import { language, t } from "../../i18n";
import type { LessonOffer, Seat, Wall } from "../../protocol/classroom";
import { Dialog } from "../../ui/dialog";
import { Logo } from "../start/logo";
import { HintDialog, PinDialog, RemoveDialog, RemovedDialog } from "./dialogs";
import { Filters } from "./filters";
import { Frame, Problem } from "./frame";
import { Grid, type GridProps } from "./grid";
import { HandOutDialog } from "./hand-out";
import { LessonButton, MinutesLeft, Tools } from "./head";
import { JoinRights, JoinSign } from "./join-sign";
import { usualLesson } from "./overview";
import { Side } from "./side";
import { Drawing } from "./small-world";
import { inOrder, type Order, type State, stateOf } from "./states";
import type { ClassStream } from "./stream";

type Place = "join" | "choosing" | "side";
/** What is open over the wall. Hints and lessons have the pupil's id, or an empty one for all. */
type Opened = { readonly kind: Place } | { readonly kind: "hint" | "lessons"; readonly to: string };

export function WallPage({ stream }: { stream: ClassStream }) {
  useEffect(() => stream.open(), []);
  const wall = stream.wall.value;
  if (!wall) return <Frame>{stream.state.value === "refused" && <p>{t("page-class-no-key")}</p>}</Frame>;
  return <OpenWall stream={stream} wall={wall} />;
}

function OpenWall({ stream, wall }: { stream: ClassStream; wall: Wall }) {
  const opened = useSignal<Opened | null>(null);
  const leaving = useSignal<readonly Seat[]>([]);
  const drawing = useMemo(() => new Drawing(), []);
  const joined = (wall.pupils ?? []).flatMap((id) => stream.seats.value.get(id) ?? []);
  const usual = usualLesson(joined) || wall.lesson;
  const lesson = stream.offers.value.find(({ name }) => name === usual);
  const show = (kind: Place) => () => (opened.value = { kind });
  const hint = (to: string) => (opened.value = { kind: "hint", to });
  const handOut = (to: string) => (opened.value = { kind: "lessons", to });
  const handOutAll = () => handOut("");
  const remove = (seats: readonly Seat[]) => (leaving.value = seats);
  const side = <Side stream={stream} seats={joined} lesson={lesson} handOut={handOutAll} />;
  const over = { stream, wall, opened, lesson, joined, side, remove };
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: F6 leads from part to part, wherever one is
    <div class={stream.state.value === "lost" ? "wall lost" : "wall"} onKeyDown={changeRegion}>
      <header class="class-bar" data-wall-region>
        <Logo />
        <h1>{t("page-class-title", { title: wall.title })}</h1>
        <LessonButton lesson={lesson} handOut={handOutAll} />
        <MinutesLeft lesson={lesson} began={wall.lesson === usual ? (wall.began ?? 0) : 0} />
        <Tools stream={stream} wall={wall} showJoin={show("join")} hintAll={() => hint("")} />
      </header>
      <main>
        <Problem isLost={stream.state.value === "lost"} problem={stream.refused.value} />
        <LackingLesson seats={joined} />
        <Knocking stream={stream} wall={wall} />
        {joined.length > 0 ? (
          <Pupils {...{ stream, wall, drawing, hint, handOut, remove }} seats={joined} openSide={show("side")} />
        ) : (
          <Empty wall={wall} />
        )}
        {joined.length > 0 && side}
        <Help seats={joined} />
      </main>
      <Over {...over} />
      {leaving.value.length > 0 && <RemoveDialog stream={stream} seats={leaving.value} close={() => remove([])} />}
      <PinDialog stream={stream} />
    </div>
  );
}

/** Before the first pupil has joined. */
function Empty({ wall }: { wall: Wall }) {
  return (
    <section class="wall-empty">
      <h2>{t("page-class-here", { count: 0 })}</h2>
      <JoinSign address={wall.address} word={wall.word} />
    </section>
  );
}

interface OverProps {
  readonly stream: ClassStream;
  readonly wall: Wall;
  readonly opened: Signal<Opened | null>;
  readonly lesson: LessonOffer | undefined;
  /** The pupils, in the order in which they joined. */
  readonly joined: readonly Seat[];
  readonly side: ComponentChildren;
  readonly remove: (seats: readonly Seat[]) => void;
}

/** What is open over the wall. */
function Over({ stream, wall, opened, lesson, joined, side, remove }: OverProps) {
  const now = opened.value;
  const close = () => (opened.value = null);
  switch (now?.kind) {
    case "lessons":
      return <HandOutDialog stream={stream} now={lesson} seats={joined} to={now.to} close={close} />;
    case "side":
      return (
        <Dialog title={t("page-class-side")} close={close}>
          {side}
        </Dialog>
      );
    case "join":
      return (
        <Dialog title={t("page-class-here", { count: joined.filter(({ here }) => here).length })} close={close}>
          <JoinSign address={wall.address} word={wall.word} />
          <JoinRights stream={stream} wall={wall} remove={() => (opened.value = { kind: "choosing" })} />
        </Dialog>
      );
    case "hint": {
      const { question = "", name = "" } = joined.find(({ id }) => id === now.to) ?? {};
      return <HintDialog {...{ stream, question, close, name }} to={now.to} />;
    }
    case "choosing":
      return <RemovedDialog seats={joined} remove={remove} close={close} />;
    default:
      return null;
  }
}

interface PupilsProps extends Omit<GridProps, "isBusy"> {
  readonly openSide: () => void;
}

/** The tiles with their filters. While the teacher is at them, they keep their places. */
function Pupils({ stream, wall, drawing, seats, hint, handOut, remove, openSide }: PupilsProps) {
  const filter = useSignal<State | null>(null);
  const order = useSignal<Order>("need");
  const isBusy = useSignal(false);
  const kept = useRef<{ key: string; ids: readonly string[] }>({ key: "", ids: [] });
  const wanted = inOrder(
    seats.filter((seat) => !filter.value || stateOf(seat) === filter.value),
    order.value,
  );
  const key = `${filter.value} ${order.value}`;
  const isNew = kept.current.key !== key || !isBusy.value;
  if (isNew) kept.current = { key, ids: wanted.map(({ id }) => id) };
  const shown = isNew ? wanted : inPlace(wanted, seats, kept.current.ids);
  const changes = wanted.filter(({ id }, i) => shown[i]?.id !== id).length;
  const sort = () => {
    kept.current = { key: "", ids: [] };
    isBusy.value = false;
  };
  return (
    <div class="wall-pupils">
      <Filters seats={seats} filter={filter} order={order} changes={changes} sort={sort} openSide={openSide} />
      <p id="wall-keys" class="hidden">
        {t("page-class-keys")}
      </p>
      <Grid {...{ stream, drawing, wall, isBusy, hint, handOut, remove }} seats={shown} />
    </div>
  );
}

/** The pupils where they were before; others come last, and those who have left the class are gone. */
function inPlace(wanted: readonly Seat[], all: readonly Seat[], ids: readonly string[]): Seat[] {
  const known = new Map(all.map((seat) => [seat.id, seat]));
  return [...ids.flatMap((id) => known.get(id) ?? []), ...wanted.filter(({ id }) => !ids.includes(id))];
}

/** F6 leads to the next part of the wall, and with Shift to the one before. */
function changeRegion(event: KeyboardEvent): void {
  if (event.key !== "F6") return;
  event.preventDefault();
  const page = event.currentTarget as HTMLElement;
  const regions = [...page.querySelectorAll<HTMLElement>("[data-wall-region]")].filter(
    ({ offsetWidth }) => offsetWidth,
  );
  const at = regions.findIndex((region) => region.contains(document.activeElement));
  const next = regions[(at + (event.shiftKey ? regions.length - 1 : 1)) % regions.length];
  const stop =
    next?.querySelector<HTMLElement>('[tabindex="0"]') ?? next?.querySelector<HTMLElement>("button, a, select");
  stop?.focus();
}

/** Says to screen readers who asks for help. */
function Help({ seats }: { seats: readonly Seat[] }) {
  const asking = seats.filter(({ hand }) => hand).sort((one, other) => (one.waits ?? 0) - (other.waits ?? 0));
  const [newest] = asking;
  return (
    <p class="hidden" role="status">
      {newest && t("page-class-asks", { name: newest.name ?? "" })}
    </p>
  );
}

/** The pupils at a hub whose servers have refused a lesson of the teacher's own. */
function LackingLesson({ seats }: { seats: readonly Seat[] }) {
  const lacking = seats.filter(({ lacks_lesson }) => lacks_lesson);
  const names = new Intl.ListFormat(language.value).format(lacking.map(({ name = "" }) => name));
  return (
    <p role="alert" class={lacking.length ? "class-problem" : "hidden"}>
      {lacking.length > 0 && t("page-class-lacks-lesson", { names })}
    </p>
  );
}

/** New pupils whom the teacher has to let in, because so many have joined. */
function Knocking({ stream, wall }: { stream: ClassStream; wall: Wall }) {
  const { knocking = [], pupils = [], more } = wall;
  const answer = (on: boolean) => stream.send({ kind: "AnswerKnocking", on });
  return (
    <div role="status" class={knocking.length ? "class-knocking" : "hidden"}>
      {knocking.length > 0 && (
        <>
          <p>{t("page-class-knocking", { count: pupils.length, names: knocking.join(", ") })}</p>
          <div class="class-tools">
            <button type="button" class="button filled" onClick={() => answer(true)}>
              {t("page-class-let-in", { count: more })}
            </button>
            <button type="button" class="button bordered" onClick={() => answer(false)}>
              {t("page-class-let-in-not")}
            </button>
          </div>
        </>
      )}
    </div>
  );
}
