/** The moving picture in a block's help: its example runs, in blocks and, if the robot moves, in a small world. */

import { t } from "../../i18n";
import { face } from "../../ui/face";
import type { Island } from "../../ui/island";
import { planOf } from "../world/plan/plan";
import { arrow } from "../world/plan/robot";
import { chain, set, svg } from "../world/plan/svg";
import type { BlockHelp } from "./block-help";
import { Drawing } from "./drawing";
import { button } from "./help-button";
import { drawnAt, type Frame, paced, placeAt, shownAt, timeAt, type Waypoint, wayUntil } from "./playback";

/** mm: around the floor, and half the length of the robot. */
const MARGIN = 12;
const ROBOT = 46;

export class MovingPicture implements Island {
  readonly dom = document.createElement("figure");
  private readonly blocks: Drawing;
  private readonly world: SmallWorld | null;
  private readonly said = document.createElement("output");
  private readonly frames: readonly Frame[];
  private animation = 0;

  constructor(help: BlockHelp) {
    this.frames = paced(help.events, help.way.at(-1)?.[0] ?? 0);
    this.world = moves(help.way) ? new SmallWorld(help, this.frames) : null;
    this.blocks = new Drawing(help.workspace, help.program);
    this.dom.className = "lbMoving";
    this.said.className = "lbSaid";
    // It changes all the time: what it says is in the example.
    this.said.ariaLive = "off";
    this.dom.append(
      ...(this.world ? [this.world.dom] : []),
      this.blocks.dom,
      this.said,
      button("run", t("page-help-play"), () => this.play()),
    );
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) this.show(this.length);
    else this.play();
  }

  destroy(): void {
    cancelAnimationFrame(this.animation);
    this.blocks.destroy();
    this.dom.remove();
  }

  resize(): void {
    this.blocks.resize();
  }

  private get length(): number {
    return this.frames.at(-1)?.at ?? 0;
  }

  private play(): void {
    cancelAnimationFrame(this.animation);
    let begun: number | null = null;
    const next = (now: number) => {
      begun ??= now;
      const played = (now - begun) / 1000;
      this.show(Math.min(played, this.length));
      if (played < this.length) this.animation = requestAnimationFrame(next);
    };
    this.animation = requestAnimationFrame(next);
  }

  private show(played: number): void {
    const shown = shownAt(this.frames, played);
    this.world?.show(timeAt(this.frames, played));
    this.blocks.mark(shown.block);
    const parts: (Node | string)[] = [];
    if (shown.face) parts.push(face(shown.face));
    if (shown.light) parts.push(lamp(shown.light));
    if (shown.sign) parts.push(line(shown.sign));
    parts.push(...shown.printed.map(line));
    this.said.replaceChildren(...parts);
  }
}

function moves(way: readonly Waypoint[]): boolean {
  const [first] = way;
  return !!first && way.some((place) => place.slice(1).some((value, index) => value !== first[index + 1]));
}

function line(text: string): HTMLElement {
  return Object.assign(document.createElement("span"), { textContent: text });
}

function lamp(colour: string): HTMLElement {
  const dot = document.createElement("i");
  dot.style.background = colour;
  return dot;
}

/** The world from above, with the robot and its way. */
class SmallWorld {
  readonly dom: SVGSVGElement;
  private readonly way = svg("polyline", { class: "way" });
  private readonly pen = svg("g", { class: "pen" });
  private readonly robot = svg("path", { class: "robot", d: arrow(ROBOT) });

  constructor(
    private readonly help: BlockHelp,
    private readonly frames: readonly Frame[],
  ) {
    const [width, depth] = help.world.floor.size;
    const [w, h] = [width + 2 * MARGIN, depth + 2 * MARGIN];
    const frame = { viewBox: `${-w / 2} ${-h / 2} ${w} ${h}`, class: "world-plan", "aria-hidden": "true" };
    // Without the ring of the start: the robot is there.
    const things = planOf({ ...help.world, start: [] });
    this.dom = svg("svg", frame, ...things, this.way, this.pen, this.robot);
  }

  show(time: number): void {
    const { way } = this.help;
    const place = placeAt(way, time);
    if (!place) return;
    set(this.way, { points: pointsOf(wayUntil(way, time)) });
    const lines = drawnAt(this.frames, way, time);
    this.pen.replaceChildren(
      ...lines.map(({ colour, places }) => {
        const points = pointsOf(places);
        return svg("polyline", colour ? { points, stroke: colour } : { points });
      }),
    );
    const [, x, y, heading] = place;
    set(this.robot, { transform: `translate(${x} ${-y}) rotate(${heading})` });
  }
}

function pointsOf(places: readonly Waypoint[]): string {
  return chain(places.map(([, x, y]) => [x, y] as const));
}
