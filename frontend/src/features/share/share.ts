/** What shows the world to others: a picture or a short film, which the browser makes, and a run as a page. */

import { signal } from "@preact/signals";

import { language, t } from "../../i18n";
import type { Page } from "../../model/page";
import { Cleanup } from "../../ui/cleanup";
import { bytesOf, saveFile } from "../../ui/files";
import { Film, filmFormat } from "./film";
import { drawWorld, fillSky, newBrush, type Quality } from "./frame";

const PICTURE = [1280, 720] as const;
const FILM = [854, 480] as const;
/** Frames in a second: more would take the processor from the run. */
const RATE = 12;
/** The longest film, ms. */
const LONGEST = 60_000;
/** How long the end is shown, ms. */
const LAST_LOOK = 800;
const CAPTION = { height: 56, font: '800 26px "Nunito Variable", sans-serif', ink: "#ffffff", ground: "#4338ca" };

export class Share {
  readonly isFilming = signal(false);

  constructor(private readonly page: Pick<Page, "context" | "controls" | "project" | "toasts" | "views">) {
    page.context.connection.on("RunExported", ({ filename, content }) =>
      saveFile(filename, bytesOf(content), "text/html"),
    );
  }

  /** Save the last run as a page that needs no LearnBlock; it says who made it, unless that is empty. */
  exportRun(pupil: string): void {
    this.page.toasts.note(t("page-share-run-making"));
    this.page.context.connection.send({ kind: "ExportRun", language: language.peek(), pupil });
  }

  /** Save a picture of the world as it is now, with the name of the project. */
  async takePicture(): Promise<void> {
    const brush = newBrush(...PICTURE);
    if (!this.drawFrame(brush, "best")) return;
    const png = await new Promise<Blob | null>((done) => brush.canvas.toBlob(done, "image/png"));
    if (png) saveFile(`${this.title}.png`, png, "image/png");
  }

  /** Run the program from the start, and save a film of it when it ends. */
  film(): void {
    const { controls, context } = this.page;
    if (context.connection.state.peek() !== "open") return;
    const followed = new Cleanup();
    const film = this.record(() => followed.dispose());
    if (!film) return;
    this.follow(film, followed);
    controls.restart();
  }

  /**
   * Begin a film of the world, which is saved when it ends; return null if there can be none.
   *
   * @param over is called at the end.
   */
  record(over: () => void): Film | null {
    const { toasts } = this.page;
    if (this.isFilming.peek()) return null;
    const format = filmFormat();
    if (!format) {
      toasts.error(t("page-share-no-film"));
      return null;
    }
    const brush = newBrush(...FILM);
    if (!this.drawFrame(brush)) return null;
    const moves = { draw: () => void this.drawFrame(brush), rate: RATE, longest: LONGEST };
    this.isFilming.value = true;
    return new Film(brush.canvas, format, moves, (made) => {
      over();
      this.isFilming.value = false;
      if (!made) return;
      saveFile(`${this.title}.${format.ending}`, made, format.type);
      toasts.note(t("page-share-saved"));
    });
  }

  /** End a film with its run, and drop that of a run which does not start. */
  private follow(film: Film, followed: Cleanup): void {
    const { connection } = this.page.context;
    followed.add(
      connection.on("Ended", () => window.setTimeout(() => film.end(), LAST_LOOK)),
      connection.onRefused(["Run"], () => film.drop()),
      // Its run is not seen any more.
      connection.state.subscribe((state) => state !== "open" && film.drop()),
    );
  }

  private get title(): string {
    return this.page.project.name.peek();
  }

  private drawFrame(brush: CanvasRenderingContext2D, quality: Quality = "usual"): boolean {
    const world = this.page.views.world.peek();
    if (!world || !drawWorld(world, brush, quality)) return false;
    fillSky(brush);
    this.writeCaption(brush);
    return true;
  }

  private writeCaption(brush: CanvasRenderingContext2D): void {
    const { width, height } = brush.canvas;
    const top = height - CAPTION.height;
    brush.fillStyle = CAPTION.ground;
    brush.fillRect(0, top, width, CAPTION.height);
    brush.fillStyle = CAPTION.ink;
    brush.font = CAPTION.font;
    brush.textBaseline = "middle";
    brush.fillText(this.title, 24, top + CAPTION.height / 2, width - 240);
    brush.textAlign = "right";
    brush.fillText("LearnBlock", width - 24, top + CAPTION.height / 2);
    brush.textAlign = "left";
  }
}

declare module "../../model/page" {
  interface Page {
    readonly share: Share;
  }
}
