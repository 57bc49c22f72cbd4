/** Sends the server a picture of the world for the list of projects: when a run ends, and of a new project. */

import { effect } from "@preact/signals";

import type { Page } from "../../model/page";
import type { WorldIsland } from "../../model/views";
import { LIMITS } from "../../protocol/messages";
import { inBase64 } from "../../ui/files";
import { drawWorld, fillSky, newBrush } from "../share/frame";

/** The hero of the start page is as large. */
const WIDTH = 960;
const HEIGHT = 540;
const QUALITIES = [0.8, 0.65, 0.5, 0.35];
/** The ms for which a world must have been shown: to draw its picture stops the page for a moment. */
const SHOWN = 3000;

export function keepPictures({ context: { connection, program, running }, project, views }: Page): void {
  connection.on("Ended", ({ tried }) => {
    if (tried || program.readOnly.peek()) return;
    // By the next frame, the world shows how the run ended.
    requestAnimationFrame(() => void send(project.name.peek(), views.world.peek()));
  });

  const seen = new Set<string>();
  /** The project whose world has been shown for long enough. */
  let shown = "";
  effect(() => {
    const name = project.name.value;
    const isDrawn = views.areLoaded.value && running.scene.value !== null;
    if (!name || !isDrawn || seen.has(name) || program.readOnly.value) return;
    const look = setTimeout(() => {
      shown = name;
      project.list();
    }, SHOWN);
    return () => clearTimeout(look);
  });
  connection.on("Projects", ({ projects }) => {
    const name = project.name.peek();
    const entry = projects.find((one) => one.name === name);
    if (!entry || seen.has(name) || name !== shown) return;
    seen.add(name);
    if (!entry.picture) void send(name, views.world.peek());
  });

  async function send(project: string, world: WorldIsland | null): Promise<void> {
    const picture = project && world && pictureOf(world);
    const jpeg = picture && (await encode(picture));
    if (jpeg) connection.send({ kind: "KeepPicture", project, content: await inBase64(new File([jpeg], "")) });
  }
}

/** A small copy of the world's canvas; null if nothing is drawn there. */
function pictureOf(world: WorldIsland): HTMLCanvasElement | null {
  const brush = newBrush(WIDTH, HEIGHT);
  if (!drawWorld(world, brush, "best") || isBlank(brush)) return null;
  fillSky(brush);
  return brush.canvas;
}

function isBlank(brush: CanvasRenderingContext2D): boolean {
  return brush.getImageData(0, 0, WIDTH, HEIGHT).data.every((value) => value === 0);
}

/** A JPEG, which every browser can make, small enough for the server; null if none is. */
async function encode(picture: HTMLCanvasElement): Promise<Blob | null> {
  for (const quality of QUALITIES) {
    const jpeg = await new Promise<Blob | null>((done) => picture.toBlob(done, "image/jpeg", quality));
    if (jpeg && jpeg.size <= LIMITS.KeepPicture.content) return jpeg;
  }
  return null;
}
