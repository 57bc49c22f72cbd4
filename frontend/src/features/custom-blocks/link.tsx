import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { Ended } from "../../protocol/messages";

/** A link to the code of the custom block that raised the run's error. */
export function CustomBlockLink({ ended: { custom_block: name, custom_line: line = 0 } }: { ended: Ended }) {
  const { context } = usePage();
  if (!name) return null;
  return (
    <button type="button" class="button bordered" onClick={() => context.editCustomBlock(name, line)}>
      {line ? t("page-problems-open-own-at", { name, line }) : t("page-problems-open-own", { name })}
    </button>
  );
}
