/** Which of the server's problems the page shows, and when: warnings wait while a block is being built. */

import type { Block, Problem, View, Workspace } from "../protocol/messages";
import { isStoodIn } from "./robots";

/** A program with its problems. */
export interface Checked {
  readonly workspace: Workspace;
  readonly problems: readonly Problem[];
  readonly origin: View;
}

/** Each block's place, from its stack to itself. */
type Places = ReadonlyMap<string, readonly string[]>;

/** The message about a loop without an end that has nothing inside it, too. */
const IDLE_LOOP = "check-idle-loop";
const UNFINISHED = new Set(["empty-block", "missing-condition"]);

/**
 * Holds back warnings about an unfinished block until the next block is placed elsewhere, or a run is asked for.
 */
export class ShownProblems {
  private before: Checked | null = null;
  /** The unfinished blocks that the user has placed last. */
  private waiting: ReadonlySet<string> = new Set();

  /** Begin with another program: nothing in it has just been placed. */
  reset(): void {
    this.before = null;
    this.waiting = new Set();
  }

  /** The problems to show of a program that has changed. */
  after(now: Checked): readonly Problem[] {
    this.waiting = this.before && now.origin === "blocks" ? this.next(this.before, now) : new Set();
    this.before = now;
    return now.problems.filter((problem) => !this.waits(problem) && !isHeardHere(problem));
  }

  /** Hold back nothing any more; return the problems of the program that was shown last. */
  all(): readonly Problem[] {
    this.waiting = new Set();
    return (this.before?.problems ?? []).filter((problem) => !isHeardHere(problem));
  }

  private next(before: Checked, now: Checked): ReadonlySet<string> {
    const [old, places] = [placesOf(before.workspace), placesOf(now.workspace)];
    const placed = [...places].filter(([id, place]) => place.join(" ") !== old.get(id)?.join(" "));
    const unfinished = unfinishedIn(now);
    if (!placed.length) return new Set([...this.waiting].filter((id) => unfinished.has(id)));
    const known = unfinishedIn(before);
    // A block that waits goes on waiting while others are placed inside it.
    const isFilled = (id: string) => this.waiting.has(id) && placed.every(([, place]) => place.includes(id));
    return new Set([...unfinished].filter((id) => !known.has(id) || isFilled(id)));
  }

  private waits(problem: Problem): boolean {
    return isUnfinished(problem) && this.waiting.has(problem.block ?? "");
  }
}

function unfinishedIn({ problems }: Checked): ReadonlySet<string> {
  return new Set(problems.filter(isUnfinished).flatMap(({ block }) => block ?? []));
}

function isUnfinished({ code, severity, message }: Problem): boolean {
  return severity === "warning" && (UNFINISHED.has(code) || message.code === IDLE_LOOP);
}

/** Whether a problem is only that the robot has no loudspeaker: this computer's takes its place. */
function isHeardHere({ code, severity, message }: Problem): boolean {
  const devices = message.values?.devices;
  if (code !== "missing-device" || severity !== "warning" || !Array.isArray(devices)) return false;
  return devices.every((device) => isStoodIn(String((device as Problem["message"]).values?.kind)));
}

function placesOf({ stacks }: Workspace): Places {
  const places = new Map<string, readonly string[]>();
  for (const stack of stacks) addStack(stack, [], places);
  return places;
}

function addStack(stack: readonly Block[], around: readonly string[], places: Map<string, readonly string[]>): void {
  for (const block of stack) {
    places.set(block.id, [...around, block.id]);
    for (const input of Object.values(block.inputs ?? {})) {
      addStack([...(input.block ? [input.block] : []), ...(input.stack ?? [])], [...around, block.id], places);
    }
  }
}
