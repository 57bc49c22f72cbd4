/** What of a record is counted and shown: the dates of a term, and a table of standards. It is kept in the address. */

import { signal } from "@preact/signals";

import { language } from "../../i18n";
import type { PupilRecord, RecordedHandIn, RecordedLesson } from "../../protocol/classroom";

/** Dates as in `2026-09-01`; empty if there is no limit. Both days are counted. */
export interface RecordChoice {
  readonly from: string;
  readonly to: string;
  /** Only references to this table are shown; empty for all. */
  readonly standards: string;
}

/** The choice in the address, and in later addresses. */
export class ChosenRecord {
  readonly now = signal<RecordChoice>(choiceIn(location.search));

  choose(change: Partial<RecordChoice>): void {
    this.now.value = { ...this.now.value, ...change };
    const query = new URLSearchParams(Object.entries(this.now.value).filter(([, value]) => value)).toString();
    history.replaceState(null, "", query ? `?${query}` : location.pathname);
  }
}

/** The choice in an address, which may be anybody's: what is no date there limits nothing. */
export function choiceIn(search: string): RecordChoice {
  const query = new URLSearchParams(search);
  const [from, to] = [query.get("from") ?? "", query.get("to") ?? ""].map((day) => (beginningOf(day) ? day : ""));
  return { from: from!, to: to!, standards: (query.get("standards") ?? "").slice(0, 40) };
}

/** What belongs to the term: lessons that were worked on last in it, or handed in; and what was handed in then. */
export function inTerm(record: PupilRecord, { from, to }: RecordChoice): PupilRecord {
  const first = beginningOf(from)?.getTime() ?? -Infinity;
  const last = beginningOf(to)?.setHours(24) ?? Infinity;
  const isThen = ({ at = 0 }: RecordedLesson | RecordedHandIn) => first <= at * 1000 && at * 1000 < last;
  const lessons = (record.lessons ?? []).map((lesson) => ({
    lesson,
    handIns: (lesson.hand_ins ?? []).filter(isThen),
  }));
  return {
    ...record,
    lessons: lessons
      .filter(({ lesson, handIns }) => handIns.length > 0 || isThen(lesson))
      .map(({ lesson, handIns }) => ({ ...lesson, hand_ins: handIns })),
  };
}

/** The table that a reference such as `CSTA 1B-AP-10` is from. */
export function tableOf(standard: string): string {
  return standard.split(" ")[0] ?? "";
}

/** The tables that the aims refer to. */
export function tablesIn({ lessons = [] }: PupilRecord): readonly string[] {
  const standards = lessons.flatMap(({ aims = [] }) => aims.flatMap((aim) => aim.standards ?? []));
  return [...new Set(standards.map(tableOf))].sort();
}

/** A term in words; empty without one. */
export function termInWords({ from, to }: RecordChoice): string {
  return from || to ? [from, to].map(dayInWords).join(" – ") : "";
}

function dayInWords(day: string): string {
  return beginningOf(day)?.toLocaleDateString(language.value, { dateStyle: "medium" }) ?? "…";
}

/** When a day begins here; null if it is none. */
function beginningOf(day: string): Date | null {
  const [, year, month, date] = /^(\d{4})-(\d\d)-(\d\d)$/.exec(day) ?? [];
  const beginning = new Date(Number(year), Number(month) - 1, Number(date));
  // There is no 31st of June, and no 13th month.
  return beginning.getDate() === Number(date) && beginning.getMonth() === Number(month) - 1 ? beginning : null;
}
