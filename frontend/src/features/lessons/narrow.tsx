/** The lesson on a phone: beside the world, so that the program has room for ten blocks; the rest is in a sheet. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { usePage } from "../../model/page";
import type { LessonShown } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { room } from "../../ui/screen";
import { BackLine, HandedIn } from "./hand-in";
import { Body, Foot, Forward, Party, Place, RestartButton, Segments, Stars, StepText, stepTitle, Task } from "./parts";
import { CheckAnswer, QuizResult } from "./quiz";
import "./narrow.css";

export function NarrowPane({ shown }: { shown: LessonShown }) {
  const open = useSignal(false);
  const { context, askingWhy } = usePage();
  // The world has to be seen while the program runs, and then the answer to a question about it.
  const isActive = context.running.active.value;
  const answer = askingWhy.answer.value;
  useEffect(() => {
    if (isActive || answer) open.value = false;
  }, [isActive, answer]);
  const show = () => (open.value = true);
  return (
    <section id="lesson" class="region lesson-line" aria-labelledby="title-lesson" data-region="lesson">
      <button type="button" class="lesson-open" aria-haspopup="dialog" onClick={show}>
        <Segments shown={shown} />
        <Stars />
        <Icon name="up" />
        {/* The question says what to do; with its answers, the title has no room. */}
        <h2 id="title-lesson" class={shown.quiz ? "hidden" : ""}>
          {stepTitle(shown)}
        </h2>
      </button>
      {!open.value && <Glance shown={shown} open={show} />}
      {open.value && <Sheet shown={shown} close={() => (open.value = false)} />}
      <Party />
    </section>
  );
}

/** The task, and of the text what has room above it. */
function Glance({ shown, open }: { shown: LessonShown; open: () => void }) {
  return (
    <>
      {!shown.quiz && (
        <div class="lesson-glance">
          <StepText shown={shown} />
        </div>
      )}
      <BackLine shown={shown} open={open} />
      <Task shown={shown} />
      {shown.quiz && <QuizResult quiz={shown.quiz} />}
    </>
  );
}

function Sheet({ shown, close }: { shown: LessonShown; close: () => void }) {
  return (
    <Dialog title={stepTitle(shown)} close={close} size="large">
      <div class="lesson-sheet">
        <div class="lesson-head">
          <Place shown={shown} />
          <Stars />
          <RestartButton shown={shown} />
        </div>
        <Body shown={shown} />
        <Task shown={shown} />
        <HandedIn shown={shown} />
        <Foot shown={shown} />
      </div>
    </Dialog>
  );
}

/** What a phone's lesson has beside Run: to check the answer, or to go on; null while there is neither. */
export function useLessonMove() {
  const { lessons, context } = usePage();
  const shown = lessons.shown.value;
  if (!shown || room.value !== "narrow" || context.running.active.value) return null;
  if (lessons.hasStar) return <Forward shown={shown} />;
  return shown.quiz ? <CheckAnswer quiz={shown.quiz} /> : null;
}
