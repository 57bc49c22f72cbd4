/** The label of the picture: what it shows in words, for screen readers. */

import { t, worldName } from "../../i18n";
import type { Running } from "../../model/running";
import { Throttle } from "../../ui/throttle";
import type { RobotValues } from "./scenery/description";
import { robotInWords } from "./words";

/** ms between two changes of the label, so that screen readers can finish it. */
const PERIOD = 3000;

export class PictureLabel {
  private readonly throttle = new Throttle(PERIOD);

  /** @param title returns the title of the world; nothing without one. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly running: Running,
    private readonly title: () => string | undefined,
  ) {}

  get words(): string {
    const telemetry = this.running.telemetry.peek();
    const robot = telemetry?.robots[0];
    const values = this.running.scene.peek()?.robots[0]?.[1] as RobotValues | undefined;
    const world = this.worldInWords();
    if (!robot || !values) return world;
    return `${world} ${robotInWords(values.title || robot.name, robot, values, telemetry)}`;
  }

  /** Change it at once. */
  write(): void {
    this.canvas.ariaLabel = this.words;
  }

  /** Change it once the last change has been read. */
  update(): void {
    this.throttle.do(() => this.write());
  }

  destroy(): void {
    this.throttle.cancel();
  }

  private worldInWords(): string {
    if (this.running.scene.peek()?.real) return t("page-link-plain-floor");
    const title = this.title();
    return title ? t("page-world-image", { title: worldName(title) }) : t("page-world-image-empty");
  }
}
