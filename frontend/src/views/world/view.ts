/** The world's canvas, drawn only while something changes. */

import { Color, DirectionalLight, HemisphereLight, type PerspectiveCamera, Scene, WebGLRenderer } from "three";

/** More pixels are slow and make no visible difference. */
const SHARPEST = 2;

export class View {
  readonly scene = new Scene();
  /** The number of frames drawn, for benchmarks. */
  framesDrawn = 0;
  private readonly renderer: WebGLRenderer;
  private frame = 0;

  /**
   * @param before is called before each frame; true requests another frame.
   * @throws Error if the browser cannot draw in 3D.
   */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly camera: PerspectiveCamera,
    private readonly before: (now: number) => boolean,
  ) {
    const fast = drawsFast();
    // Small pixels need no antialiasing, the slowest part without a graphics card.
    this.renderer = new WebGLRenderer({ canvas, alpha: true, antialias: fast && devicePixelRatio <= 1 });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, fast ? SHARPEST : 1));
    const sun = new DirectionalLight(0xffffff, 1.5);
    sun.position.set(-0.45, -0.6, 1.2);
    this.scene.add(new HemisphereLight(0xffffff, new Color("#b9b4aa"), 1.85), sun);
    canvas.addEventListener("webglcontextrestored", () => this.invalidate());
  }

  /** Redraw with the next frame. */
  invalidate(): void {
    this.frame ||= requestAnimationFrame((now) => this.draw(now));
  }

  resize(width: number, height: number): void {
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    // Now: a resized canvas is empty.
    this.draw(performance.now());
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private draw(now: number): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const again = this.before(now);
    this.renderer.render(this.scene, this.camera);
    this.framesDrawn += 1;
    if (again) this.invalidate();
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
