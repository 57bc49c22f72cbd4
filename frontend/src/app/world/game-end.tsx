/** The end of a game, over the world: how it ended, the score, and another round. */

import { useSignal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";

import { t } from "../../i18n";
import { endOf, winningGoal } from "../../model/game-words";
import { usePage } from "../../model/page";
import type { GameNow, PlayerNow } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { TeamDot } from "./team";
import "./game-end.css";

/** Shown when a run has ended with its game; not while the user looks back. */
export function GameEnd({ isGuests }: { isGuests: boolean }) {
  const { running } = usePage().context;
  const game = running.telemetry.value?.game;
  const hasEnded = running.state.value.state === "ended" && !running.past.value;
  return hasEnded && game?.won != null ? <EndCard game={game} isGuests={isGuests} /> : null;
}

function EndCard({ game, isGuests }: { game: GameNow; isGuests: boolean }) {
  const { controls, replay, context } = usePage();
  const closed = useSignal(false);
  const goal = winningGoal(game, context.running.telemetry.value?.goals ?? []);
  const card = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    // A player goes on here by keyboard, but a key that is still held down must press no button.
    const world = card.current?.closest(".region");
    const { activeElement } = document;
    if (activeElement === document.body || world?.contains(activeElement)) card.current?.focus();
  }, []);
  if (closed.value) return null;
  return (
    <section class="game-end" aria-labelledby="game-end" data-region="game-end" tabIndex={-1} ref={card}>
      <div role="status">
        <h3 id="game-end">
          {game.team && <TeamDot team={game.team} />} {endOf(game)}
        </h3>
        {goal && <p>{goal}</p>}
        {game.reason === "lives" && <p>{t("page-world-game-no-lives")}</p>}
        {game.counts !== false &&
          game.players.map((player) => <Result key={player.name} player={player} alone={game.players.length === 1} />)}
      </div>
      <p class="game-end-actions">
        {!isGuests && (
          <button type="button" class="button filled" onClick={() => controls.run()}>
            <Icon name="run" />
            {t("page-world-game-again")}
          </button>
        )}
        {context.running.timeline.value && (
          <button type="button" class="button bordered" onClick={() => replay.watch()}>
            <Icon name="video" />
            {t("page-world-game-watch")}
          </button>
        )}
        <button type="button" class="button bordered" onClick={() => (closed.value = true)}>
          {t("page-world-game-close")}
        </button>
      </p>
    </section>
  );
}

function Result({ player, alone }: { player: PlayerNow; alone: boolean }) {
  const score = t("page-world-game-score", { score: player.score });
  return (
    <p class="game-end-score">
      {player.team && <TeamDot team={player.team} />} {alone ? score : `${player.name}: ${score}`}
    </p>
  );
}
