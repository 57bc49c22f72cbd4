/** Asks why, on the world: about the moment that is shown, or about the goal that the run has missed. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { TimeMark } from "../../protocol/messages";
import { Icon } from "../../ui/icons";

/** So close to a mark, in s, the question is about what it marks. */
const NEAR = 0.005;

export function WhyChip() {
  const { context, askingWhy } = usePage();
  const { past, ended, telemetry, timeline } = context.running;
  if (!askingWhy.isPossible) return null;
  // A game that the program has won is won, whatever else its world asks for.
  const asksForMore = !past.value && !telemetry.value?.game?.won;
  const missed = asksForMore ? ended.value?.goals?.find(({ state }) => state !== "reached") : undefined;
  if (missed) {
    return <Chip look="missed" words={t("page-why-goal-missed")} ask={() => askingWhy.aboutGoal(missed)} />;
  }
  const mark = past.value && markAt(timeline.value?.marks ?? [], past.value.time);
  const ask = () => (mark ? askingWhy.aboutMark(mark) : askingWhy.aboutRobot());
  return <Chip look="" words={t("page-why-goal")} title={t("page-why-robot")} ask={ask} />;
}

function Chip({ look, words, title, ask }: { look: string; words: string; title?: string; ask: () => void }) {
  return (
    <button
      type="button"
      class={`chip asks ${look}`}
      title={title}
      aria-label={title && `${words} ${title}`}
      onClick={ask}
    >
      <Icon name="why" />
      {words}
    </button>
  );
}

/** What happened at a time; of several things, the last one. */
function markAt(marks: readonly TimeMark[], time: number): TimeMark | undefined {
  return marks.findLast((mark) => mark.sort !== "placed" && Math.abs(mark.time - time) < NEAR);
}
