/** The island of the world: it connects messages, drawing and the user's actions. */

import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { t } from "../../i18n";
import type { Context } from "../../model/context";
import type { Measure } from "../../model/measures";
import type { MissedPlace } from "../../model/missed";
import { type ThemeName, theme } from "../../model/preferences";
import type { WorldIsland } from "../../model/views";
import type { Scene, Sound, Telemetry } from "../../protocol/messages";
import { Cleanup } from "../../ui/cleanup";
import type { Tool } from "../../ui/tool";
import { WorldAnnouncer } from "./announcer";
import { type CameraMode, Cameras } from "./cameras";
import { FloorDrawing } from "./drawing";
import { type Drawn, drawn } from "./drawn";
import { DrivenWay } from "./driven-way";
import { Effects } from "./effects/effects";
import type { Lens } from "./halves";
import { Hand } from "./hand";
import { HeldKeys } from "./held-keys";
import { worldKeys } from "./keys";
import { MeasureMarks } from "./measure-marks";
import { Missed } from "./missed";
import { Motion } from "./motion";
import { PictureLabel } from "./picture-label";
import { Placing } from "./placing";
import { Players } from "./players";
import { Pointing } from "./pointing";
import { Reactions } from "./reactions";
import { isBlinking } from "./robots/blinking";
import type { XY } from "./scenery/description";
import type { Pose } from "./scenery/geometry";
import { paletteOf } from "./scenery/palette";
import { Stage } from "./stage";
import { View } from "./view";
import { goalInWords, placeInWords } from "./words";

/** The heights of what covers the picture, px: its menus at the top, its timeline and chips at the bottom. */
const OVERLAYS = { top: 56, bottom: 86 };
export class World implements WorldIsland {
  readonly dom = document.createElement("div");
  readonly tools: readonly Tool[];
  readonly hint: ReadonlySignal<string>;
  private readonly frame = document.createElement("div");
  private readonly canvas = document.createElement("canvas");
  private readonly announcer = new WorldAnnouncer();
  private readonly cameras = new Cameras(this.canvas, () => this.view?.invalidate());
  private readonly mode = signal<CameraMode>("follow");
  private readonly players: Players = new Players(this.mode, (mode) => this.followPlayers(mode));
  private readonly view: View = new View(
    this.canvas,
    this.cameras.camera,
    (now) => this.draw(now),
    (camera) => this.stage?.face(camera.position),
  );
  private readonly pointing = new Pointing(this.canvas, this.cameras.camera, () => this.lenses);
  private readonly motion = new Motion();
  private readonly drawing = new FloorDrawing();
  private readonly effects = new Effects();
  private readonly reactions = new Reactions(
    this.effects,
    () => this.stage,
    () => this.cameras.isCalm,
  );
  private readonly way: DrivenWay;
  private readonly marks: MeasureMarks;
  private readonly label: PictureLabel;
  private readonly placing: Placing;
  private readonly held: HeldKeys;
  private readonly hand: Hand;
  private readonly missed = new Missed();
  private stage: Stage | null = null;
  private moved = false;
  private drawnScene = "";
  private worldName = "";

  /** Whether arrow keys place the robot. */
  private readonly places = signal(false);
  private readonly still: ReadonlySignal<boolean>;
  /** Whether there is a run to ask about. */
  private readonly asks: ReadonlySignal<boolean>;
  private readonly cleanup = new Cleanup();
  private readonly sizes = new ResizeObserver(() => this.resize());

  constructor(private readonly context: Context) {
    const { running } = context;
    this.asks = computed(() => context.askingWhy.isPossible);
    const isStill = () => !running.active.value || running.waits.value;
    // A real robot cannot be moved from the page, and the past cannot be changed.
    this.still = computed(() => !running.scene.value?.real && !running.past.value && isStill());
    this.placing = new Placing(this.canvas, this.pointing, {
      robot: () => this.ownRobot(),
      size: () => this.stage?.world.floor.size ?? [0, 0],
      allowed: () => this.still.peek() && this.stage !== null,
      // A click on it asks why.
      refusal: () => (running.past.peek() ? "help" : "not-allowed"),
      placed: (pose) => context.connection.send({ kind: "PlaceRobot", ...pose }),
      changed: () => this.view.invalidate(),
    });
    this.way = new DrivenWay(running, () => this.view.invalidate());
    this.marks = new MeasureMarks(running, () => this.stage);
    this.label = new PictureLabel(this.canvas, running, () => this.stage?.world.title);
    this.held = new HeldKeys(this.frame, context);
    this.hint = computed(() => (this.places.value ? t("page-world-placing") : this.held.hint.value));
    this.hand = new Hand(context);
    this.tools = [...this.createTools(), ...this.hand.tools];
    this.build();
    this.listen();
    this.followRun();
  }

  get framesDrawn(): number {
    return this.view.framesDrawn;
  }

  /** What the picture shows, for tests; null without a world. */
  get drawn(): Drawn | null {
    if (!this.stage) return null;
    const marks = {
      beams: this.stage.beams?.object.visible ?? false,
      bearing: this.marks.bearing.object.visible,
      trail: this.way.visible,
      origin: this.stage.isPointing,
    };
    return drawn(this.stage.subject, this.cameras.camera, marks, this.effects.begun);
  }

  get playerViews() {
    return this.players.views;
  }

  resize(): void {
    this.cameras.size(this.frame.clientWidth, this.frame.clientHeight, OVERLAYS);
    this.players.size(this.frame.clientWidth, this.frame.clientHeight, OVERLAYS);
    this.view.resize(this.frame.clientWidth, this.frame.clientHeight);
  }

  drawBest(): void {
    this.view.renderBest();
  }

  /** Show in the picture where a value comes from. */
  point(measure: Measure | null): void {
    this.marks.point(measure);
    this.way.point(measure === "Driven");
  }

  showMissed(places: readonly MissedPlace[]): void {
    this.missed.show(places);
    this.view.invalidate();
  }

  circle(on: boolean): void {
    this.cameras.circle(on);
    this.view.invalidate();
  }

  lookAt([x, y]: readonly [number, number]): void {
    if (this.players.isSplit) this.look("orbit");
    this.cameras.centre([x, y]);
    this.view.invalidate();
  }

  destroy(): void {
    this.missed.clear();
    this.cleanup.dispose();
    this.sizes.disconnect();
    this.label.destroy();
    this.placing.destroy();
    this.held.destroy();
    this.players.destroy();
    this.hand.destroy();
    this.cameras.dispose();
    this.stage?.dispose();
    this.drawing.clear();
    this.effects.clear();
    this.way.destroy();
    this.marks.bearing.dispose();
    this.view.dispose();
    this.dom.remove();
  }

  private build(): void {
    this.dom.className = "world";
    this.frame.className = "world-view";
    this.frame.role = "application";
    this.frame.tabIndex = 0;
    this.canvas.role = "img";
    this.frame.append(this.canvas);
    this.dom.append(this.frame, this.players.dom, this.announcer.dom);
    this.view.scene.add(
      ...this.way.objects,
      this.marks.bearing.object,
      this.drawing.object,
      this.missed.object,
      this.effects.object,
      this.placing.handle.object,
    );
    this.sizes.observe(this.frame);
  }

  private followRun(): void {
    const { running } = this.context;
    this.watch(
      () => running.telemetry.value,
      (telemetry) => telemetry && this.receive(telemetry),
    );
    this.watch(
      () => running.timeline.value,
      // A fast run passes more places than it reports.
      (timeline) => timeline && !running.past.peek() && this.way.until(Number.POSITIVE_INFINITY),
    );
    this.watch(
      () => running.strokes.value,
      () => this.showDrawing(),
    );
    this.watch(
      () => this.context.ways.value,
      (ways) => this.way.compare(ways),
    );
    this.watch(
      () => this.context.ghost.value,
      (ghost) => {
        this.stage?.showGhost(ghost);
        this.view.invalidate();
      },
    );
    this.watch(
      () => running.state.value.state,
      (state) => state === "starting" && this.restart(),
    );
  }

  private restart(): void {
    this.way.clear();
    this.cameras.restart();
  }

  private listen(): void {
    const { running, connection } = this.context;
    this.watch(
      // The colours of robots change with the tabs.
      () => {
        const scene = running.scene.value;
        return { scene, page: theme.value, colors: scene?.robots.map(([name]) => this.context.robotColor(name)) };
      },
      ({ scene, page }) => scene && this.showScene(scene, page),
    );
    this.watch(
      () => this.still.value,
      (still) => still || this.moves(),
    );
    this.cleanup.add(connection.onRefused(["PlaceRobot"], () => this.placing.forget()));
    this.cleanup.add(connection.on("Sound", (sound) => this.showSound(sound)));
    this.watch(
      () => t("page-world-label"),
      (label) => (this.frame.ariaLabel = label),
    );
    this.watch(
      () => this.places.value,
      (on) => this.placing.select(on),
    );
    this.watch(
      () => running.keys.value.length > 0,
      (listens) => listens && this.announcer.say(this.held.hint.peek()),
    );
    this.watch(
      () => t("page-world-image"),
      () => this.label.write(),
    );
    const keys = worldKeys(this.cameras, this.tools, {
      on: this.places,
      nudge: (...by) => this.nudge(...by),
    });
    this.frame.addEventListener("keydown", keys);
    this.canvas.addEventListener("contextmenu", (event) => this.askAbout(event));
    this.canvas.addEventListener("click", (event) => this.context.running.past.peek() && this.askAbout(event));
    this.canvas.addEventListener("dblclick", (event) => this.centreOn(this.pointing.floor(event)));
    this.canvas.addEventListener("pointerdown", () => this.frame.focus({ preventScroll: true }));
  }

  /** Call a function whenever a value changes, without tracking what the function reads. */
  private watch<T>(read: () => T, listener: (value: T) => void): void {
    this.cleanup.add(
      effect(() => {
        const value = read();
        untracked(() => listener(value));
      }),
    );
  }

  private createTools(): Tool[] {
    const camera = (name: CameraMode, key: string): Tool => ({
      name,
      key,
      pressed: computed(() => this.mode.value === name),
      act: () => this.look(name),
    });
    return [
      camera("follow", "f"),
      camera("top", "t"),
      camera("eye", "e"),
      camera("orbit", "o"),
      {
        name: "split",
        key: "v",
        enabled: computed(() => this.playerViews.value.length > 0),
        act: () => this.nextView(),
      },
      { name: "nearer", key: "+", act: () => this.zoom(0.75) },
      { name: "farther", key: "-", act: () => this.zoom(1 / 0.75) },
      { name: "whole", key: "h", act: () => this.showWhole() },
      { name: "trail", key: "l", pressed: this.way.shown, act: () => this.way.toggle() },
      { name: "beams", key: "b", pressed: this.marks.shown, act: () => this.toggleBeams() },
      { name: "place", key: "p", pressed: this.places, enabled: this.still, act: () => this.togglePlacing() },
      { name: "why", key: "y", enabled: this.asks, act: () => this.context.askingWhy.aboutRobot() },
      { name: "where", key: "w", act: () => this.announcer.say(this.label.words) },
    ];
  }

  /** Ask why the robot does this, if the pointer is on it. */
  private askAbout(event: MouseEvent): void {
    if (!this.asks.peek() || !this.placing.isOnRobot(event)) return;
    event.preventDefault();
    this.context.askingWhy.aboutRobot();
  }

  /** What is drawn side by side; nothing while there is one view, as while the camera circles. */
  private get lenses(): readonly Lens[] {
    return this.cameras.mode === "split" ? this.players.lenses : [];
  }

  /** Begin to follow the robots that have been chosen. */
  private followPlayers(mode: CameraMode): void {
    const robots = this.stage?.robots ?? [];
    this.players.start(robots);
    if (this.stage) this.cameras.start(this.stage.subjectOf(this.players.alone));
    this.look(mode);
  }

  private nextView(): void {
    const view = this.players.next();
    if (view) this.announcer.say(view.text);
  }

  private zoom(factor: number): void {
    if (this.players.isSplit) this.players.zoom(factor);
    else this.cameras.zoom(factor);
    this.view.invalidate();
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

  private showDrawing(): void {
    this.drawing.show(this.context.running.strokes.peek().list);
    this.way.giveWay(!this.drawing.empty);
    this.view.invalidate();
  }

  private toggleBeams(): void {
    this.marks.toggle();
    this.view.invalidate();
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

  private showScene(scene: Scene, page: ThemeName): void {
    const { start, ...lasting } = scene;
    const colors = scene.robots.map(([name]) => this.context.robotColor(name));
    const drawn = JSON.stringify([lasting, colors, page]);
    if (drawn === this.drawnScene) this.stage?.startAt(start);
    else this.build3d(scene, page);
    this.drawnScene = drawn;
    this.label.update();
    this.view.invalidate();
  }

  private build3d(scene: Scene, page: ThemeName): void {
    this.stage?.dispose();
    this.motion.clear();
    this.way.clear();
    this.effects.clear();
    const { robotColor } = this.context;
    const palette = paletteOf(scene.world.theme, page);
    this.stage = new Stage(scene, palette, () => this.view.invalidate(), robotColor);
    this.drawing.on(this.stage.floorColour);
    this.view.scene.add(this.stage.object);
    this.view.surround(this.stage.world.floor.size, palette, this.stage.fog);
    this.view.moveShadows();
    this.cameras.floor(this.stage.world.floor.size);
    // Another robot of a project is in the same world, where the user has chosen a view.
    const isSame = scene.robots.length > 1 && scene.name === this.worldName;
    this.worldName = scene.name;
    this.players.join(scene.robots.map(([name]) => ({ name, color: robotColor(name) })));
    this.cameras.start(this.stage.subjectOf(this.players.alone));
    if (this.players.isSplit && !isSame) this.players.start(this.stage.robots);
    if (!isSame) this.cameras.reset();
    this.mode.value = this.cameras.mode;
    this.marks.show();
  }

  private receive(telemetry: Telemetry): void {
    const [robot] = telemetry.robots;
    if (robot && robot.located !== false) this.way.advance(robot, telemetry.time);
    this.motion.receive(telemetry, performance.now());
    if (robot) this.placing.confirm(robot);
    const news = this.stage?.showGoals(telemetry.goals ?? []) ?? [];
    if (news.some(({ state }) => state === "reached")) this.reactions.celebrate(telemetry.goals ?? [], news);
    this.reactions.feel(telemetry);
    // The page announces reached goals itself.
    const failed = news.filter(({ state }) => state === "failed");
    if (failed.length) this.announcer.say(failed.map(goalInWords).join(" "));
    this.marks.receive(telemetry);
    this.label.update();
    this.view.invalidate();
  }

  private showSound(sound: Sound): void {
    if (this.reactions.hear(sound)) this.view.invalidate();
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
      this.placing.show();
    }
    this.marks.draw();
    const moving = this.motion.moving(now);
    // The last frame of a movement, too.
    if (moving || this.moved || this.placing.pose) this.view.moveShadows();
    this.moved = moving || this.placing.pose !== null;
    const shows = this.effects.step(now);
    // Eyes close only in pictures that are drawn anyway, but never stay closed.
    const blinks = !this.cameras.isCalm && isBlinking(now);
    this.stage?.blink(blinks);
    return this.moveCamera(now) || moving || shows || blinks;
  }

  /** Move the camera with the robots; return whether it is still moving. */
  private moveCamera(now: number): boolean {
    const robots = this.stage?.robots ?? [];
    const seen = this.players.followed(robots.length).flatMap((i) => robots[i] ?? []);
    const [robot] = seen;
    const turning = this.cameras.step(now);
    this.view.divide(this.lenses);
    if (!robot) return turning;
    for (const one of robots) one.object.visible = one !== robot || this.cameras.mode !== "eye";
    this.cameras.look(robot.pose, robot.eye);
    const poses = seen.map(({ pose }) => pose);
    const following = this.cameras.follow(poses, now);
    const apart = this.players.step(robots, now, this.cameras.isCalm);
    return following || apart || turning;
  }
}
