/** The lesson of the open project: the step's instructions, its goals, hints and questions. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { LessonShown } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { room } from "../../ui/screen";
import { HandedIn } from "./hand-in";
import { NarrowPane } from "./narrow";
import { Body, Foot, Party, Place, RestartButton, Stars, stepTitle, Task } from "./parts";
import "./lessons.css";

export function LessonPane() {
  const shown = usePage().lessons.shown.value;
  if (!shown) return null;
  return room.value === "narrow" ? <NarrowPane shown={shown} /> : <Pane shown={shown} />;
}

/** Beside the program, above the world; or, on a tablet, between them. */
function Pane({ shown }: { shown: LessonShown }) {
  const folded = useSignal(false);
  return (
    <section
      id="lesson"
      class={folded.value ? "region lesson-pane folded" : "region lesson-pane"}
      aria-labelledby="title-lesson"
      data-region="lesson"
      tabIndex={-1}
    >
      <div class="lesson-head">
        <Place shown={shown} />
        <Stars />
        <RestartButton shown={shown} />
        <button
          type="button"
          class="button"
          aria-expanded={!folded.value}
          aria-controls="lesson-body"
          aria-label={t("page-lesson-fold")}
          title={t("page-lesson-fold")}
          onClick={() => (folded.value = !folded.value)}
        >
          <Icon name={folded.value ? "down" : "up"} />
        </button>
      </div>
      <h2 id="title-lesson" class="lesson-title">
        {stepTitle(shown)}
      </h2>
      {!folded.value && (
        <div class="lesson-content">
          <Body shown={shown} />
          <Task shown={shown} />
          <HandedIn shown={shown} />
          <Foot shown={shown} />
        </div>
      )}
      <Party />
    </section>
  );
}
