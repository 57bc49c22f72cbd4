/** How pupils come in: where to go and the word, and who may. */

import { t } from "../../i18n";
import type { Wall } from "../../protocol/classroom";
import { QrCode } from "./qr-code";
import type { ClassStream } from "./stream";

/** Where to go, and the word. */
export function JoinSign({ address, word }: { address: string; word: string }) {
  return (
    <div class="join-sign">
      <QrCode address={address} word={word} />
      <div>
        <p>{t("page-class-go-to")}</p>
        <p class="join-address">{address}</p>
        <p>{t(word ? "page-class-type-word" : "page-class-log-in")}</p>
        <p class="join-word">{word}</p>
      </div>
    </div>
  );
}

interface Props {
  readonly stream: ClassStream;
  readonly wall: Wall;
  readonly remove: () => void;
}

/** Whether new pupils can join, another word, and who is to leave. */
export function JoinRights({ stream, wall, remove }: Props) {
  return (
    <div class="class-tools">
      {wall.word && (
        <>
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
        </>
      )}
      <button type="button" class="button bordered" disabled={!wall.pupils?.length} onClick={remove}>
        {t("page-class-remove-several")}
      </button>
    </div>
  );
}
