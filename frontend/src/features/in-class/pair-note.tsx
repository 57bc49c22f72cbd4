/** What a pupil's page says about playing with a classmate: an invitation, and who plays where. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { InPair } from "../../protocol/classroom";

export function PairNote() {
  const { pairs } = usePage();
  const now = pairs.now.value;
  if (!now || (now.state ?? "alone") === "alone") return null;
  return (
    <section class="toast note pair">
      <p>{sentence(now)}</p>
      {now.state === "invited" ? <Answers /> : <Leave state={now.state} other={now.other ?? ""} />}
    </section>
  );
}

function sentence({ state = "alone", other = "", robot = "", away = false }: InPair): string {
  if (state === "host" && away) return t("page-pair-host-away", { name: other });
  return t(`page-pair-${state}`, { name: other, robot });
}

function Answers() {
  const { pairs } = usePage();
  return (
    <>
      <button type="button" class="button filled" onClick={() => pairs.answer(true)}>
        {t("page-pair-accept")}
      </button>
      <button type="button" class="button bordered" onClick={() => pairs.answer(false)}>
        {t("page-pair-decline")}
      </button>
    </>
  );
}

function Leave({ state, other }: { state: InPair["state"]; other: string }) {
  const { pairs } = usePage();
  const isAway = pairs.isAway.value;
  return (
    <>
      {state === "guest" && (
        <button type="button" class="button filled" onClick={() => (pairs.isAway.value = !isAway)}>
          {isAway ? t("page-pair-own-world") : t("page-pair-their-world", { name: other })}
        </button>
      )}
      <button type="button" class="button bordered" onClick={() => pairs.leave()}>
        {t(state === "inviting" ? "page-pair-take-back" : "page-pair-leave")}
      </button>
    </>
  );
}
