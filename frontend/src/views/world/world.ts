/** The island of the world: it connects messages, drawing and the user's actions. */

import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { t, worldName } from "../../i18n";
import type { Context } from "../../model/context";
import type { Robot, Scene, Telemetry } from "../../protocol/messages";
import type { Island } from "../../ui/island";
import { Throttle } from "../../ui/throttle";
import { Announcer } from "./announcer";
import { type CameraMode, Cameras } from "./cameras";
import { worldKeys } from "./keys";
import { Motion } from "./motion";
import { Placing } from "./placing";
import { Pointing } from "./pointing";
import type { RobotValues, XY } from "./scenery/description";
import type { Pose } from "./scenery/geometry";
import { Stage } from "./stage";
import { type Tool, Toolbar } from "./toolbar";
import { Trail } from "./trail";
import { View } from "./view";
import { goalInWords, placeInWords, robotInWords } from "./words";

/** ms between two changes of the picture's label, so that screen readers can finish it. */
const LABEL_PERIOD = 3000;
/** A robot that moves farther than this between two messages was placed, mm. */
const LEAP = 20;

/** The world as a part of the page. */
export interface WorldIsland extends Island {
  /** Adapt to the current size of the element. */
  resize(): void;
  /** The number of frames drawn, for benchmarks. */
  readonly framesDrawn: number;
}

export class World implements WorldIsland {
  readonly dom = document.createElement("div");
  private readonly frame = document.createElement("div");
  private readonly canvas = document.createElement("canvas");
  private readonly hint = document.createElement("p");
  private readonly announcer = new Announcer();
  private readonly cameras = new Cameras(this.canvas, () => this.view?.invalidate());
  private readonly view: View = new View(this.canvas, this.cameras.camera, (now) => this.draw(now));
  private readonly pointing = new Pointing(this.canvas, this.cameras.camera);
  private readonly motion = new Motion();
  private readonly trail = new Trail();
  private readonly placing: Placing;
  private readonly toolbar: Toolbar;
  private stage: Stage | null = null;
  private drawnScene = "";
  private readonly labels = new Throttle(LABEL_PERIOD);

  private readonly mode = signal<CameraMode>("orbit");
  private readonly showsTrail = signal(true);
  private readonly showsBeams = signal(false);
  /** Whether arrow keys place the robot. */
  private readonly places = signal(false);
  private readonly still: ReadonlySignal<boolean>;
  private readonly endings: (() => void)[] = [];
  private readonly sizes = new ResizeObserver(() => this.resize());

  constructor(private readonly context: Context) {
    const { running } = context;
    const rests = () => !running.active.value || ["paused", "held"].includes(running.state.value.state);
    // A real robot cannot be moved from the page.
    this.still = computed(() => !running.scene.value?.real && rests());
    this.placing = new Placing(this.canvas, this.pointing, {
      robot: () => this.ownRobot(),
      size: () => this.stage?.world.floor.size ?? [0, 0],
      allowed: () => this.still.peek() && this.stage !== null,
      placed: (pose) => context.connection.send({ kind: "PlaceRobot", ...pose }),
      changed: () => this.view.invalidate(),
    });
    this.toolbar = new Toolbar(this.tools());
    this.build();
    this.listen();
  }

  get framesDrawn(): number {
    return this.view.framesDrawn;
  }

  resize(): void {
    const bar = this.toolbar.dom.offsetTop + this.toolbar.dom.offsetHeight;
    this.cameras.size(this.frame.clientWidth, this.frame.clientHeight, bar);
    this.view.resize(this.frame.clientWidth, this.frame.clientHeight);
  }

  destroy(): void {
    for (const end of this.endings) end();
    this.sizes.disconnect();
    this.labels.cancel();
    this.placing.destroy();
    this.toolbar.destroy();
    this.cameras.dispose();
    this.stage?.dispose();
    this.view.dispose();
    this.dom.remove();
  }

  private build(): void {
    this.dom.className = "world";
    this.frame.className = "world-view";
    this.frame.role = "application";
    this.frame.tabIndex = 0;
    this.canvas.role = "img";
    this.hint.className = "world-hint";
    this.frame.append(this.canvas);
    this.dom.append(this.frame, this.toolbar.dom, this.hint, this.announcer.dom);
    this.view.scene.add(this.trail.mesh, this.placing.handle.object);
    this.sizes.observe(this.frame);
  }

  private listen(): void {
    const { running, connection } = this.context;
    this.watch(
      () => running.scene.value,
      (scene) => scene && this.showScene(scene),
    );
    this.watch(
      () => running.telemetry.value,
      (telemetry) => telemetry && this.receive(telemetry),
    );
    this.watch(
      () => running.state.value.state,
      (state) => state === "starting" && this.trail.clear(),
    );
    this.watch(
      () => this.still.value,
      (still) => still || this.moves(),
    );
    this.endings.push(connection.on("Failed", () => this.placing.forget()));
    this.watch(
      () => t("page-world-label"),
      (label) => (this.frame.ariaLabel = label),
    );
    this.watch(
      () => this.places.value,
      (on) => this.placing.select(on),
    );
    this.watch(
      () => (this.places.value ? t("page-world-placing") : ""),
      (hint) => this.showHint(hint),
    );
    this.watch(
      () => t("page-world-image"),
      () => (this.canvas.ariaLabel = this.inWords()),
    );
    const keys = worldKeys(this.cameras, this.tools(), { on: this.places, nudge: (...by) => this.nudge(...by) });
    this.frame.addEventListener("keydown", keys);
    this.canvas.addEventListener("dblclick", (event) => this.centreOn(this.pointing.floor(event)));
    this.canvas.addEventListener("pointerdown", () => this.frame.focus({ preventScroll: true }));
  }

  /** Call a function whenever a value changes, without tracking what the function reads. */
  private watch<T>(read: () => T, listener: (value: T) => void): void {
    this.endings.push(
      effect(() => {
        const value = read();
        untracked(() => listener(value));
      }),
    );
  }

  private tools(): Tool[] {
    const camera = (name: CameraMode, key: string): Tool => ({
      name,
      key,
      pressed: computed(() => this.mode.value === name),
      act: () => this.look(name),
    });
    return [
      camera("orbit", "o"),
      camera("follow", "f"),
      camera("top", "t"),
      { name: "nearer", key: "+", act: () => this.cameras.zoom(0.75) },
      { name: "farther", key: "-", act: () => this.cameras.zoom(1 / 0.75) },
      { name: "whole", key: "h", act: () => this.showWhole() },
      { name: "trail", key: "l", pressed: this.showsTrail, act: () => this.toggleTrail() },
      { name: "beams", key: "b", pressed: this.showsBeams, act: () => this.toggleBeams() },
      { name: "place", key: "p", pressed: this.places, enabled: this.still, act: () => this.togglePlacing() },
      { name: "where", key: "w", act: () => this.announcer.say(this.inWords()) },
    ];
  }

  private look(mode: CameraMode): void {
    this.mode.value = mode;
    this.cameras.choose(mode);
  }

  private showWhole(): void {
    this.cameras.showWhole();
    this.mode.value = this.cameras.mode;
  }

  private centreOn(place: XY | null): void {
    if (place) this.cameras.centre(place);
  }

  private toggleTrail(): void {
    this.showsTrail.value = this.trail.mesh.visible = !this.trail.mesh.visible;
    this.view.invalidate();
  }

  private toggleBeams(): void {
    this.showsBeams.value = !this.showsBeams.value;
    this.showBeams();
    this.view.invalidate();
  }

  private showBeams(): void {
    const beams = this.stage?.beams;
    if (!beams) return;
    beams.object.visible = this.showsBeams.peek();
    const telemetry = this.context.running.telemetry.peek();
    if (telemetry) beams.show(telemetry);
  }

  private togglePlacing(): void {
    this.places.value = !this.places.value;
    if (this.places.value) this.frame.focus();
    this.announcer.say(t(this.places.value ? "page-world-placing" : "page-world-placed"));
  }

  private nudge(east: number, north: number, turn: number): void {
    const real = this.context.running.scene.peek()?.real;
    const refusal = real ? "page-link-place-simulated" : "page-world-not-now";
    if (!this.placing.nudge(east, north, turn)) this.announcer.say(t(refusal));
    else if (this.placing.pose) this.announcer.say(placeInWords(this.placing.pose));
  }

  /** The world is running: the robot cannot be placed now. */
  private moves(): void {
    this.places.value = false;
    this.placing.forget();
    this.placing.select(false);
  }

  private showHint(hint: string): void {
    this.hint.hidden = !hint;
    this.hint.textContent = hint;
  }

  private showScene(scene: Scene): void {
    const { start, ...lasting } = scene;
    const drawn = JSON.stringify(lasting);
    if (drawn === this.drawnScene) this.stage?.startAt(start);
    else this.build3d(scene);
    this.drawnScene = drawn;
    this.label();
    this.view.invalidate();
  }

  private build3d(scene: Scene): void {
    this.stage?.dispose();
    this.motion.clear();
    this.trail.clear();
    this.stage = new Stage(scene, () => this.view.invalidate());
    this.view.scene.add(this.stage.object);
    this.cameras.floor(this.stage.world.floor.size);
    this.cameras.reset();
    this.mode.value = this.cameras.mode;
    this.showBeams();
  }

  private receive(telemetry: Telemetry): void {
    const [robot] = telemetry.robots;
    if (robot && robot.located !== false) this.advanceTrail(robot, telemetry.time);
    this.motion.receive(telemetry, performance.now());
    if (robot) this.placing.confirm(robot);
    const news = this.stage?.showGoals(telemetry.goals ?? []) ?? [];
    // The page announces reached goals itself.
    const failed = news.filter(({ state }) => state === "failed");
    if (failed.length) this.announcer.say(failed.map(goalInWords).join(" "));
    if (this.showsBeams.peek()) this.stage?.beams?.show(telemetry);
    this.label();
    this.view.invalidate();
  }

  private lastSeen: { robot: Robot; time: number } | null = null;

  /** A robot that moved without time passing was placed: start a new trail. */
  private advanceTrail(robot: Robot, time: number): void {
    const last = this.lastSeen;
    this.lastSeen = { robot, time };
    const way = last ? Math.hypot(robot.x - last.robot.x, robot.y - last.robot.y) : 0;
    if (last && (time < last.time || (time === last.time && way > LEAP))) this.trail.clear();
    this.trail.extend(robot.x, robot.y);
  }

  /** The user's robot as drawn: where the user drags it, or where telemetry says. */
  private ownRobot(): { pose: Pose; reach: number } | null {
    const model = this.stage?.robots[0];
    if (!model) return null;
    return { pose: this.placing.pose ?? this.motion.newest.robots[0] ?? model.pose, reach: model.reach };
  }

  /** Move everything to its current position; return whether it is still moving. */
  private draw(now: number): boolean {
    const moment = this.motion.at(now);
    const own = moment.robots[0] ?? this.stage?.robots[0]?.pose;
    if (own && this.stage) {
      const carried = this.placing.pose;
      const robots = [carried ? { ...own, ...carried } : own, ...moment.robots.slice(1)];
      this.stage.show({ ...moment, robots });
      this.cameras.follow(own.x, own.y);
      this.placing.show();
    }
    const turning = this.cameras.step(now);
    return turning || this.motion.moving(now);
  }

  private label(): void {
    this.labels.do(() => (this.canvas.ariaLabel = this.inWords()));
  }

  private worldInWords(): string {
    if (this.context.running.scene.peek()?.real) return t("page-link-plain-floor");
    const title = this.stage?.world.title;
    return title ? t("page-world-image", { title: worldName(title) }) : t("page-world-image-empty");
  }

  private inWords(): string {
    const scene = this.context.running.scene.peek();
    const telemetry = this.context.running.telemetry.peek();
    const robot = telemetry?.robots[0];
    const values = scene?.robots[0]?.[1] as RobotValues | undefined;
    const world = this.worldInWords();
    if (!robot || !values) return world;
    return `${world} ${robotInWords(values.title || robot.name, robot, values, telemetry)}`;
  }
}
