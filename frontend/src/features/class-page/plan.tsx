/** A small live world from above, without 3D: what is in it, where the robot is, and where it has been. */

import { useLayoutEffect, useRef } from "preact/hooks";

import { theme } from "../../model/preferences";
import type { Plan, Seat } from "../../protocol/classroom";
import { planOf } from "../../views/world/plan/plan";
import { arrow } from "../../views/world/plan/robot";

/** mm: the margin around the floor, and half the length of the robot's arrow. */
const MARGIN = 30;
const ARROW = 70;

interface Props {
  readonly plan: Plan | undefined;
  readonly seat: Seat;
  /** What screen readers say. */
  readonly label: string;
}

export function FlatWorld({ plan, seat, label }: Props) {
  const things = useRef<SVGGElement>(null);
  const world = plan?.scene.world;
  useLayoutEffect(() => {
    if (world) things.current?.replaceChildren(...planOf(world));
  }, [plan, theme.value]);
  if (!world) return <div class="small-world empty" />;
  const [width, depth] = world.floor.size;
  const size = [width + 2 * MARGIN, depth + 2 * MARGIN];
  return (
    <svg
      class="small-world world-plan"
      role="img"
      aria-label={label}
      viewBox={`${-size[0]! / 2} ${-size[1]! / 2} ${size[0]} ${size[1]}`}
    >
      <g ref={things} />
      <polyline class="way" points={points(seat.way ?? [])} />
      {seat.pose && (
        <path
          class="robot"
          d={arrow(ARROW)}
          transform={`translate(${seat.pose[0]} ${-seat.pose[1]}) rotate(${seat.pose[2]})`}
        />
      )}
    </svg>
  );
}

/** Points of an SVG polyline from x and y in mm, one after the other. */
function points(way: readonly number[]): string {
  const pairs: string[] = [];
  for (let i = 0; i + 1 < way.length; i += 2) pairs.push(`${way[i]},${-way[i + 1]!}`);
  return pairs.join(" ");
}
