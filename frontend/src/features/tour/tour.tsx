/** A tour in which the user builds and runs something: a card says what to do, a ring shows where. */

import { computed, effect, untracked, useSignal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { prefer } from "../../model/preferences";
import { focusRun } from "../../views/regions";
import { momentOf, STEPS, type Step } from "./steps";
import "./tour.css";

/** The distance between the ring and what it surrounds, px. */
const MARGIN = 4;

export function Tour() {
  return usePage().dialogs.tour.value ? <Steps /> : null;
}

function Steps() {
  const page = usePage();
  const { announcer, dialogs, views } = page;
  const at = useSignal(0);
  const card = useRef<HTMLElement>(null);
  const ring = useRef<HTMLDivElement>(null);
  const step = STEPS[at.value];
  const end = () => {
    dialogs.tour.value = false;
    prefer({ tourDone: true });
    // The element that had the focus, in the offer or a menu, is gone.
    requestAnimationFrame(focusRun);
  };
  const go = (to: number) => {
    if (to < STEPS.length) at.value = to;
    else end();
  };
  const goOn = () => {
    announcer.say(t("page-tour-well-done"));
    go(at.peek() + 1);
  };
  useLayoutEffect(() => {
    views.show("blocks");
    card.current?.focus();
  }, []);
  useEffect(() => (step ? follow(step.target, ring.current, card.current) : undefined), [step]);
  useEffect(() => {
    if (!step) return;
    const before = untracked(() => momentOf(page));
    const isDone = computed(() => step.isDone(momentOf(page), before));
    // Not in the effect: what is announced and shown next is not its concern.
    return effect(() => void (isDone.value && queueMicrotask(goOn)));
  }, [step]);
  if (!step) return null;
  return (
    <>
      <div class="tour-ring" ref={ring} />
      <section
        ref={card}
        class="tour-card"
        aria-labelledby="tour-title"
        data-region="tour"
        tabIndex={-1}
        onKeyDown={({ key }) => key === "Escape" && end()}
      >
        <Card step={step} number={at.value + 1} />
        <div class="actions">
          <button type="button" class="button" onClick={end}>
            {t("page-tour-skip")}
          </button>
          {at.value > 0 && (
            <button type="button" class="button bordered" onClick={() => go(at.value - 1)}>
              {t("page-tour-back")}
            </button>
          )}
          {!step.mustBeDone && (
            <button type="button" class="button filled" onClick={() => go(at.value + 1)}>
              {at.value + 1 < STEPS.length ? t("page-tour-next") : t("page-tour-done")}
            </button>
          )}
        </div>
      </section>
    </>
  );
}

function Card({ step, number }: { step: Step; number: number }) {
  return (
    <div aria-live="polite">
      <p class="dim">{t("page-tour-step", { number, all: STEPS.length })}</p>
      <h2 id="tour-title">{t(`page-tour-${step.name}-title`)}</h2>
      <p>{t(`page-tour-${step.name}`)}</p>
    </div>
  );
}

/** Keep the ring around a part of the page, and the card beside it. */
function follow(target: string, ring: HTMLElement | null, card: HTMLElement | null): () => void {
  const place = () => {
    const parts = [...document.querySelectorAll(`[data-tour="${target}"]`)];
    const part = parts.map((one) => one.getBoundingClientRect()).find((one) => one.width > 0);
    if (!ring || !card || !part) return;
    ring.style.left = `${part.left - MARGIN}px`;
    ring.style.top = `${part.top - MARGIN}px`;
    ring.style.width = `${part.width + 2 * MARGIN}px`;
    ring.style.height = `${part.height + 2 * MARGIN}px`;
    card.dataset.side = part.left + part.width / 2 > innerWidth / 2 ? "left" : "right";
  };
  const frame = requestAnimationFrame(place);
  addEventListener("resize", place);
  return () => {
    cancelAnimationFrame(frame);
    removeEventListener("resize", place);
  };
}
