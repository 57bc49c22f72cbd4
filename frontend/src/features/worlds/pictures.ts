/** Pictures of worlds: ours are taken by `scripts/pictures`, the user's own are drawn here. */

import { signal } from "@preact/signals";

import type { Connection } from "../../protocol/connection";
import type { Scene, WorldChoice } from "../../protocol/messages";

type RobotIn = Scene["robots"][number];

const ADDRESSES = import.meta.glob<string>("./pictures/*.webp", { eager: true, query: "?url", import: "default" });

export class WorldPictures {
  /** The pictures drawn here, by `keyOf`; empty if the browser can't draw one. */
  private readonly drawn = signal<ReadonlyMap<string, string>>(new Map());
  private readonly begun = new Set<string>();
  /** The robot of the project, which is in the pictures. */
  private robot: RobotIn | null = null;
  /** One picture is drawn after the other. */
  private last: Promise<unknown> = Promise.resolve();

  constructor(private readonly connection: Connection) {
    connection.on("Scene", ({ robots }) => (this.robot = robots[0] ?? this.robot));
  }

  /** The address of a world's picture; undefined until it is drawn. */
  of(world: WorldChoice): string | undefined {
    const ours = world.own ? undefined : ADDRESSES[`./pictures/${world.name}.webp`];
    return ours ?? (this.drawn.value.get(keyOf(world)) || undefined);
  }

  /** Draw the picture of a world that has none. */
  draw(world: WorldChoice): void {
    const key = keyOf(world);
    if (this.of(world) || this.begun.has(key)) return;
    this.begun.add(key);
    this.last = this.last.then(async () => this.keep(key, await this.addressOf(world)));
  }

  /** A picture of a world with its robots in it; null if there is no such world. */
  async portrait({ name, robots = 1 }: WorldChoice): Promise<HTMLCanvasElement | null> {
    const answer = await this.connection.ask({ kind: "ReadWorld", name });
    if (answer.kind !== "WorldToEdit") return null;
    const { world, lines } = answer;
    const { drawPortrait } = await import("../../views/world/small");
    const team = this.robot ? Array<RobotIn>(robots).fill(this.robot) : [];
    return drawPortrait({ kind: "Scene", name, world, lines, robots: team }, "light");
  }

  private async addressOf(world: WorldChoice): Promise<string> {
    try {
      const picture = await this.portrait(world);
      const blob = picture && (await new Promise<Blob | null>((done) => picture.toBlob(done, "image/webp", 0.8)));
      return blob ? URL.createObjectURL(blob) : "";
    } catch (error) {
      // Without 3D, a card has no picture.
      console.warn(error);
      return "";
    }
  }

  private keep(key: string, address: string): void {
    this.drawn.value = new Map(this.drawn.peek()).set(key, address);
  }
}

/** A world that is saved again has another picture. */
function keyOf({ name, changed = 0 }: WorldChoice): string {
  return `${name} ${changed}`;
}
