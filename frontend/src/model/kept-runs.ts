/** The kept runs of the project, and the one that the page shows instead of the newest. */

import { computed, effect, signal } from "@preact/signals";

import { say, t } from "../i18n";
import type { Connection } from "../protocol/connection";
import type { CallsBeside, ComparedRun, KeptRun, RunShown, RunsCompared } from "../protocol/messages";
import { sendFile } from "../protocol/send-file";
import type { Toasts } from "../ui/toasts";
import type { LookingBack } from "./looking-back";
import type { Program } from "./program";
import type { Running } from "./running";
import { withEnding } from "./upload";

/** Later than any moment of a run: its end is shown. */
const END = 1_000_000;
/** The server's limit of a file in bytes. */
const LARGEST = 40 * 1024 * 1024;
export const RUN_FILE = ".why";

/** A time in s, and of that time the line of an event. */
type Moment = readonly [time: number, event?: number];

interface Others {
  readonly program: Program;
  readonly running: Running;
  readonly lookingBack: LookingBack;
  readonly toasts: Toasts;
  /** Forgets what was asked about the run that was shown before. */
  readonly forgetQuestions: () => void;
}

/** Of the first and of the second run that are compared: told apart also by those who see few colours. */
export const RUN_COLOURS = ["#0b57d0", "#e8710a"] as const;

/** The way of a run in the world. */
export interface Way {
  /** The time in s, mm east and mm north. */
  readonly points: readonly (readonly [number, number, number])[];
  readonly colour: string;
  /** Where it parted from the other one; null if it never did. */
  readonly parted: readonly [number, number] | null;
}

export class KeptRuns {
  /** The newest first; null until the server has sent them. */
  readonly runs = signal<readonly KeptRun[] | null>(null);
  /** Whether the program is another one than that of the run that is shown. */
  readonly changed = signal(false);
  /** The runs that the user has chosen to compare, at most two. */
  readonly chosen = signal<readonly string[]>([]);
  readonly compared = signal<RunsCompared | null>(null);
  /** The call graphs of the compared runs; null until the server has sent them. */
  readonly beside = signal<CallsBeside | null>(null);
  /** The ways of the compared runs. */
  readonly ways = computed(() => (this.compared.value ? waysOf(this.compared.value) : []));
  /** The moment to show of the run that is being opened. */
  private wanted: Moment = [END];

  constructor(
    private readonly connection: Connection,
    private readonly project: { readonly value: string },
    private readonly others: Others,
  ) {
    connection.on("RunState", ({ state }) => {
      if (state === "starting" || state === "idle") this.compared.value = null;
    });
    connection.on("CallsBeside", (beside) => (this.beside.value = beside));
    connection.on("RunsCompared", (compared) => (this.compared.value = compared));
    connection.on("KeptRuns", ({ runs }) => (this.runs.value = runs));
    connection.on("RunShown", (shown) => this.show(shown));
    this.watchProgram();
  }

  reset(): void {
    this.runs.value = this.compared.value = null;
    this.chosen.value = [];
  }

  list(): void {
    this.connection.send({ kind: "ListRuns" });
  }

  open(run: string): void {
    this.connection.send({ kind: "OpenRun", run });
  }

  /** Show a moment of a run. */
  lookAt(run: string, ...moment: Moment): void {
    if (this.others.running.kept.peek()?.id === run) return this.others.lookingBack.look(...moment);
    this.wanted = moment;
    this.open(run);
  }

  /** Choose a run to compare, or not; of three, the one chosen first is given up. */
  choose(run: string, on: boolean): void {
    const others = this.chosen.value.filter((one) => one !== run);
    this.chosen.value = on ? [...others, run].slice(-2) : others;
  }

  /** Compare the chosen runs, the older one first, and show it. */
  compare(): void {
    const [first, second] = [...this.chosen.value].sort(byAge);
    if (!first || !second) return;
    if (this.others.running.kept.peek()?.id !== first) this.open(first);
    this.connection.send({ kind: "CompareRuns", first, second });
  }

  /** Read what called what in the compared runs. */
  readCalls(): void {
    const compared = this.compared.peek();
    this.beside.value = null;
    if (compared)
      this.connection.send({ kind: "ReadCallsBeside", first: compared.first.id, second: compared.second.id });
  }

  /** Show the newest run again. */
  close(): void {
    this.connection.send({ kind: "CloseRun" });
  }

  name(run: string, name: string): void {
    this.connection.send({ kind: "NameRun", run, name });
  }

  delete(run: string): void {
    if (this.others.running.kept.peek()?.id === run) this.close();
    this.connection.send({ kind: "DeleteRun", run });
  }

  /** The address of a run's file. */
  address(run: string): string {
    return `${this.folder}/${run}${RUN_FILE}`;
  }

  /** Keep a run from another computer, and show it. */
  async import(file: File): Promise<void> {
    const { toasts } = this.others;
    if (withEnding([file], [RUN_FILE]).length === 0) {
      return toasts.error(t("page-runs-wrong-file", { name: file.name, ending: RUN_FILE }));
    }
    if (file.size > LARGEST) return toasts.error(t("page-runs-large-file", { name: file.name }));
    const query = new URLSearchParams({ filename: file.name.slice(-200) });
    const { answer, refusal } = await sendFile<KeptRun>(`${this.folder}?${query}`, file);
    if (refusal) return toasts.error(say(refusal));
    // The connection is lost, which the page says anyway.
    if (!answer) return toasts.error(t("page-runs-not-sent", { name: file.name }));
    this.list();
    this.open(answer.id);
  }

  private get folder(): string {
    return `projects/${encodeURIComponent(this.project.value)}/runs`;
  }

  private show({ run = null, changed = false, remarks = [] }: RunShown): void {
    const { running, lookingBack, forgetQuestions } = this.others;
    forgetQuestions();
    this.changed.value = changed;
    const compared = this.compared.peek();
    if (![compared?.first.id, compared?.second.id].includes(run?.id)) this.compared.value = null;
    running.showKept(run, remarks);
    lookingBack.readTimeline();
    if (run) lookingBack.look(...this.wanted);
    this.wanted = [END];
  }

  /** From the first edit on, the lines of the run that is shown are those of an older program. */
  private watchProgram(): void {
    const { program, running } = this.others;
    let shown: KeptRun | null = null;
    let text = "";
    effect(() => {
      const { blocktext } = program.state.value;
      const run = running.kept.value;
      if (run && run === shown && blocktext !== text) this.changed.value = true;
      shown = run;
      text = blocktext;
    });
  }
}

/** Ids begin with the time. */
function byAge(one: string, other: string): number {
  return one < other ? -1 : 1;
}

function waysOf({ first, second }: RunsCompared): Way[] {
  return [first, second].map((run, index) => ({
    points: run.way ?? [],
    colour: RUN_COLOURS[index] ?? RUN_COLOURS[0],
    parted: placeAt(run),
  }));
}

/** Where a run was when it parted from the other one. */
function placeAt({ way = [], step }: ComparedRun): readonly [number, number] | null {
  if (!step) return null;
  const point = way.find(([time]) => time >= step.time) ?? way.at(-1);
  return point ? [point[1], point[2]] : null;
}
