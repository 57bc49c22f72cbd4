/** The drawing on the floor, in pieces; as it grows, only the newest piece is rebuilt. */

import { Group, Mesh } from "three";
import type { Stroke } from "../../model/drawing";
import { isDark } from "./scenery/colours";
import { LINE_PAINT } from "./scenery/floor";
import { type Ribbon, ribbons } from "./scenery/ribbon";

/** Above the trail. */
const HEIGHT = 1.8;
const ORDER = 5;
/** The points of a piece. */
const PIECE = 400;
/** A dark stroke on a dark floor has a light edge, mm wide. */
const EDGE = 3;
const LIGHT_EDGE = "#dfe5ff";

export class FloorDrawing {
  readonly object = new Group();
  private strokes: readonly Stroke[] = [];
  /** How many points of each stroke are drawn. */
  private drawn: number[] = [];
  private ribbons: { stroke: number; ribbon: Ribbon }[] = [];
  private piece: Mesh | null = null;
  private size = 0;
  private isOnDark = false;

  /** Whether nothing is drawn. */
  get empty(): boolean {
    return this.drawn.length === 0;
  }

  show(strokes: readonly Stroke[]): void {
    if (strokes !== this.strokes) this.clear();
    this.strokes = strokes;
    let grown = false;
    strokes.forEach((stroke, i) => {
      if (stroke.points.length <= (this.drawn[i] ?? 0)) return;
      this.extend(stroke, i);
      grown = true;
    });
    if (grown) this.build();
  }

  /** Draw on a floor of this colour, what is drawn already too. */
  on(floor: string): void {
    const onDark = isDark(floor);
    if (onDark === this.isOnDark) return;
    this.isOnDark = onDark;
    const { strokes } = this;
    this.clear();
    this.show(strokes);
  }

  clear(): void {
    for (const mesh of this.object.children) if (mesh instanceof Mesh) mesh.geometry.dispose();
    this.object.clear();
    this.drawn = [];
    this.begin();
  }

  private begin(): void {
    this.piece = null;
    this.ribbons = [];
    this.size = 0;
  }

  private extend(stroke: Stroke, index: number): void {
    if (this.size >= PIECE) {
      this.build();
      this.begin();
    }
    const from = this.drawn[index] ?? 0;
    const last = this.ribbons.at(-1);
    // A ribbon starts at the last point of the one before.
    const fresh = stroke.points.slice(last?.stroke === index ? from : Math.max(0, from - 1));
    if (last?.stroke === index) last.ribbon = { ...last.ribbon, points: [...last.ribbon.points, ...fresh] };
    else this.ribbons.push({ stroke: index, ribbon: ribbonOf(stroke, fresh) });
    this.size += fresh.length;
    this.drawn[index] = stroke.points.length;
  }

  private build(): void {
    if (!this.piece) {
      this.piece = new Mesh(undefined, LINE_PAINT);
      this.piece.renderOrder = ORDER;
      this.piece.frustumCulled = false;
      this.object.add(this.piece);
    }
    this.piece.geometry.dispose();
    const strokes = this.ribbons.map(({ ribbon }) => ribbon);
    const edges = this.isOnDark ? strokes.filter(({ colour }) => isDark(colour)) : [];
    const wide = edges.map((ribbon) => ({ ...ribbon, width: ribbon.width + 2 * EDGE, colour: LIGHT_EDGE }));
    this.piece.geometry = ribbons([...wide, ...strokes], HEIGHT);
  }
}

function ribbonOf({ color, width }: Stroke, points: Ribbon["points"]): Ribbon {
  return { points, width, colour: `rgb(${color.join(",")})` };
}
