/** A tour of the page in five steps: each lights up a part and says what it is for. */

import { useSignal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../i18n";
import { prefer } from "../preferences";
import { usePage } from "./page";
import { focusRun } from "./regions";
import type { Area } from "./views";
import { hold } from "./widgets/dialog";
import "./tour.css";

interface Step {
  readonly name: "blocks" | "texts" | "run" | "world" | "robot";
  /** Marked by `data-tour`; where several parts are, the first that is seen. */
  readonly target: string;
  /** What has to be shown for it. */
  readonly area?: Area;
}

const STEPS: readonly Step[] = [
  { name: "blocks", target: "blocks", area: "blocks" },
  { name: "texts", target: "blocktext", area: "blocktext" },
  { name: "run", target: "run" },
  { name: "world", target: "world", area: "world" },
  { name: "robot", target: "robot" },
];
/** Round what is lit up, px. */
const MARGIN = 4;

export function Tour() {
  return usePage().dialogs.tour.value ? <Steps /> : null;
}

function Steps() {
  const { dialogs, views } = usePage();
  const at = useSignal(0);
  const dialog = useRef<HTMLDialogElement>(null);
  const light = useRef<HTMLDivElement>(null);
  const step = STEPS[at.value];
  const end = () => {
    dialogs.tour.value = false;
    prefer({ tourDone: true });
    // Where the focus was, in the offer or in a menu, is gone.
    requestAnimationFrame(focusRun);
  };
  useLayoutEffect(() => (dialog.current ? hold(dialog.current, end) : undefined), []);
  useEffect(() => {
    if (step?.area) views.show(step.area);
    return follow(step?.target ?? "", light.current, dialog.current);
  }, [step]);
  if (!step) return null;
  const go = (to: number) => {
    if (to < STEPS.length) at.value = to;
    else end();
  };
  return (
    <dialog ref={dialog} class="tour" aria-labelledby="tour-title">
      <div class="tour-light" ref={light} />
      <div class="tour-card">
        <Card step={step} number={at.value + 1} />
        <div class="actions">
          <button type="button" class="button" onClick={end}>
            {t("tour.skip")}
          </button>
          {at.value > 0 && (
            <button type="button" class="button bordered" onClick={() => go(at.value - 1)}>
              {t("tour.back")}
            </button>
          )}
          <button type="button" class="button filled" autofocus onClick={() => go(at.value + 1)}>
            {at.value + 1 < STEPS.length ? t("tour.next") : t("tour.done")}
          </button>
        </div>
      </div>
    </dialog>
  );
}

function Card({ step, number }: { step: Step; number: number }) {
  return (
    <div aria-live="polite">
      <p class="dim">{t("tour.step", { number, all: STEPS.length })}</p>
      <h2 id="tour-title">{t(`tour.${step.name}Title`)}</h2>
      <p>{t(`tour.${step.name}`)}</p>
    </div>
  );
}

/** Keep the light round a part of the page, and the card out of it. */
function follow(target: string, light: HTMLElement | null, dialog: HTMLElement | null): () => void {
  const place = () => {
    const parts = [...document.querySelectorAll(`[data-tour="${target}"]`)];
    const part = parts.map((one) => one.getBoundingClientRect()).find((one) => one.width > 0);
    if (!light || !dialog || !part) return;
    light.style.left = `${part.left - MARGIN}px`;
    light.style.top = `${part.top - MARGIN}px`;
    light.style.width = `${part.width + 2 * MARGIN}px`;
    light.style.height = `${part.height + 2 * MARGIN}px`;
    dialog.dataset.side = part.left + part.width / 2 > innerWidth / 2 ? "left" : "right";
  };
  const frame = requestAnimationFrame(place);
  addEventListener("resize", place);
  return () => {
    cancelAnimationFrame(frame);
    removeEventListener("resize", place);
  };
}
