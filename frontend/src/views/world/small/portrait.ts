/** Draws a world with its robots once, as a picture for the gallery of worlds. */

import { PerspectiveCamera, Vector3 } from "three";

import type { ThemeName } from "../../../model/preferences";
import type { Scene } from "../../../protocol/messages";
import { QUALITIES } from "../quality";
import { paletteOf } from "../scenery/palette";
import { Pictures } from "../scenery/pictures";
import { Stage } from "../stage";
import { View } from "../view";
import { areaOfAll, cameraOver, FIELD } from "./camera";
import { Waiting } from "./waiting";

/** The size of a portrait, in pixels. */
export const WIDTH = 400;
export const HEIGHT = 200;
/** ms for which a world's own pictures may load before it is drawn without them. */
const PATIENCE = 3000;

/**
 * @returns a canvas with the picture.
 * @throws Error if the browser cannot draw in 3D.
 */
export async function drawPortrait(scene: Scene, theme: ThemeName): Promise<HTMLCanvasElement> {
  const camera = new PerspectiveCamera(FIELD, WIDTH / HEIGHT, 20, 60_000);
  const view = new View(document.createElement("canvas"), camera, () => false);
  try {
    const palette = paletteOf(scene.world.theme, theme);
    const waiting = new Waiting();
    const pictures = new Pictures(() => undefined, "", waiting);
    const stage = new Stage(scene, palette, () => undefined, undefined, pictures);
    if (stage.beams) stage.beams.object.visible = false;
    view.scene.add(stage.object);
    view.surround(scene.world.floor.size, palette, stage.fog);
    await waiting.done(PATIENCE);
    aim(camera, stage, scene);
    view.resize(WIDTH, HEIGHT);
    const picture = copy(view);
    stage.dispose();
    pictures.dispose();
    return picture;
  } finally {
    view.dispose();
  }
}

function aim(camera: PerspectiveCamera, stage: Stage, scene: Scene): void {
  const { place, target } = cameraOver(areaOfAll(scene), WIDTH / HEIGHT);
  camera.up.set(0, 0, 1);
  camera.position.set(...place);
  camera.lookAt(new Vector3(...target, 0));
  camera.updateProjectionMatrix();
  stage.face({ x: place[0], y: place[1] });
}

function copy(view: View): HTMLCanvasElement {
  view.renderOnce(QUALITIES[0]!);
  const canvas = Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT });
  const brush = canvas.getContext("2d");
  if (brush) brush.imageSmoothingQuality = "high";
  brush?.drawImage(view.canvas, 0, 0, WIDTH, HEIGHT);
  return canvas;
}
