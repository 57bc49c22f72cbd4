/** What the server knows of a pupil. */

import type { PupilRecord } from "../../protocol/classroom";

type RecordedLesson = NonNullable<PupilRecord["lessons"]>[number];

/** The record, or why it is not shown. */
export type Opened = PupilRecord | "loading" | "refused" | "lost";

export async function openRecord(): Promise<Opened> {
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

/** An aim with the lesson that it belongs to. */
export interface AimOfLesson {
  readonly lesson: RecordedLesson;
  readonly aim: NonNullable<RecordedLesson["aims"]>[number];
}

/** The aims: first those on the way, the newest of each kind first. */
export function aimsOf(record: PupilRecord): AimOfLesson[] {
  const all = [...lessonsOf(record)].reverse().flatMap((lesson) => (lesson.aims ?? []).map((aim) => ({ lesson, aim })));
  return all.sort((one, other) => Number(one.aim.reached ?? false) - Number(other.aim.reached ?? false));
}
