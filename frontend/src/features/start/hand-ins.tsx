/** In a class: what the pupil has handed in, and what the teacher has handed back. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { OwnHandIn } from "../../protocol/classroom";
import { Icon } from "../../ui/icons";
import { inLanguage } from "../lessons/lessons";

/** The number of hand-ins that fit beside the first thing to do; all are in the record. */
const MOST = 3;

export function OwnHandIns() {
  const { handIns } = usePage();
  const all = [...(handIns.all.value ?? [])].sort((one, other) => newest(other) - newest(one));
  return (
    <section class="start-card" aria-labelledby="start-hand-ins" data-region="hand-ins">
      <div class="start-head">
        <h2 id="start-hand-ins">{t("page-start-hand-ins")}</h2>
        <a class="more-link start-all" href="record">
          {t("page-record-own")}
          <Icon name="next" />
        </a>
      </div>
      {all.length === 0 && <p class="dim start-none">{t("page-start-no-hand-ins")}</p>}
      <ul class="start-hand-ins">
        {all.slice(0, MOST).map((handIn) => (
          <HandIn key={`${handIn.lesson} ${handIn.step}`} handIn={handIn} />
        ))}
      </ul>
    </section>
  );
}

/** When something happened last: what is back comes before what waits. */
function newest({ at, waits, back }: OwnHandIn): number {
  return waits ? at - 1e9 : (back?.at ?? at);
}

function HandIn({ handIn }: { handIn: OwnHandIn }) {
  const { lessons } = usePage();
  const { step, waits, improving, back } = handIn;
  const lesson = lessons.choices.value?.find(({ name }) => name === handIn.lesson);
  const state = waits ? "page-handins-own-waits" : improving ? "page-start-improving" : "page-handins-own-back";
  return (
    <li>
      <button type="button" disabled={!lesson} onClick={() => lesson && lessons.start(lesson, false, step)}>
        <Icon name={waits ? "handedIn" : "lesson"} />
        <span>
          <strong>{t("page-start-step", { lesson: lesson ? inLanguage(lesson.title) : handIn.lesson, step })}</strong>
          <small>{t(state)}</small>
          {!waits && back?.note && <q>{back.note}</q>}
        </span>
        {!waits && back?.mark && <b title={t("page-handins-own-mark", { mark: back.mark })}>{back.mark}</b>}
      </button>
    </li>
  );
}
