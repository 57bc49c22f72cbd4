/** A real robot and its twin, while the user looks back: whose way is whose, and what the difference means. */

import { say, t } from "../../i18n";
import { GHOST_COLOURS } from "../../model/ghost";
import { usePage } from "../../model/page";
import type { TwinFinding } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import "../runs/runs.css";
import "./ghost.css";

export function GhostLegend() {
  const { ghost } = usePage();
  if (!ghost.shown.value) return null;
  return (
    <ul class="status run-legend" aria-label={t("page-ghost-legend")}>
      <li class="chip">
        <span class="run-colour" style={{ "--run": GHOST_COLOURS[0] }} />
        {t("page-ghost-twin")}
      </li>
      <li class="chip">
        <span class="run-colour second" style={{ "--run": GHOST_COLOURS[1] }} />
        {t("page-ghost-robot")}
      </li>
    </ul>
  );
}

export function GhostFindings() {
  const { ghost } = usePage();
  const shown = ghost.shown.value;
  if (!shown) return null;
  const { findings: [first, ...others] = [], unrecorded = [] } = shown;
  return (
    <div class="ghost-findings" role="status">
      <Icon name="robot" />
      <div>
        {first && (
          <p>
            <Finding finding={first} />
          </p>
        )}
        {others.length + unrecorded.length > 0 && (
          <details>
            <summary>{t("page-ghost-more")}</summary>
            <ul>
              {others.map((finding) => (
                <li key={JSON.stringify(finding)}>
                  <Finding finding={finding} />
                </li>
              ))}
              {unrecorded.map((phrase) => (
                <li key={phrase.code} class="dim">
                  {say(phrase)}
                </li>
              ))}
            </ul>
          </details>
        )}
      </div>
    </div>
  );
}

function Finding({ finding: { phrase, time = null } }: { finding: TwinFinding }) {
  const { lookingBack } = usePage();
  if (time === null) return <>{say(phrase)}</>;
  return (
    <button type="button" class="text-link moment-link" onClick={() => lookingBack.look(time)}>
      {say(phrase)}
    </button>
  );
}
