/** The teacher's wall: all pupils at once, those who need help first. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { language, say, t } from "../../i18n";
import type { Seat, Wall } from "../../protocol/classroom";
import { Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { Menu } from "../../ui/menu";
import { byNeed } from "./attention";
import { Frame } from "./frame";
import { PictureRow } from "./pictures";
import { QrCode } from "./qr-code";
import type { ClassStream } from "./stream";
import { Tile } from "./tile";

/** Whom a hint is for: a pupil, or everybody. */
type Hinted = Seat | "all" | null;

export function WallPage({ stream }: { stream: ClassStream }) {
  const hinted = useSignal<Hinted>(null);
  const leaving = useSignal<readonly Seat[]>([]);
  const choosing = useSignal(false);
  useEffect(() => stream.open(), []);
  const wall = stream.wall.value;
  if (!wall) return <Frame>{stream.state.value === "refused" && <p>{t("page-class-no-key")}</p>}</Frame>;
  const seats = byNeed(stream.seats.value.values());
  return (
    <Frame
      title={t("page-class-title", { title: wall.title })}
      tools={<Tools stream={stream} wall={wall} hintAll={() => (hinted.value = "all")} />}
    >
      <Lost stream={stream} />
      <Knocking stream={stream} wall={wall} />
      <HowToJoin
        stream={stream}
        wall={wall}
        count={seats.filter(({ here }) => here).length}
        remove={() => (choosing.value = true)}
      />
      <ul class="tiles" aria-label={t("page-class-pupils")}>
        {seats.map((seat) => (
          <Tile
            key={seat.id}
            stream={stream}
            seat={seat}
            isProjected={wall.projected === seat.id}
            hint={() => (hinted.value = seat)}
            remove={() => (leaving.value = [seat])}
          />
        ))}
      </ul>
      {hinted.value && <HintDialog stream={stream} to={hinted.value} close={() => (hinted.value = null)} />}
      {choosing.value && (
        <RemovedDialog
          seats={wall.pupils?.map((id) => stream.seats.value.get(id)) ?? []}
          remove={(chosen) => (leaving.value = chosen)}
          close={() => (choosing.value = false)}
        />
      )}
      {leaving.value.length > 0 && (
        <RemoveDialog stream={stream} seats={leaving.value} close={() => (leaving.value = [])} />
      )}
      <PinDialog stream={stream} />
    </Frame>
  );
}

function Lost({ stream }: { stream: ClassStream }) {
  const refused = stream.refused.value;
  const lost = stream.state.value === "lost";
  return (
    <p role="alert" class={lost || refused ? "class-problem" : "hidden"}>
      {lost ? t("page-shell-lost") : refused && say(refused)}
    </p>
  );
}

function Tools({ stream, wall, hintAll }: { stream: ClassStream; wall: Wall; hintAll: () => void }) {
  const lessons = (wall.lessons ?? []).map(([lesson, title]) => {
    const text = typeof title === "string" ? title : (title[language.value] ?? title.en ?? lesson);
    return { text, run: () => stream.send({ kind: "HandOut", lesson, project: text }) };
  });
  return (
    <div class="class-tools">
      <button
        type="button"
        class="button bordered"
        aria-pressed={wall.eyes_up}
        onClick={() => stream.rest(!wall.eyes_up)}
      >
        <Icon name="eye" />
        {t("page-class-eyes-up-button")}
      </button>
      <button type="button" class="button bordered" onClick={() => stream.send({ kind: "StopAll" })}>
        <Icon name="stop" />
        {t("page-class-stop-all")}
      </button>
      <Menu label={t("page-class-hand-out")} icon="lesson" groups={[{ items: lessons }]} side="right">
        <span>{t("page-class-hand-out")}</span>
      </Menu>
      <button type="button" class="button bordered" onClick={hintAll}>
        <Icon name="hint" />
        {t("page-class-hint-all")}
      </button>
      <a class="button bordered" href="hand-ins">
        <Icon name="saved" />
        {t("page-handins-title")}
      </a>
      <a class="button bordered" href="projector" target="_blank" rel="noopener opener">
        {t("page-class-projector")}
      </a>
      <a class="button bordered" href="export.zip">
        <Icon name="download" />
        {t("page-class-export-all")}
      </a>
    </div>
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

interface Joining {
  readonly stream: ClassStream;
  readonly wall: Wall;
  readonly remove: () => void;
}

/** Open until the first pupil has joined. */
function HowToJoin({ stream, wall, count, remove }: Joining & { count: number }) {
  return (
    <details class="class-joining" open={count === 0}>
      <summary>
        {t("page-class-here", { count })} · {t("page-class-word-is", { word: wall.word })}
      </summary>
      <JoinSign address={wall.address} word={wall.word} />
      <JoinRights stream={stream} wall={wall} remove={remove} />
    </details>
  );
}

/** Where to go, and the word. */
export function JoinSign({ address, word }: { address: string; word: string }) {
  return (
    <div class="join-sign">
      <QrCode address={address} />
      <div>
        <p>{t("page-class-go-to")}</p>
        <p class="join-address">{address}</p>
        <p>{t("page-class-type-word")}</p>
        <p class="join-word">{word}</p>
      </div>
    </div>
  );
}

/** Whether new pupils can join, another word, and who is to leave. */
function JoinRights({ stream, wall, remove }: Joining) {
  return (
    <div class="class-tools">
      <label>
        <input
          type="checkbox"
          checked={wall.open}
          onChange={({ currentTarget }) => stream.send({ kind: "LetJoin", on: currentTarget.checked })}
        />
        {t("page-class-open-door")}
      </label>
      <button type="button" class="button bordered" onClick={() => stream.send({ kind: "RenewWord" })}>
        {t("page-class-renew-word")}
      </button>
      <button type="button" class="button bordered" disabled={!wall.pupils?.length} onClick={remove}>
        {t("page-class-remove-several")}
      </button>
    </div>
  );
}

function HintDialog({ stream, to, close }: { stream: ClassStream; to: Seat | "all"; close: () => void }) {
  const text = useSignal("");
  const title = to === "all" ? t("page-class-hint-all") : t("page-class-hint-to", { name: to.name ?? "" });
  const send = (event: Event) => {
    event.preventDefault();
    stream.send({ kind: "SendHint", text: text.peek().trim(), pupil: to === "all" ? null : to.id });
    close();
  };
  return (
    <Dialog title={title} close={close}>
      <form class="class-hint" onSubmit={send}>
        <label class="field">
          {t("page-class-hint-text")}
          <textarea
            autofocus
            rows={3}
            maxLength={300}
            required
            value={text.value}
            onInput={({ currentTarget }) => (text.value = currentTarget.value)}
          />
        </label>
        <button type="submit" class="button filled" disabled={!text.value.trim()}>
          {t("page-class-hint-send")}
        </button>
      </form>
    </Dialog>
  );
}

interface Removed {
  /** In the order in which they joined. */
  readonly seats: readonly (Seat | undefined)[];
  readonly remove: (chosen: readonly Seat[]) => void;
  readonly close: () => void;
}

/** Choose several pupils to delete: the last ones to join come first. */
function RemovedDialog({ seats, remove, close }: Removed) {
  const chosen = useSignal<ReadonlySet<string>>(new Set());
  const known = seats.filter((seat) => seat !== undefined).reverse();
  const tick = (id: string, on: boolean) => {
    const ids = new Set(chosen.peek());
    if (on) ids.add(id);
    else ids.delete(id);
    chosen.value = ids;
  };
  const next = () => {
    remove(known.filter(({ id }) => chosen.peek().has(id)));
    close();
  };
  return (
    <Dialog title={t("page-class-remove-several")} close={close}>
      <p>{t("page-class-remove-which")}</p>
      <ul class="class-removed">
        {known.map(({ id, name }) => (
          <li key={id}>
            <label>
              <input
                type="checkbox"
                checked={chosen.value.has(id)}
                onChange={({ currentTarget }) => tick(id, currentTarget.checked)}
              />
              <bdi>{name}</bdi>
            </label>
          </li>
        ))}
      </ul>
      <div class="dialog-buttons">
        <button type="button" class="button bordered" onClick={close}>
          {t("page-class-remove-not")}
        </button>
        <button type="button" class="button filled" disabled={!chosen.value.size} onClick={next}>
          {t("page-class-remove")}
        </button>
      </div>
    </Dialog>
  );
}

function RemoveDialog({ stream, seats, close }: { stream: ClassStream; seats: readonly Seat[]; close: () => void }) {
  const name = seats.map((seat) => seat.name ?? "").join(", ");
  const remove = () => {
    stream.send({ kind: "RemovePupils", pupils: seats.map(({ id }) => id) });
    close();
  };
  return (
    <Dialog title={t("page-class-remove-title", { name })} close={close}>
      <p>{t("page-class-remove-text", { name })}</p>
      <div class="dialog-buttons">
        <button type="button" class="button bordered" onClick={close}>
          {t("page-class-remove-not")}
        </button>
        <button type="button" class="button filled" onClick={remove}>
          {t("page-class-remove")}
        </button>
      </div>
    </Dialog>
  );
}

/** A pupil's new pictures, until the teacher has told them. */
function PinDialog({ stream }: { stream: ClassStream }) {
  const pin = stream.pin.value;
  if (!pin) return null;
  return (
    <Dialog title={t("page-class-pin-of", { name: pin.name })} close={() => (stream.pin.value = null)}>
      <p>{t("page-class-pin-text")}</p>
      <PictureRow pictures={pin.pictures} />
    </Dialog>
  );
}
