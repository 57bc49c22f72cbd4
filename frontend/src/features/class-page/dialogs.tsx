/** What the wall asks and says in dialogs: hints, who is to leave, new pictures. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import type { Seat } from "../../protocol/classroom";
import { Dialog } from "../../ui/dialog";
import { PictureRow } from "./pictures";
import { PupilTick } from "./pupil-tick";
import type { ClassStream } from "./stream";

interface Hinting {
  readonly stream: ClassStream;
  /** The pupil's id; empty for all. */
  readonly to: string;
  readonly name: string;
  /** What the pupil asks; empty if nothing. */
  readonly question: string;
  readonly close: () => void;
}

/** What is typed is kept until it is on its way, also if the dialog is closed or the connection is lost. */
export function HintDialog({ stream, to, name, question, close }: Hinting) {
  const text = useSignal(stream.drafts.get(to) ?? "");
  const isLost = useSignal(false);
  const type = (words: string) => {
    text.value = words;
    stream.drafts.set(to, words);
  };
  const send = (event: Event) => {
    event.preventDefault();
    if (!text.peek().trim()) return;
    if (stream.hint(to, text.peek())) close();
    else isLost.value = true;
  };
  return (
    <Dialog title={to ? t("page-class-hint-to", { name }) : t("page-class-hint-all")} close={close}>
      <form class="class-hint" onSubmit={send}>
        {question && <p class="class-question">{t("page-class-said", { question })}</p>}
        <label>
          <span>{t(to ? "page-class-hint-text" : "page-class-hint-text-all")}</span>
          <textarea
            autofocus
            rows={3}
            maxLength={300}
            required
            value={text.value}
            onInput={({ currentTarget }) => type(currentTarget.value)}
            onKeyDown={(event) => event.key === "Enter" && (event.ctrlKey || event.metaKey) && send(event)}
          />
        </label>
        <p role="alert" class={isLost.value ? "class-problem" : "hidden"}>
          {isLost.value && t("page-class-hint-kept")}
        </p>
        <button type="submit" class="button filled" disabled={!text.value.trim()}>
          {t("page-class-hint-send")}
        </button>
      </form>
    </Dialog>
  );
}

interface Removed {
  /** In the order in which they joined. */
  readonly seats: readonly Seat[];
  readonly remove: (chosen: readonly Seat[]) => void;
  readonly close: () => void;
}

/** Choose several pupils to delete: the last ones to join come first. */
export function RemovedDialog({ seats, remove, close }: Removed) {
  const chosen = useSignal<ReadonlySet<string>>(new Set());
  const known = [...seats].reverse();
  const next = () => {
    remove(known.filter(({ id }) => chosen.peek().has(id)));
    close();
  };
  return (
    <Dialog title={t("page-class-remove-several")} close={close}>
      <p>{t("page-class-remove-which")}</p>
      <ul class="class-removed">
        {known.map((seat) => (
          <li key={seat.id}>
            <PupilTick seat={seat} chosen={chosen.value} choose={(ids) => (chosen.value = ids)} />
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

export function RemoveDialog({
  stream,
  seats,
  close,
}: {
  stream: ClassStream;
  seats: readonly Seat[];
  close: () => void;
}) {
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
export function PinDialog({ stream }: { stream: ClassStream }) {
  const pin = stream.pin.value;
  if (!pin) return null;
  return (
    <Dialog title={t("page-class-pin-of", { name: pin.name })} close={() => (stream.pin.value = null)}>
      <p>{t("page-class-pin-text")}</p>
      <PictureRow pictures={pin.pictures} />
    </Dialog>
  );
}
