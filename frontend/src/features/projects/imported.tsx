/** What an import of a project of the original LearnBlock changed, and what is missing. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { OriginalImported } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { PhraseList } from "../../ui/phrase-list";

export function ImportedDialog({ report }: { report: OriginalImported }) {
  const { project } = usePage();
  const close = () => {
    project.imported.value = null;
  };
  return (
    <Dialog title={t("page-project-imported-title")} close={close}>
      <p class="dim">{report.filename}</p>
      <PhraseList title={t("page-project-imported-missing")} phrases={report.missing} />
      <PhraseList title={t("page-project-imported-changed")} phrases={report.changed} />
      <button type="button" class="button filled" autofocus onClick={close}>
        {t("page-project-imported-close")}
      </button>
    </Dialog>
  );
}
