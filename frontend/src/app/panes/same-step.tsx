/** The step that is selected, or running, in the notations that are not shown. */

import { useComputed } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { VIEWS } from "../../model/views";
import type { View } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { room } from "../../ui/screen";
import "./same-step.css";

export function SameStep() {
  const { context, views } = usePage();
  const step = useComputed(() => context.running.block.value ?? views.selected.value);
  const hidden = VIEWS.filter((view) => !views.shows(view));
  if (room.value === "narrow" || hidden.length === 0) return null;
  return (
    <section class="same-step" aria-label={t("page-shell-same-step")}>
      <h2>
        <Icon name="link" />
        {t("page-shell-same-step")}
      </h2>
      {step.value ? (
        <ul>
          {hidden.map((view) => (
            <Line key={view} view={view} step={step.value ?? ""} />
          ))}
        </ul>
      ) : (
        <p class="dim">{t("page-shell-no-step")}</p>
      )}
    </section>
  );
}

/** The step in one notation; it leads to that view. */
function Line({ view, step }: { view: View; step: string }) {
  const { context, views } = usePage();
  // Its words change with the program.
  const { places } = context.program.state.value;
  const name = t(`page-shell-${view}`);
  return (
    <li>
      <button type="button" onClick={() => views.show(view)} title={t("page-shell-show-view", { view: name })}>
        <span class="view-name">{name}</span>
        <code>{places && views.describeStep(view, step)}</code>
      </button>
    </li>
  );
}
