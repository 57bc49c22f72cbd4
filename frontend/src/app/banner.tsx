import { say, t } from "../i18n";
import { type Page, usePage } from "../model/page";
import type { ConnectionState } from "../protocol/connection";

/** What the banner says of a connection that is not open. */
const WORDS: Readonly<Partial<Record<ConnectionState, string>>> = {
  lost: "page-shell-lost",
  refused: "page-shell-refused",
  crowded: "page-shell-crowded",
};

/** A banner while nothing can be changed here. */
export function ReadOnlyBanner() {
  const reason = usePage().context.program.readOnly.value;
  return (
    <div role="status" class={reason ? "banner calm" : "hidden"}>
      {reason && say(reason)}
    </div>
  );
}

/** What the banner says; null while there is a connection. */
function bannerWords({ classNews, context: { connection, program } }: Page): string | null {
  const words = WORDS[connection.state.value] ?? null;
  const isInClass = classNews.now.value?.role === "pupil";
  if (!isInClass || (words !== WORDS.lost && !classNews.silent.value)) return words;
  return program.saved.value ? "page-class-lost-saved" : "page-class-lost-unsaved";
}

/** A banner while the server cannot be reached; in a class it says whether everything is saved. */
export function ConnectionBanner() {
  const words = bannerWords(usePage());
  return (
    <div role="alert" class={words ? "banner" : "hidden"}>
      {words && t(words)}
    </div>
  );
}
