import { t } from "../i18n";
import { usePage } from "../model/page";
import { enterRegion, focusRun } from "../views/regions";

const TARGETS = ["run", "blocks", "blocktext", "python", "world", "panel"] as const;

/** Links for keyboard users that skip to a region; they come first on the page. */
export function SkipLinks() {
  return (
    <nav class="skip-links" aria-label={t("page-shell-skip")}>
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
    // An element that was hidden cannot take the focus before the next frame.
    requestAnimationFrame(() => {
      const region = document.querySelector<HTMLElement>(`[data-region="${target}"]`);
      if (region) enterRegion(views, region);
    });
  };
  return (
    <a href={`#${target}`} onClick={go}>
      {t(`page-shell-skip-${target}`)}
    </a>
  );
}
