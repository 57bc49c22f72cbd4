/** What the server knows of a pupil. */

import type { PupilRecord, RecordedAim, RecordedLesson } from "../../protocol/classroom";

/** The record, or why it is not shown. */
export type RecordOrState = PupilRecord | "loading" | "refused" | "lost";

export async function fetchRecord(): Promise<RecordOrState> {
  try {
    const answer = await fetch("record.json");
    if (!answer.ok) return answer.status === 403 ? "refused" : "lost";
    return (await answer.json()) as PupilRecord;
  } catch {
    return "lost";
  }
}

/** The lessons that were begun, in the order in which they were worked on. */
export function lessonsOf({ lessons = [] }: PupilRecord): readonly RecordedLesson[] {
  return lessons;
}

/** An aim and its lesson. */
export interface AimOfLesson {
  readonly lesson: RecordedLesson;
  readonly aim: RecordedAim;
}

/** The aims: those in progress first, and the newest first among equals. */
export function aimsOf(record: PupilRecord): AimOfLesson[] {
  const all = [...lessonsOf(record)].reverse().flatMap((lesson) => (lesson.aims ?? []).map((aim) => ({ lesson, aim })));
  return all.sort((one, other) => Number(one.aim.reached ?? false) - Number(other.aim.reached ?? false));
}
