/** What the class sees on the projector: how to join, or one pupil's world without the name. */

import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import type { Projected } from "../../protocol/classroom";
import { RobotPicture } from "../../ui/robots/picture";
import { Frame } from "./frame";
import { FlatWorld } from "./plan";
import { QrCode } from "./qr-code";
import type { ClassStream } from "./stream";

export function ProjectorPage({ stream }: { stream: ClassStream }) {
  useEffect(() => stream.open(), []);
  const shown = stream.projected.value;
  if (!shown) return <Frame>{stream.state.value === "refused" && <p>{t("page-class-no-key")}</p>}</Frame>;
  const { seat, plan } = shown;
  return (
    <Frame title={t("page-class-title", { title: shown.title })}>
      {seat ? (
        <div class="projector">
          <FlatWorld plan={plan ?? undefined} seat={seat} label={t("page-class-world-shown")} />
        </div>
      ) : (
        <HowToJoin shown={shown} />
      )}
    </Frame>
  );
}

/** Three steps that can be read from the last row, and how many have done them; no name of a child. */
function HowToJoin({ shown: { address, word, here = 0, joined = 0 } }: { shown: Projected }) {
  return (
    <div class="projector-join">
      <ol>
        <li>
          <p>{t("page-class-open-or-scan")}</p>
          <p class="join-address">{address}</p>
        </li>
        {word && (
          <li>
            <p>{t("page-class-join-word")}</p>
            <p class="join-word">{word}</p>
          </li>
        )}
        <li>
          <p>{t(word ? "page-class-name-and-pictures" : "page-class-log-in")}</p>
        </li>
      </ol>
      <div class="projector-code">
        <QrCode address={address} word={word} />
        <RobotPicture robot="ebo" />
      </div>
      <p class="projector-here" role="status">
        <span aria-hidden="true">
          {Array.from({ length: joined }, (_, i) => (
            <i key={i} class={i < here ? "dot full" : "dot"} />
          ))}
        </span>
        {t("page-class-here", { count: here })}
      </p>
    </div>
  );
}
