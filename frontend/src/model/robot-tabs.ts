/** The programs of the project: each has a tab, with the robot or the robots that run it. */

import { computed, signal } from "@preact/signals";

import type { Connection } from "../protocol/connection";
import type { Opened, Tab, TabRobot } from "../protocol/messages";
import type { Context } from "./context";
import type { Program } from "./program";

/** The colours of tabs, and of the robots' names in the world; white text can be read on each. */
const COLORS = ["#2563eb", "#c2470a", "#15803d", "#7c3aed", "#c4267f", "#0b7a75", "#b3261e", "#4b5b76"] as const;

/** The server's limit for a project. */
export const MOST_ROBOTS = 30;

/** The states in which a program waits for its user. */
const WAITING: ReadonlySet<TabRobot["state"]> = new Set(["held", "paused", "input"]);

/** Whether robots can't be added, renamed or removed now: a program runs, or can only be read. */
export function areRobotsFixed({ program, running }: Context): boolean {
  return running.active.value || program.readOnly.value !== null;
}

export class RobotTabs {
  /** None if the project has only one robot. */
  readonly tabs = signal<readonly Tab[]>([]);
  /** The name of the tab that is shown; empty if there is only one robot. */
  readonly open = signal("");
  /** The name of the robot that is shown if several run the program of the open tab; else empty. */
  readonly shows = signal("");
  /** How many robots there are. */
  readonly count = computed(() => Math.max(1, sum(this.tabs.value.map(robotsOf))));
  /** Whether the project has as many robots as it can. */
  readonly isFull = computed(() => this.count.value >= MOST_ROBOTS);

  constructor(
    private readonly connection: Connection,
    private readonly program: Program,
  ) {
    connection.on("TabOpened", ({ tab, shows = "" }) => {
      this.open.value = tab;
      this.shows.value = shows;
    });
    connection.on("Tabs", ({ tabs = [], open = "", shows = "" }) => {
      this.tabs.value = tabs;
      this.open.value = open;
      this.shows.value = shows;
      this.goToWaiting();
    });
    // The server did not show another robot, so edits go on with this one.
    connection.onRefused(["AddTab", "CloseTab", "ReopenTab"], () => this.show(this.open.peek()));
  }

  reset({ tab = "" }: Opened): void {
    this.open.value = tab;
  }

  /** Add a new program for some robots of a kind. */
  add(robot: string, count = 1): void {
    this.program.leave();
    this.connection.send({ kind: "AddTab", robot, count });
  }

  /** Let a number of robots run the program of a tab; without a name, the only program. */
  setCount(name: string, count: number): void {
    this.program.flush();
    this.connection.send({ kind: "SetRobotCount", name, count });
  }

  /** Show a tab, and one of its robots if there are several. */
  show(name: string, robot = ""): void {
    this.program.leave();
    this.connection.send({ kind: "OpenTab", name, robot });
  }

  close(name: string): void {
    if (name === this.open.value) this.program.leave();
    this.connection.send({ kind: "CloseTab", name });
  }

  reopen(): void {
    this.program.leave();
    this.connection.send({ kind: "ReopenTab" });
  }

  rename(name: string, to: string): void {
    if (name === to) return;
    this.program.flush();
    this.connection.send({ kind: "RenameTab", name, new: to });
  }

  /** How many robots run the program of a tab. */
  countOf(name: string): number {
    const tab = this.tabs.value.find((one) => one.name === name);
    return tab ? robotsOf(tab) : 1;
  }

  /** The tab that is open; undefined if there is only one robot. */
  get openTab(): Tab | undefined {
    return this.tabs.value.find((tab) => tab.name === this.open.value);
  }

  /** The colour of the tab of a robot, or of a tab. */
  colorOf(name: string): string {
    const isOf = (tab: Tab) => tab.name === name || tab.robots?.some((robot) => robot.name === name);
    const index = this.tabs.value.findIndex(isOf);
    return COLORS[Math.max(0, index) % COLORS.length] ?? COLORS[0];
  }

  /** Show the robot whose program waits for its user, if the one that is shown does not. */
  private goToWaiting(): void {
    const { robots = [] } = this.openTab ?? {};
    const shown = robots.find(({ name }) => name === this.shows.value);
    const waiting = robots.find(({ state }) => state === "held" || state === "input");
    if (shown && waiting && !WAITING.has(shown.state)) this.show(this.open.value, waiting.name);
  }
}

function robotsOf({ robots = [] }: Tab): number {
  return Math.max(1, robots.length);
}

function sum(numbers: readonly number[]): number {
  return numbers.reduce((total, one) => total + one, 0);
}
