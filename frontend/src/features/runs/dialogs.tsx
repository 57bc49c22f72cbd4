/** Questions about a kept run. */

import { t } from "../../i18n";
import type { RunDialogName } from "../../model/dialogs";
import { usePage } from "../../model/page";
import { LIMITS } from "../../protocol/messages";
import { Actions, Dialog } from "../../ui/dialog";
import { NameForm } from "../../ui/name-form";

export function RunDialog({ of }: { of: RunDialogName }) {
  return "nameRun" in of ? <NameDialog run={of.nameRun} /> : <DeleteDialog run={of.deleteRun} />;
}

function NameDialog({ run }: { run: string }) {
  const { dialogs, keptRuns } = usePage();
  return (
    <Dialog title={t("page-runs-name")} close={() => dialogs.close()}>
      <NameForm
        name={nameOf(keptRuns.runs.value, run)}
        longest={LIMITS.NameRun.name}
        help={t("page-runs-name-help")}
        action={t("page-runs-name-now")}
        close={() => dialogs.close()}
        run={(name) => keptRuns.name(run, name)}
      />
    </Dialog>
  );
}

function DeleteDialog({ run }: { run: string }) {
  const { dialogs, keptRuns } = usePage();
  const remove = () => {
    dialogs.close();
    keptRuns.delete(run);
  };
  return (
    <Dialog
      title={t("page-runs-delete-named", { name: nameOf(keptRuns.runs.value, run) })}
      close={() => dialogs.close()}
    >
      <p>{t("page-runs-delete-help")}</p>
      <Actions cancel={() => dialogs.close()}>
        <button type="button" class="button filled danger" onClick={remove}>
          {t("page-runs-delete")}
        </button>
      </Actions>
    </Dialog>
  );
}

function nameOf(runs: readonly { readonly id: string; readonly name?: string }[] | null, run: string): string {
  return runs?.find(({ id }) => id === run)?.name ?? "";
}
