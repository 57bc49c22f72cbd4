/** Score, lives and time of a game, over the world. */

import { t } from "../../i18n";
import { endOf } from "../../model/game-words";
import { usePage } from "../../model/page";
import type { PlayerNow } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { TeamName } from "./team";
import "./hud.css";

/** More lives are shown as a number. */
const MOST_HEARTS = 5;

export function Hud() {
  const { context } = usePage();
  const game = context.running.telemetry.value?.game;
  if (!game || game.players.length === 0) return null;
  // In the order of the halves in which two of them are followed.
  const [first, ...others] = game.players.toSorted((one, other) => one.name.localeCompare(other.name));
  const left = game.time_left;
  return (
    <div class="hud" role="group" aria-label={t("page-world-game-label")}>
      {first && <Player player={first} alone={others.length === 0} counts={game.counts} />}
      {left != null && (
        <p class="hud-time" role="timer" aria-label={t("page-world-game-time", { seconds: Math.ceil(left) })}>
          <Icon name="timer" />
          {clock(left)}
        </p>
      )}
      {others.map((player) => (
        <Player key={player.name} player={player} alone={false} counts={game.counts} />
      ))}
      {game.won != null && <p class="hud-end">{endOf(game)}</p>}
    </div>
  );
}

interface PlayerProps {
  readonly player: PlayerNow;
  readonly alone: boolean;
  /** Whether it has a score to show. */
  readonly counts: boolean | undefined;
}

function Player({ player, alone, counts = true }: PlayerProps) {
  const { context } = usePage();
  const { name, score, lives, team } = player;
  const style = alone ? {} : { borderColor: context.robotColor(name) ?? undefined };
  return (
    <div class="hud-player" style={style}>
      {!alone && <span class="hud-name">{name}</span>}
      {team && <TeamName team={team} />}
      {counts && (
        <span class="hud-score" role="img" aria-label={t("page-world-game-score", { score })}>
          <Icon name="star" />
          {score}
        </span>
      )}
      {lives != null && (
        <span class="hud-lives" role="img" aria-label={t("page-world-game-lives", { lives })}>
          {lives > MOST_HEARTS ? `♥ ${lives}` : "♥".repeat(lives) || "–"}
        </span>
      )}
    </div>
  );
}

/** Minutes and seconds: 0:34. */
function clock(seconds: number): string {
  const whole = Math.ceil(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}
