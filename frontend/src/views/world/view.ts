/** The world's canvas, drawn only while something changes. */

import {
  type Fog,
  Mesh,
  NeutralToneMapping,
  PCFShadowMap,
  type PerspectiveCamera,
  PMREMGenerator,
  Scene,
  type Texture,
  Vector2,
  WebGLRenderer,
} from "three";
import { RoomEnvironment } from "three/addons/environments/RoomEnvironment.js";
import type { Lens } from "./halves";
import { QUALITIES, Qualities, type Quality } from "./quality";
import type { XY } from "./scenery/description";
import { Light } from "./scenery/light";
import type { Palette } from "./scenery/palette";
import { COAT, PAINT } from "./scenery/solids";

/** More pixels are slow and make no visible difference. */
const SHARPEST = 2;
const REFLECTIONS = 0.4;
/** The first and best quality, with and without a graphics card: a moving picture must leave a processor to the program. */
const FIRST = { fast: 0, slow: 4 } as const;
/** Without a graphics card, a picture in which nothing moves is drawn with this many times the pixels, after ms. */
const STILL = { sharpness: 1.5, shadows: 1024, after: 350 } as const;

export class View {
  readonly scene = new Scene();
  /** The number of frames drawn, for benchmarks. */
  framesDrawn = 0;
  private readonly light = new Light();
  private readonly renderer: WebGLRenderer;
  private readonly fast = drawsFast();
  private readonly qualities: Qualities;
  private quality = QUALITIES[0] as Quality;
  private room: Texture | null = null;
  private shadowsMove = true;
  private frame = 0;
  /** When the next frame may be drawn. */
  private due = 0;
  /** Pixels of the picture for each of the page: of the screen, and while something moves. */
  private screen = 1;
  private ratio = 1;
  private stillness = 0;
  private lenses: readonly Lens[] = [];
  private readonly size = new Vector2();

  /**
   * @param before is called before each frame; true requests another frame.
   * @param aimed is called before a camera draws, as some things turn to it.
   * @throws Error if the browser cannot draw in 3D.
   */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly camera: PerspectiveCamera,
    private readonly before: (now: number) => boolean,
    private readonly aimed: (camera: PerspectiveCamera) => void = () => undefined,
  ) {
    this.renderer = new WebGLRenderer({ canvas, alpha: true, antialias: this.fast });
    this.renderer.toneMapping = NeutralToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false;
    this.scene.environmentIntensity = REFLECTIONS;
    this.scene.add(this.light.object);
    this.qualities = new Qualities(this.fast ? FIRST.fast : FIRST.slow, (quality) => this.apply(quality));
    canvas.addEventListener("webglcontextrestored", () => this.invalidate());
  }

  /** Show the sky and the light around a floor of this size, mm. */
  surround(size: XY, palette: Palette, fog: Fog): void {
    this.scene.fog = fog;
    this.light.show(size, palette);
    this.shade();
    this.invalidate();
  }

  /** Divide the picture from the next frame on; without lenses it has the one camera. */
  divide(lenses: readonly Lens[]): void {
    if (this.lenses.length > 0 && lenses.length === 0) {
      this.renderer.setScissorTest(false);
      this.renderer.setViewport(0, 0, ...this.renderer.getSize(this.size).toArray());
    }
    this.lenses = lenses;
  }

  /** Redraw with the next frame. */
  invalidate(): void {
    this.frame ||= requestAnimationFrame((now) => this.draw(now));
  }

  /** Cast the shadows again with the next frame. */
  moveShadows(): void {
    this.shadowsMove = true;
  }

  resize(width: number, height: number): void {
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    // Now: a resized canvas is empty.
    this.render(performance.now());
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.stillness);
    this.room?.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private draw(now: number): void {
    this.frame = 0;
    // More frames would take the processor from the program.
    if (now < this.due) return this.invalidate();
    // A late frame is made up for by the next one, but a pause is not.
    this.due = Math.max(this.due + this.quality.pace, now);
    this.render(now);
  }

  private render(now: number): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const again = this.before(now);
    this.sharpen(this.ratio, this.quality.shadows);
    this.castShadows(again);
    this.paint();
    this.framesDrawn += 1;
    this.qualities.note(now, again);
    if (again) this.invalidate();
    if (this.fast) return;
    clearTimeout(this.stillness);
    if (!again) this.stillness = window.setTimeout(() => this.renderStill(), STILL.after);
  }

  /** Without a graphics card, shadows move with every second frame of a movement, and with its last one. */
  private castShadows(again: boolean): void {
    if (!this.shadowsMove || (again && !this.fast && this.framesDrawn % 2 === 1)) return;
    this.shadowsMove = false;
    this.renderer.shadowMap.needsUpdate = true;
  }

  /** The picture will stay for a while: draw it once more without jagged edges. */
  private renderStill(): void {
    if (this.frame) return;
    this.sharpen(STILL.sharpness * this.screen, STILL.shadows);
    this.paint();
  }

  /** Draw with the one camera, or each part with its own: in one context, with one pass for shadows. */
  private paint(): void {
    if (this.lenses.length === 0) {
      this.aimed(this.camera);
      return this.renderer.render(this.scene, this.camera);
    }
    const [wide, high] = this.renderer.getSize(this.size).toArray();
    this.renderer.setScissorTest(true);
    for (const { camera, left, top, width, height } of this.lenses) {
      // WebGL counts from below.
      const part = [left * wide, (1 - top - height) * high, width * wide, height * high].map(Math.round);
      const [x = 0, y = 0, w = 0, h = 0] = part;
      this.renderer.setViewport(x, y, w, h);
      this.renderer.setScissor(x, y, w, h);
      this.aimed(camera);
      this.renderer.render(this.scene, camera);
    }
  }

  /** Draw the world at its best quality, for a picture that is kept. */
  renderBest(): void {
    this.renderOnce(QUALITIES[0] as Quality);
    this.invalidate();
  }

  /** Draw the world in a quality, and no other frame after it. */
  renderOnce(quality: Quality): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    clearTimeout(this.stillness);
    const usual = this.quality;
    this.apply(quality);
    this.sharpen(Math.max(STILL.sharpness, this.screen), this.quality.shadows);
    this.renderer.shadowMap.needsUpdate = true;
    this.paint();
    this.apply(usual);
  }

  private sharpen(ratio: number, shadows: number): void {
    if (ratio !== this.renderer.getPixelRatio()) this.renderer.setPixelRatio(ratio);
    if (this.light.sharpen(shadows)) this.renderer.shadowMap.needsUpdate = true;
  }

  private apply(quality: Quality): void {
    const { reflections, sharpness } = quality;
    this.quality = quality;
    this.shade();
    this.screen = Math.min(devicePixelRatio, this.fast ? SHARPEST : 1);
    this.ratio = sharpness * this.screen;
    this.scene.environment = reflections ? this.furnish() : null;
  }

  /** Let shadows fall on things, or only on the floor. */
  private shade(): void {
    const { shaded } = this.quality;
    this.scene.traverse((part) => {
      if (part instanceof Mesh && (part.material === PAINT || part.material === COAT)) part.receiveShadow = shaded;
    });
  }

  /** The room that robots reflect. */
  private furnish(): Texture {
    if (this.room) return this.room;
    const generator = new PMREMGenerator(this.renderer);
    this.room = generator.fromScene(new RoomEnvironment(), 0.04).texture;
    generator.dispose();
    return this.room;
  }
}

/** The renderer names of browsers without a graphics card. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** Whether a graphics card draws. */
function drawsFast(): boolean {
  const probe = document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  if (!probe) return false;
  const info = probe.getExtension("WEBGL_debug_renderer_info");
  const renderer = String(probe.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? probe.RENDERER));
  probe.getExtension("WEBGL_lose_context")?.loseContext();
  return !SOFTWARE.test(renderer);
}
