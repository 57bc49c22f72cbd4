import { t } from "../../i18n";
import type { Ended } from "../../messages";
import { usePage } from "../page";

/** Where the run went wrong within a block of the user's own, if it did: opens its code there. */
export function OwnBlockLink({ ended: { own_block: name, own_line: line = 0 } }: { ended: Ended }) {
  const { context } = usePage();
  if (!name) return null;
  return (
    <button type="button" class="button bordered" onClick={() => context.editOwnBlock(name, line)}>
      {line ? t("problems.openOwnAt", { name, line }) : t("problems.openOwn", { name })}
    </button>
  );
}
