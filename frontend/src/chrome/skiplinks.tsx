import { t } from "../i18n";
import { usePage } from "./page";
import { enterRegion, focusRun } from "./regions";

const TARGETS = ["run", "blocks", "blocktext", "python", "world", "panel"] as const;

/** The first thing on the page by keyboard: straight to where one wants to be. */
export function SkipLinks() {
  return (
    <nav class="skip-links" aria-label={t("chrome.skip")}>
      {TARGETS.map((target) => (
        <SkipLink key={target} target={target} />
      ))}
    </nav>
  );
}

function SkipLink({ target }: { target: (typeof TARGETS)[number] }) {
  const { views } = usePage();
  const go = (event: Event) => {
    event.preventDefault();
    if (target === "run") return focusRun();
    views.show(target);
    // What was hidden can have the focus only with the next frame.
    requestAnimationFrame(() => {
      const region = document.querySelector<HTMLElement>(`[data-region="${target}"]`);
      if (region) enterRegion(views, region);
    });
  };
  return (
    <a href={`#${target}`} onClick={go}>
      {t(`chrome.skip_${target}`)}
    </a>
  );
}
