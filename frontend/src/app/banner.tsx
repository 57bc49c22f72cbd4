import { say, t } from "../i18n";
import { usePage } from "../model/page";
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

/** A banner while the server cannot be reached. */
export function ConnectionBanner() {
  const { connection } = usePage().context;
  const state = connection.state.value;
  const words = WORDS[state];
  return (
    <div role="alert" class={words ? "banner" : "hidden"}>
      {words && t(words)}
    </div>
  );
}
