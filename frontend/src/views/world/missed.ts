/** Marks of what a run has missed: a ring there, a dashed gap to where the robot came nearest, and by how much. */

import { Group, Mesh, MeshBasicMaterial, type Object3D, RingGeometry, Sprite } from "three";

import type { MissedPlace } from "../../model/missed";
import { nameplate } from "./nameplate";
import { MARKS } from "./scenery/colours";
import type { XY } from "./scenery/description";
import { ribbons } from "./scenery/ribbon";

/** mm: of the ring, of the dashes with their gaps, and over the floor. */
const RADIUS = 46;
const WIDTH = 9;
const DASH = 30;
const HEIGHT = 2.2;
/** Of the words, which are smaller and lower than the name of a robot. */
const LABEL = { above: 75, scale: 0.7 } as const;
/** Over goals, trails and things. */
const ORDER = 8;

export class Missed {
  readonly object = new Group();

  show(places: readonly MissedPlace[]): void {
    this.clear();
    for (const missed of places) this.object.add(ring(missed.place), gap(missed), label(missed));
  }

  clear(): void {
    for (const part of [...this.object.children]) release(part);
    this.object.clear();
  }
}

function look(): MeshBasicMaterial {
  return new MeshBasicMaterial({ color: MARKS.failed, toneMapped: false, transparent: true, depthTest: false });
}

function ring([x, y]: XY): Mesh {
  const mesh = new Mesh(new RingGeometry(RADIUS - WIDTH, RADIUS, 40), look());
  mesh.position.set(x, y, HEIGHT);
  mesh.renderOrder = ORDER;
  return mesh;
}

/** Every other piece of the way between both points. */
function gap({ place, nearest }: MissedPlace): Mesh {
  const [dx, dy] = [place[0] - nearest[0], place[1] - nearest[1]];
  const count = Math.max(1, Math.round(Math.hypot(dx, dy) / DASH));
  const at = (share: number): XY => [nearest[0] + share * dx, nearest[1] + share * dy];
  const dashes = Array.from({ length: count }, (_, index) => {
    return { points: [at(index / count), at((index + 0.55) / count)], width: WIDTH, colour: MARKS.failed };
  });
  const mesh = new Mesh(ribbons(dashes, HEIGHT), look());
  mesh.renderOrder = ORDER;
  return mesh;
}

function label({ place, nearest, words }: MissedPlace): Object3D {
  const sprite = nameplate(words, MARKS.failed);
  // Beyond the place, seen from the robot, so that it hides neither.
  const [dx, dy] = [place[0] - nearest[0], place[1] - nearest[1]];
  const away = Math.hypot(dx, dy) || 1;
  sprite.position.set(place[0] + (RADIUS * 2 * dx) / away, place[1] + (RADIUS * 2 * dy) / away, LABEL.above);
  sprite.scale.multiplyScalar(LABEL.scale);
  sprite.renderOrder = ORDER + 1;
  return sprite;
}

function release(part: Object3D): void {
  if (part instanceof Mesh) {
    part.geometry.dispose();
    part.material.dispose();
  }
  if (part instanceof Sprite) {
    part.material.map?.dispose();
    part.material.dispose();
  }
}
