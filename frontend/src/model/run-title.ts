/** The name of a kept run, or when it was. */

import { language } from "../i18n";
import type { KeptRun } from "../protocol/messages";

export function runTitle({ name, time }: KeptRun, now = new Date()): string {
  if (name) return name;
  const then = new Date(time * 1000);
  const isToday = then.toDateString() === now.toDateString();
  // Two runs are often within the same minute.
  const form = new Intl.DateTimeFormat(language.value, {
    timeStyle: "medium",
    ...(isToday ? {} : { dateStyle: "medium" }),
  });
  return form.format(then);
}
