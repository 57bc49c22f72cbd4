/** What small pictures of worlds are made of, each drawn once in 3D: plates without robots, and sprites of robots. */

import { Fog, PerspectiveCamera, Vector3 } from "three";

import type { ThemeName } from "../../../model/preferences";
import type { Scene } from "../../../protocol/messages";
import { QUALITIES } from "../quality";
import { type RobotModel, robotModel } from "../robots";
import type { RobotValues, XY } from "../scenery/description";
import { radians } from "../scenery/geometry";
import { paletteOf } from "../scenery/palette";
import { Pictures } from "../scenery/pictures";
import { Stage } from "../stage";
import { View } from "../view";
import { areasOf, cameraOver, FIELD, type SmallCamera, STEEPNESS } from "./camera";
import { Waiting } from "./waiting";

/** The size of a plate, and of a sprite, in pixels. */
export const WIDTH = 332;
export const HEIGHT = 226;
const SPRITE = 128;
/** The headings of which a robot has a sprite. */
const HEADINGS = 16;
/** Degrees of a sprite's height: from far away, so that it is the same everywhere on the floor. */
const NARROW = 6;
/** Reflections would not be seen. */
const QUALITY = QUALITIES[1]!;
/** How many worlds are kept. */
const MOST = 80;
/** ms for which a world's own pictures may load before it is drawn without them. */
const PATIENCE = 3000;

/** One picture of a world, and the camera that has taken it. */
export interface Shot {
  readonly picture: CanvasImageSource;
  readonly camera: SmallCamera;
}

/** A world without robots. */
export interface Plate {
  /** From near to far: a robot that leaves one is shown in the next. */
  readonly shots: readonly Shot[];
  /** Where its goals are, in the order of telemetry. */
  readonly goals: readonly XY[];
}

/** A robot in all directions. */
export interface Sprites {
  readonly pictures: readonly CanvasImageSource[];
  /** mm of a picture's height. */
  readonly size: number;
  /** Where the middle of the robot is on the floor, as a share of the picture's height from its upper edge. */
  readonly ground: number;
}

/** Draws plates and sprites one after the other, and keeps them. */
export class Plates {
  private readonly plates = new Map<string, Plate | null>();
  private readonly sprites = new Map<string, Sprites | null>();
  /** Worlds and robots as text, by object: each repaint looks them up. */
  private readonly texts = new WeakMap<object, string>();
  private readonly jobs: (() => Promise<void>)[] = [];
  private readonly camera = new PerspectiveCamera(NARROW, 1, 20, 60_000);
  private readonly view: View;
  private readonly size = { width: 0, height: 0 };
  private works = false;

  /**
   * @param changed is called when there is another plate, or all sprites of a robot.
   * @throws Error if the browser cannot draw in 3D.
   */
  constructor(private readonly changed: () => void) {
    this.view = new View(document.createElement("canvas"), this.camera, () => false);
  }

  /**
   * The plate of a world; null until it is drawn.
   *
   * @param base the address to which those of the world's pictures are relative.
   * @param scale how much larger than usual it is drawn.
   */
  of(scene: Scene, theme: ThemeName, base: string, scale = 1): Plate | null {
    const { name, world, lines, start, real } = scene;
    const key = `${theme} ${scale} ${this.textOf(scene, [name, world, lines, start, real])}`;
    const known = this.plates.get(key);
    if (known !== undefined) return known;
    this.plates.set(key, null);
    this.enqueue(async () => {
      this.plates.set(key, await this.draw(scene, theme, base, scale));
      for (const oldest of [...this.plates.keys()].slice(0, Math.max(0, this.plates.size - MOST)))
        this.plates.delete(oldest);
    });
    return null;
  }

  /** The sprites of a robot, drawn so much larger than usual; null until they are drawn. */
  spritesOf(robot: RobotValues, theme: ThemeName, scale = 1): Sprites | null {
    const key = `${theme} ${scale} ${this.textOf(robot, robot)}`;
    const known = this.sprites.get(key);
    if (known !== undefined) return known;
    this.sprites.set(key, null);
    this.enqueue(async () => void this.sprites.set(key, this.turn(robot, theme, scale)));
    return null;
  }

  /** The values of an object that never changes, as text; made once. */
  private textOf(of: object, values: unknown): string {
    const known = this.texts.get(of);
    if (known !== undefined) return known;
    const text = JSON.stringify(values);
    this.texts.set(of, text);
    return text;
  }

  private enqueue(job: () => Promise<void>): void {
    this.jobs.push(job);
    if (!this.works) void this.work();
  }

  private async work(): Promise<void> {
    this.works = true;
    for (let job = this.jobs.shift(); job; job = this.jobs.shift()) {
      await job();
      this.changed();
      // Between two of them the page answers its user.
      await new Promise((resolve) => setTimeout(resolve));
    }
    this.works = false;
  }

  private async draw(scene: Scene, theme: ThemeName, base: string, scale: number): Promise<Plate> {
    const { world } = scene;
    const palette = paletteOf(world.theme, theme);
    const waiting = new Waiting();
    const pictures = new Pictures(() => undefined, base, waiting);
    const stage = new Stage({ ...scene, robots: [] }, palette, () => undefined, undefined, pictures);
    this.view.scene.add(stage.object);
    this.view.surround(world.floor.size, palette, stage.fog);
    await waiting.done(PATIENCE);
    this.resize(WIDTH * scale, HEIGHT * scale);
    const aspect = WIDTH / HEIGHT;
    const shots = areasOf(scene).map((area) => this.shoot(stage, cameraOver(area, aspect)));
    const plate = { shots, goals: stage.places };
    stage.dispose();
    pictures.dispose();
    return plate;
  }

  private shoot(stage: Stage, camera: SmallCamera): Shot {
    const [x, y, z] = camera.place;
    this.camera.fov = FIELD;
    this.look(new Vector3(x, y, z), new Vector3(...camera.target, 0));
    stage.face({ x, y });
    return { picture: this.take(), camera };
  }

  private turn(robot: RobotValues, theme: ThemeName, scale: number): Sprites {
    const model = robotModel(robot);
    const palette = paletteOf(undefined, theme);
    const size = 2.3 * Math.max(model.reach, model.height * 0.75);
    this.view.scene.add(model.object);
    this.view.surround([size, size], palette, new Fog("white", 1e6, 2e6));
    this.resize(SPRITE * scale, SPRITE * scale);
    this.camera.fov = NARROW;
    const distance = size / 2 / Math.tan(radians(NARROW / 2));
    const middle = model.height * 0.42;
    const down = radians(STEEPNESS);
    const target = new Vector3(0, 0, middle);
    this.look(new Vector3(0, -distance * Math.cos(down), middle + distance * Math.sin(down)), target);
    const pictures = Array.from({ length: HEADINGS }, (_, i) => this.facing(model, (i * 360) / HEADINGS));
    model.object.removeFromParent();
    model.dispose();
    return { pictures, size, ground: 0.5 + (middle * Math.cos(down)) / size };
  }

  private facing(model: RobotModel, heading: number): CanvasImageSource {
    model.show({ name: "", x: 0, y: 0, heading });
    return this.take();
  }

  private look(place: Vector3, target: Vector3): void {
    this.camera.up.set(0, 0, 1);
    this.camera.position.copy(place);
    this.camera.lookAt(target);
    this.camera.updateProjectionMatrix();
  }

  private resize(width: number, height: number): void {
    if (this.size.width === width && this.size.height === height) return;
    Object.assign(this.size, { width, height });
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.view.resize(width, height);
  }

  /** Draw it now, and copy it: the next picture is drawn on the same canvas. */
  private take(): CanvasImageSource {
    this.view.renderOnce(QUALITY);
    const copy = document.createElement("canvas");
    Object.assign(copy, this.size);
    copy.getContext("2d")?.drawImage(this.view.canvas, 0, 0, copy.width, copy.height);
    return copy;
  }
}

/** The sprite of a robot that faces somewhere. */
export function facing({ pictures }: Sprites, heading: number): CanvasImageSource {
  const turn = Math.round((heading / 360) * pictures.length);
  return pictures[((turn % pictures.length) + pictures.length) % pictures.length]!;
}
