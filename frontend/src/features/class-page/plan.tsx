/** A world from above, without 3D; a live one also shows the robot and its way. */

import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

import { theme } from "../../model/preferences";
import type { Plan, Seat } from "../../protocol/classroom";
import { planOf } from "../../views/world/plan/plan";
import { arrow } from "../../views/world/plan/robot";
import type { WorldValues } from "../../views/world/scenery/description";

/** mm: the margin around the floor, and half the length of the robot's arrow. */
const MARGIN = 30;
const ARROW = 70;

interface Props {
  readonly plan: Plan | undefined;
  readonly seat: Seat;
  /** What screen readers say. */
  readonly label: string;
  readonly look?: string;
}

export function FlatWorld({ plan, seat, label, look = "small-world" }: Props) {
  const world = plan?.scene.world;
  if (!world) return <div class="small-world empty" />;
  return (
    <WorldPlan world={world} label={label} look={look}>
      <polyline class="way" points={wayPoints(seat.way ?? []).join(" ")} />
      {seat.pose && (
        <path
          class="robot"
          d={arrow(ARROW)}
          transform={`translate(${seat.pose[0]} ${-seat.pose[1]}) rotate(${seat.pose[2]})`}
        />
      )}
    </WorldPlan>
  );
}

interface WorldPlanProps {
  readonly world: WorldValues;
  /** What screen readers say. */
  readonly label: string;
  readonly look?: string;
  /** What of it is seen, as a `viewBox`; without it, all. */
  readonly area?: string | undefined;
  /** What is drawn over the world. */
  readonly children?: ComponentChildren;
}

/** A world from above. */
export function WorldPlan({ world, label, look = "", area, children }: WorldPlanProps) {
  const things = useRef<SVGGElement>(null);
  useLayoutEffect(() => {
    things.current?.replaceChildren(...planOf(world));
  }, [world, theme.value]);
  const [width, depth] = world.floor.size.map((side) => side + 2 * MARGIN) as [number, number];
  return (
    <svg
      class={`${look} world-plan`}
      role="img"
      aria-label={label}
      viewBox={area ?? `${-width / 2} ${-depth / 2} ${width} ${depth}`}
    >
      <g ref={things} />
      {children}
    </svg>
  );
}

/** The points of a way of alternating x and y in mm; in the picture, y grows downwards. */
export function wayPoints(way: readonly number[]): readonly (readonly [number, number])[] {
  const found: [number, number][] = [];
  for (let i = 0; i + 1 < way.length; i += 2) found.push([way[i]!, -way[i + 1]!]);
  return found;
}
