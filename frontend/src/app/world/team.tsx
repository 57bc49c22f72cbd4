/** A team's name, after a dot in its colour. */

import { t, worldName } from "../../i18n";
import { usePage } from "../../model/page";
import { colourOfTeam } from "../../views/world/scenery/teams";
import "./team.css";

export function TeamDot({ team }: { team: string }) {
  const { scene } = usePage().context.running;
  const colour = scene.value && colourOfTeam(scene.value.world, team);
  return <span class="team-dot" aria-hidden="true" style={{ background: colour ?? "none" }} />;
}

export function TeamName({ team }: { team: string }) {
  return (
    <span class="team-name">
      <TeamDot team={team} />
      {t("page-world-team", { team: worldName(team) })}
    </span>
  );
}
