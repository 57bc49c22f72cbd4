/** A world as a card. */

import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { plainTitle } from "../../model/robots";
import type { RobotChoice, WorldChoice } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { RobotPicture } from "../../ui/robots/picture";
import { able, dots, goalOf, groupOf, reason } from "./guide";

/** How many pictures of robots have room on a card. */
const MOST_ROBOTS = 4;

interface Props {
  readonly world: WorldChoice;
  /** Whether the project uses it. */
  readonly isUsed: boolean;
  readonly robot: RobotChoice | undefined;
  readonly use: (name: string) => void;
}

/** One button, which says all of it. */
export function WorldCard({ world, isUsed, robot, use }: Props) {
  const { project } = usePage();
  const robots = project.welcome.value?.robots ?? [];
  const why = reason(world, robots, robot);
  return (
    <button
      type="button"
      class={`world-card${why ? " unable" : ""}`}
      data-world={world.name}
      aria-current={isUsed ? "true" : undefined}
      onClick={() => use(world.name)}
    >
      <WorldPicture world={world} />
      {isUsed && (
        <span class="world-used">
          <Icon name="check" />
          {t("page-gallery-used")}
        </span>
      )}
      <Players count={world.robots ?? 1} />
      <strong>{project.worldTitle(world.name)}</strong>
      <span class="hidden">{t(`page-gallery-group-${groupOf(world)}`)}</span>
      <span class="world-goal">{why || goalOf(world)}</span>
      <span class="world-facts">
        <Difficulty world={world} />
        <Robots world={world} robots={robots} />
      </span>
    </button>
  );
}

/** The picture of a world, which is drawn if it is one of the user's. */
export function WorldPicture({ world }: { world: WorldChoice }) {
  const { worldPictures } = usePage();
  const picture = worldPictures.of(world);
  useEffect(() => worldPictures.draw(world), [world]);
  if (!picture) return <span class="world-picture" />;
  return <img class="world-picture" src={picture} alt="" width={400} height={200} loading="lazy" />;
}

function Players({ count }: { count: number }) {
  if (count < 2) return null;
  return (
    <span class="world-players">
      <Icon name="teachers" />
      <span aria-hidden="true">{count}</span>
      <span class="hidden">{t("page-gallery-robots", { count })}</span>
    </span>
  );
}

function Difficulty({ world }: { world: WorldChoice }) {
  const filled = dots(world);
  if (!world.difficulty) return <span />;
  return (
    <span class="world-difficulty">
      {[1, 2, 3].map((dot) => (
        <i key={dot} class={dot <= filled ? "filled" : ""} />
      ))}
      {t(`page-gallery-${world.difficulty}`)}
    </span>
  );
}

/** The robots that can solve it, by their pictures. */
function Robots({ world, robots }: { world: WorldChoice; robots: readonly RobotChoice[] }) {
  const those = able(world, robots);
  const all = robots.filter(({ simulated }) => simulated);
  if (those.length === all.length) return <span>{t("page-gallery-all-robots")}</span>;
  return (
    <span class="world-robots">
      {those.slice(0, MOST_ROBOTS).map((robot) => (
        <RobotPicture key={robot.name} robot={robot.name} />
      ))}
      <span class="hidden">{those.map(plainTitle).join(", ")}</span>
    </span>
  );
}
