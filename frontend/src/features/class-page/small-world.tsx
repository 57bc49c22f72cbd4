/** A small live picture of a pupil's world, painted over what is drawn in 3D once; a plan where nothing can be. */

import { type Signal, signal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";

import { theme } from "../../model/preferences";
import type { Plan, Seat } from "../../protocol/classroom";
import type { Plates } from "../../views/world/small";
import { FlatWorld } from "./plan";

/** What draws the pictures, which is loaded with the first of them. */
export class Drawing {
  /** Grows when there is more to paint with. */
  readonly version = signal(0);
  readonly module: Signal<typeof import("../../views/world/small") | null> = signal(null);
  /** Whether the browser can't draw in 3D. */
  readonly isFlat = signal(false);
  private begun = false;
  plates: Plates | null = null;

  begin(): void {
    if (this.begun) return;
    this.begun = true;
    void this.load();
  }

  private async load(): Promise<void> {
    try {
      const module = await import("../../views/world/small");
      this.plates = new module.Plates(() => (this.version.value += 1));
      this.module.value = module;
    } catch (error) {
      console.warn(error);
      this.isFlat.value = true;
    }
  }
}

interface Props {
  readonly drawing: Drawing;
  readonly plan: Plan | undefined;
  readonly seat: Seat;
  readonly isGrey: boolean;
  /** What screen readers say. */
  readonly label: string;
  /** The address of the pupil's page, which has the pictures in the world. */
  readonly base: string;
  /** How much larger than usual it is drawn. */
  readonly scale: number;
}

export function SmallWorld({ drawing, plan, seat, isGrey, label, base, scale }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const { module, version, isFlat } = drawing;
  useLayoutEffect(() => drawing.begin(), []);
  useLayoutEffect(() => {
    const pen = canvas.current?.getContext("2d");
    if (!pen || !plan || !module.value || !drawing.plates) return;
    const { scene } = plan;
    const plate = drawing.plates.of(scene, theme.value, base, scale);
    const robot = scene.robots[0]?.[1];
    const sprites = robot ? drawing.plates.spritesOf(robot, theme.value, scale) : null;
    if (!plate || !canvas.current) return;
    const { pose = scene.start ?? null, way = [], goals = [] } = seat;
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    canvas.current.dataset.shown = `${module.value.paint(pen, plate, sprites, { pose, way, goals })}`;
  }, [plan, seat.pose, seat.way, seat.goals, theme.value, version.value, module.value, scale]);
  const look = isGrey ? "small-world old" : "small-world";
  if (isFlat.value) return <FlatWorld plan={plan} seat={seat} label={label} look={look} />;
  return <canvas ref={canvas} class={look} role="img" aria-label={label} width={332 * scale} height={226 * scale} />;
}
