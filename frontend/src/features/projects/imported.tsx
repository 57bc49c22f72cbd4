/** What an import of a project of the original LearnBlock changed, and what is missing. */

import { type Phrase, say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { OriginalImported } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";

export function ImportedDialog({ report }: { report: OriginalImported }) {
  const { project } = usePage();
  const close = () => {
    project.imported.value = null;
  };
  return (
    <Dialog title={t("page-project-imported-title")} close={close}>
      <p class="dim">{report.filename}</p>
      <Part title={t("page-project-imported-missing")} phrases={report.missing} />
      <Part title={t("page-project-imported-changed")} phrases={report.changed} />
      <button type="button" class="button filled" autofocus onClick={close}>
        {t("page-project-imported-close")}
      </button>
    </Dialog>
  );
}

function Part({ title, phrases }: { title: string; phrases: readonly Phrase[] }) {
  if (phrases.length === 0) return null;
  return (
    <>
      <h3>{title}</h3>
      <ul>
        {phrases.map((phrase) => (
          <li key={say(phrase)}>{say(phrase)}</li>
        ))}
      </ul>
    </>
  );
}
