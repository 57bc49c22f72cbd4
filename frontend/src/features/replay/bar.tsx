/** What is over the world while the end of a run is shown again. */

import { useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Icon } from "../../ui/icons";
import "./replay.css";

export function ReplayBar() {
  return usePage().replay.isShown.value ? <Bar /> : null;
}

function Bar() {
  const { replay, share } = usePage();
  const stop = useRef<HTMLButtonElement>(null);
  // The button that began it is no longer there.
  useLayoutEffect(() => stop.current?.focus(), []);
  const seconds = Math.ceil(replay.seconds.value);
  return (
    <section class="replay" aria-label={t("page-world-replay-label")} data-region="replay">
      <p>{t("page-world-replay-title", { seconds })}</p>
      <button
        type="button"
        class="button bordered"
        disabled={share.isFilming.value}
        onClick={() => {
          replay.save();
          stop.current?.focus();
        }}
      >
        <Icon name="video" />
        {t(share.isFilming.value ? "page-share-filming" : "page-world-replay-film")}
      </button>
      <button type="button" class="button filled" ref={stop} onClick={() => replay.stop()}>
        {t("page-world-replay-stop")}
      </button>
    </section>
  );
}
