/** Small pictures of objects, drawn as the world in 3D draws them. */

import { Box3, Group, type Object3D, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";

import { theme } from "../../model/preferences";
import { goalMarks, Signs, startMark } from "../../views/world/marks";
import type { WorldValues } from "../../views/world/scenery/description";
import { paintedLines } from "../../views/world/scenery/floor";
import { GameThings, mover } from "../../views/world/scenery/games";
import { cornersOf } from "../../views/world/scenery/geometry";
import { Light } from "../../views/world/scenery/light";
import { type Palette, paletteOf } from "../../views/world/scenery/palette";
import { Pictures } from "../../views/world/scenery/pictures";
import { namedProps } from "../../views/world/scenery/props";
import { things } from "../../views/world/scenery/things";
import { created, missing, ofKind } from "./creating";
import type { Offer } from "./offers";
import { added, emptied } from "./things";

/** The side of a picture, pixels. */
export const PIXELS = 128;
const FIELD = 30;
/** From where an object is seen: from the south-east, above. */
const FROM = new Vector3(0.55, -1, 0.75).normalize();
/** The part of the picture that an object fills. */
const FILLED = 0.92;
/** Objects with a front show it. */
const FRONT = 60;

interface Portrait {
  readonly offer: Offer;
  readonly canvas: HTMLCanvasElement;
}

export class Portraits {
  private readonly renderer = new WebGLRenderer({ alpha: true, antialias: true });
  private readonly camera = new PerspectiveCamera(FIELD, 1, 1, 20_000);
  private readonly pictures = new Pictures(() => this.again());
  private readonly signs = new Signs();
  private readonly drawn: Portrait[] = [];
  private waiting: Portrait[] = [];
  private next = 0;

  /** @throws Error if the browser cannot draw in 3D. */
  constructor(private readonly world: WorldValues) {
    this.renderer.setSize(PIXELS, PIXELS, false);
    this.camera.up.set(0, 0, 1);
  }

  /** Draw an object into a canvas soon. */
  draw(offer: Offer, canvas: HTMLCanvasElement): void {
    this.waiting.push({ offer, canvas });
    this.next ||= window.setTimeout(() => this.step());
  }

  destroy(): void {
    clearTimeout(this.next);
    this.pictures.dispose();
    this.signs.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** A tag or a face has loaded. */
  private again(): void {
    this.waiting.push(...this.drawn.splice(0).filter(({ offer }) => offer.sort === "tag" || offer.sort === "face"));
    this.next ||= window.setTimeout(() => this.step());
  }

  /** One at a time, so that the page answers in between. */
  private step(): void {
    const [portrait, ...others] = this.waiting;
    this.waiting = others;
    this.next = others.length > 0 ? window.setTimeout(() => this.step()) : 0;
    if (!portrait) return;
    this.render(portrait);
    this.drawn.push(portrait);
  }

  private render({ offer, canvas }: Portrait): void {
    const palette = paletteOf(this.world.theme, theme.peek());
    const model = this.modelOf(offer, palette);
    const light = new Light();
    light.show([1000, 1000], palette);
    this.aim(model);
    this.renderer.render(new Scene().add(model, light.object), this.camera);
    canvas.getContext("2d")?.drawImage(this.renderer.domElement, 0, 0, canvas.width, canvas.height);
    dispose(model);
  }

  /** Look at it from as near as shows all of it. */
  private aim(model: Object3D): void {
    const box = new Box3().setFromObject(model);
    const center = box.getCenter(new Vector3());
    this.camera.position.copy(FROM).add(center);
    this.camera.lookAt(center);
    this.camera.updateMatrixWorld();
    const turn = this.camera.quaternion.clone().invert();
    const slope = Math.tan((FIELD / 2) * (Math.PI / 180)) * FILLED;
    const distances = cornersOfBox(box).map((corner) => {
      const { x, y, z } = corner.sub(center).applyQuaternion(turn);
      return Math.max(Math.abs(x), Math.abs(y)) / slope + z;
    });
    this.camera.position
      .copy(FROM)
      .multiplyScalar(Math.max(...distances))
      .add(center);
  }

  private modelOf({ sort, kind }: Offer, palette: Palette): Group {
    let world = emptied(this.world);
    const needed = missing(world, sort);
    if (needed) [world] = added(world, needed, created(world, needed, [0, 0]));
    const thing = created(world, sort, [0, 0]);
    const turned = sort === "tag" || sort === "face" ? { ...thing, heading: FRONT } : thing;
    [world] = added(world, sort, ofKind(turned, kind));
    return this.model(world, palette);
  }

  private model(world: WorldValues, palette: Palette): Group {
    const lines = world.line.map(cornersOf);
    const { fixed, pushed } = things(world, palette, this.pictures);
    const goals = goalMarks(world, lines, this.signs);
    for (const goal of goals) {
      goal.show("open");
      goal.face(FROM.x, FROM.y);
    }
    const played = [new GameThings(world).object, ...world.mover.map(mover)];
    const marks = [...world.start.map(startMark), ...goals.map(({ object }) => object), ...played];
    return new Group().add(fixed, ...pushed, namedProps(world, 0), paintedLines(world, lines), ...marks);
  }
}

function cornersOfBox({ min, max }: Box3): Vector3[] {
  return [min.x, max.x].flatMap((x) => [min.y, max.y].flatMap((y) => [min.z, max.z].map((z) => new Vector3(x, y, z))));
}

function dispose(model: Object3D): void {
  model.traverse((part) => {
    if ("geometry" in part) (part.geometry as { dispose(): void }).dispose();
  });
}
