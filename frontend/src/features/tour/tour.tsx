/** A tour of the page in five steps, each of which highlights a region and explains it. */

import { useSignal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { prefer } from "../../model/preferences";
import type { Area } from "../../model/views";
import { hold } from "../../ui/dialog";
import { focusRun } from "../../views/regions";
import "./tour.css";

interface Step {
  readonly name: "blocks" | "texts" | "run" | "world" | "robot";
  /** The value of `data-tour`; of several elements, the first visible one. */
  readonly target: string;
  /** The region to show for it. */
  readonly area?: Area;
}

const STEPS: readonly Step[] = [
  { name: "blocks", target: "blocks", area: "blocks" },
  { name: "texts", target: "blocktext", area: "blocktext" },
  { name: "run", target: "run" },
  { name: "world", target: "world", area: "world" },
  { name: "robot", target: "robot" },
];
/** The margin of the highlight, px. */
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
    // The element that had the focus, in the offer or a menu, is gone.
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
            {t("page-tour-skip")}
          </button>
          {at.value > 0 && (
            <button type="button" class="button bordered" onClick={() => go(at.value - 1)}>
              {t("page-tour-back")}
            </button>
          )}
          <button type="button" class="button filled" autofocus onClick={() => go(at.value + 1)}>
            {at.value + 1 < STEPS.length ? t("page-tour-next") : t("page-tour-done")}
          </button>
        </div>
      </div>
    </dialog>
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

/** Keep the highlight around a region and the card outside it. */
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
