/** Dates in the page's language. */

import { language } from "../../i18n";

/** A time in seconds since 1970, in the page's language. */
export function date(seconds: number): string {
  const form = new Intl.DateTimeFormat(language.value, { dateStyle: "medium", timeStyle: "short" });
  return form.format(seconds * 1000);
}
