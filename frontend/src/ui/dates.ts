/** Dates in the page's language. */

import { language } from "../i18n";

const DAY = 86_400_000;

/** A time in seconds since 1970, in the page's language. */
export function date(seconds: number): string {
  const form = new Intl.DateTimeFormat(language.value, { dateStyle: "medium", timeStyle: "short" });
  return form.format(seconds * 1000);
}

/** The day of a time in seconds since 1970: today, yesterday, or a date. */
export function day(seconds: number, now = new Date()): string {
  const then = new Date(seconds * 1000);
  const days = Math.round((midnight(then) - midnight(now)) / DAY);
  if (days === 0 || days === -1) {
    return new Intl.RelativeTimeFormat(language.value, { numeric: "auto" }).format(days, "day");
  }
  const year = then.getFullYear() === now.getFullYear() ? undefined : "numeric";
  return new Intl.DateTimeFormat(language.value, { day: "numeric", month: "long", year }).format(then);
}

/** The name of a day, such as "Sunday November 29". */
export function weekday(then: Date): string {
  return new Intl.DateTimeFormat(language.value, { weekday: "long", day: "numeric", month: "long" }).format(then);
}

function midnight(time: Date): number {
  return new Date(time.getFullYear(), time.getMonth(), time.getDate()).getTime();
}
