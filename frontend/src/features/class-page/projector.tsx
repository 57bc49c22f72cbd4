/** What the class sees on the projector: how to join, or one pupil's world without the name. */

import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { Frame } from "./frame";
import { JoinSign } from "./join-sign";
import { FlatWorld } from "./plan";
import type { ClassStream } from "./stream";

export function ProjectorPage({ stream }: { stream: ClassStream }) {
  useEffect(() => stream.open(), []);
  const shown = stream.projected.value;
  if (!shown) return <Frame>{stream.state.value === "refused" && <p>{t("page-class-no-key")}</p>}</Frame>;
  const { seat, plan, names = [] } = shown;
  return (
    <Frame title={t("page-class-title", { title: shown.title })}>
      <div class="projector">
        {seat ? (
          <FlatWorld plan={plan ?? undefined} seat={seat} label={t("page-class-world-shown")} />
        ) : (
          <JoinSign address={shown.address} word={shown.word} />
        )}
        <p class="projector-names">{names.join(" · ")}</p>
      </div>
    </Frame>
  );
}
