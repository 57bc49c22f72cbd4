/** The current run: the state of program and robot, and the settings for the next run. */

import { batch, computed, signal } from "@preact/signals";

import { type Phrase, t } from "../i18n";
import type { Connection } from "../protocol/connection";
import type {
  Bumped,
  Ended,
  KeptRun,
  KeysWanted,
  Opened,
  Past,
  RobotLink,
  RunningLine,
  RunState,
  Scene,
  TabOpened,
  Telemetry,
  Timeline,
  ValueThere,
  Variables,
} from "../protocol/messages";
import { Dialogue } from "./dialogue";
import { addParts, Drawing } from "./drawing";
import { type MissedPlace, missedPlace } from "./missed";
import { Pace, shownSpeed } from "./pace";

const IDLE: RunState = { kind: "RunState", state: "idle" };

/** Seconds of the robot's time for which the world shows that it bumped into something. */
const BUMP_SHOWN = 3;

/** States in which a program waits for the user of the debugger. */
export const PAUSED: ReadonlySet<RunState["state"]> = new Set(["paused", "held"]);

/** The state of a program in words. */
export function stateInWords({ state, held_by = "pause" }: RunState): string {
  return t(state === "held" ? `page-bar-held-${held_by}` : `page-bar-state-${state}`);
}

/** What the page shows of a program and its robot at one time. */
interface Shown {
  readonly telemetry: Telemetry | null;
  readonly variables: Variables | null;
  readonly line: RunningLine | null;
}

/** The run of the open project. */
export class Running {
  readonly state = signal<RunState>(IDLE);
  /** What is shown of the world: the present, or the moment that the user looks back at. */
  readonly telemetry = signal<Telemetry | null>(null);
  /** The world at present, wherever the user looks. */
  readonly measured = signal<Telemetry | null>(null);
  /** What the program says and asks. */
  readonly dialogue: Dialogue;
  private readonly drawing = new Drawing();
  private readonly pace = new Pace();
  private readonly reached = signal<number | null>(null);
  /** How many times as fast as real time the world runs, where the chosen speed does not say it; else null. */
  readonly realSpeed = computed(() => {
    const { state, speed = 1 } = this.state.value;
    return state === "running" ? shownSpeed(this.reached.value, speed) : null;
  });
  /** The link to the robot; null until the server has reported it. */
  readonly link = signal<RobotLink | null>(null);
  readonly line = signal<RunningLine | null>(null);
  readonly variables = signal<Variables | null>(null);
  readonly scene = signal<Scene | null>(null);
  readonly ended = signal<Ended | null>(null);
  private readonly lastBump = signal<Bumped | null>(null);
  /** What the robot has just bumped into; null while the user looks back. */
  readonly bump = computed(() => {
    const [bump, now] = [this.lastBump.value, this.telemetry.value?.time ?? 0];
    return bump && !this.past.value && now - bump.time < BUMP_SHOWN ? bump : null;
  });
  readonly robot = signal("");
  readonly world = signal("");
  /** The keys that the running programs ask for; they use the keyboard if there are any. */
  readonly keys = signal<KeysWanted["keys"]>([]);
  /** How many of the programs ask for keys. */
  readonly listeners = signal(0);
  /** Ids of blocks with a breakpoint. */
  readonly breakpoints = signal<ReadonlySet<string>>(new Set());

  /** The moment of the run that the user looks back at; null for the present. */
  readonly past = signal<Past | null>(null);
  /** The run so far, or the last one; null until the server has told it. */
  readonly timeline = signal<Timeline | null>(null);
  /** The place of the first goal that the run has missed. */
  readonly missed = computed<readonly MissedPlace[]>(() => {
    const missed = this.timeline.value?.missed;
    return missed ? [missedPlace(missed.words, missed.place, missed.nearest)] : [];
  });
  /** The kept run that is shown instead of the newest; null for the newest. */
  readonly kept = signal<KeptRun | null>(null);
  /** What can't be shown of it as it was. */
  readonly remarks = signal<readonly Phrase[]>([]);
  /** The values beside the lines while the program is paused; none while it runs. */
  private readonly pausedValues = signal<readonly ValueThere[]>([]);
  /** The values beside the lines at the moment that is shown. */
  readonly values = computed(() => (this.past.value ? (this.past.value.values ?? []) : this.pausedValues.value));
  /** How many characters had been printed at the moment that is looked back at; null for the present. */
  readonly printed = computed(() => (this.past.value ? (this.past.value.printed ?? 0) : null));
  /** What there is to show at present, while the user looks back. */
  private present: Shown | null = null;

  /** The strokes on the floor at the moment that is shown; the same list until some are erased. */
  readonly strokes = computed(() => {
    void this.drawing.changes.value;
    const past = this.past.value;
    return { list: past?.telemetry ? addParts([], past.drawing?.parts ?? []) : this.drawing.strokes };
  });

  /** Whether a program is running or paused. */
  readonly active = computed(() => !["idle", "ended"].includes(this.state.value.state));
  /** Whether it waits for the user of the debugger. */
  readonly waits = computed(() => PAUSED.has(this.state.value.state));
  /** The block that is running, or at which the program is paused. */
  readonly block = computed(() =>
    this.past.value
      ? (this.past.value.line.block ?? null)
      : this.active.value
        ? (this.state.value.block ?? this.line.value?.block ?? null)
        : null,
  );

  constructor(private readonly connection: Connection) {
    this.dialogue = new Dialogue(connection);
    connection.on("TabOpened", (opened) => this.reset(opened));
    connection.on("Settings", (settings) => {
      this.robot.value = settings.robot;
      this.world.value = settings.world;
      this.breakpoints.value = new Set(settings.breakpoints);
    });
    connection.on("RunState", (state) => {
      // It is idle again once the user has chosen another world.
      if (state.state === "starting" || state.state === "idle") {
        this.forgetPast();
        this.dialogue.reset();
        this.variables.value = this.ended.value = this.line.value = this.lastBump.value = null;
      }
      if (!PAUSED.has(state.state)) this.pausedValues.value = [];
      this.pace.reset();
      this.state.value = state;
    });
    connection.on("ValuesThere", ({ values = [] }) => {
      if (PAUSED.has(this.state.peek().state)) this.pausedValues.value = values;
    });
    connection.on("KeysWanted", ({ keys, programs = 1 }) =>
      batch(() => {
        this.keys.value = keys;
        this.listeners.value = programs;
      }),
    );
    connection.on("Telemetry", (telemetry) => {
      this.reached.value = this.pace.add(telemetry.time, performance.now() / 1000);
      this.show({ telemetry });
    });
    connection.on("Bumped", (bump) => (this.lastBump.value = bump));
    connection.on("Drawing", (news) => this.drawing.receive(news));
    connection.on("RunningLine", (line) => this.show({ line }));
    connection.on("RobotLink", (link) => (this.link.value = link));
    connection.on("Variables", (variables) => this.show({ variables }));
    connection.on("Timeline", (timeline) => (this.timeline.value = timeline));
    connection.on("Past", (past) => this.enterPast(past));
    connection.on("Scene", (scene) =>
      batch(() => {
        // The robot's last place was in another world.
        if (scene.name !== this.scene.value?.name) this.telemetry.value = this.measured.value = null;
        this.scene.value = scene;
      }),
    );
    // A test run of a custom block is not a run of the program.
    connection.on("Ended", (ended) => (this.ended.value = ended.tried ? null : ended));
  }

  /** Forget the last run; begin with the robot, the world and the breakpoints of a project or of a tab. */
  reset({ robot, world, breakpoints }: Opened | TabOpened): void {
    this.forgetPast();
    this.dialogue.reset();
    this.robot.value = robot;
    this.world.value = world;
    this.breakpoints.value = new Set(breakpoints);
    this.state.value = IDLE;
    this.keys.value = [];
    this.variables.value = this.ended.value = this.telemetry.value = this.line.value = this.link.value = null;
    this.measured.value = null;
  }

  /** The way of the robot up to a time of the timeline: mm east and north. */
  wayUntil(time: number): (readonly [number, number])[] {
    const way = this.timeline.peek()?.way ?? [];
    return way.filter(([at]) => at <= time).map(([, x, y]) => [x, y] as const);
  }

  /** Show the past of a kept run, or of the newest one. */
  showKept(run: KeptRun | null, remarks: readonly Phrase[]): void {
    batch(() => {
      this.kept.value = run;
      this.remarks.value = remarks;
      this.timeline.value = null;
      if (!run) this.leavePast();
    });
  }

  /** Show the present again. */
  leavePast(): void {
    if (this.kept.peek()) {
      // The reply is that the newest run is shown.
      this.connection.send({ kind: "CloseRun" });
      return;
    }
    const present = this.present;
    this.past.value = this.present = null;
    if (present) this.show(present);
  }

  private enterPast(past: Past): void {
    this.present ??= { telemetry: this.telemetry.value, variables: this.variables.value, line: this.line.value };
    batch(() => {
      this.past.value = past;
      if (past.telemetry) this.telemetry.value = past.telemetry;
      this.variables.value = past.variables;
      this.line.value = past.line;
    });
  }

  private forgetPast(): void {
    this.past.value = this.timeline.value = this.present = this.kept.value = null;
    this.pausedValues.value = [];
  }

  /** Show what is new at present, unless the user looks back. */
  private show(news: Partial<Shown>): void {
    if (news.telemetry !== undefined) this.measured.value = news.telemetry;
    if (this.present) {
      this.present = { ...this.present, ...news };
      return;
    }
    batch(() => {
      if (news.telemetry !== undefined) this.telemetry.value = news.telemetry;
      if (news.variables !== undefined) this.variables.value = news.variables;
      if (news.line !== undefined) this.line.value = news.line;
    });
  }

  toggleBreakpoint(block: string): void {
    const blocks = new Set(this.breakpoints.value);
    if (!blocks.delete(block)) blocks.add(block);
    this.breakpoints.value = blocks;
    this.connection.send({ kind: "SetBreakpoints", blocks: [...blocks] });
  }
}
