/** The code that a project brings, to read before it is installed. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { CodeOffered, OfferedCode } from "../../protocol/messages";
import { Actions, Dialog } from "../../ui/dialog";
import "./offered.css";

export function OfferedDialog({ offered }: { offered: CodeOffered }) {
  const { project } = usePage();
  const close = () => {
    project.reviewing.value = false;
  };
  const install = () => {
    close();
    project.installOffered();
  };
  return (
    <Dialog title={t("page-project-offered-title")} close={close} size="large">
      <p>{t("page-project-offered-help")}</p>
      {(offered.blocks ?? []).map((one) => (
        <Code key={one.name} code={one} word="page-project-offered-block" />
      ))}
      {(offered.libraries ?? []).map((one) => (
        <Code key={one.name} code={one} word="page-project-offered-library" />
      ))}
      <Actions cancel={close}>
        <button type="button" class="button filled" onClick={install}>
          {t("page-project-offered-install")}
        </button>
      </Actions>
    </Dialog>
  );
}

function Code({ code: { name, source, replaces }, word }: { code: OfferedCode; word: string }) {
  return (
    <details class="offered">
      <summary>
        {t(word, { name })}
        {replaces && <span class="dim"> · {t("page-project-offered-replaces")}</span>}
      </summary>
      <pre>{source}</pre>
    </details>
  );
}
