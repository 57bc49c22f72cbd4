import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { LIMITS } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { NameForm } from "../../ui/name-form";

export function RenameWorldDialog({ name }: { name: string }) {
  const { dialogs, project, worlds } = usePage();
  return (
    <Dialog title={t("page-worlds-rename-title")} close={() => dialogs.close()}>
      <NameForm
        name={project.worldTitle(name)}
        longest={LIMITS.RenameWorld.title}
        help={t("page-worlds-rename-help", { name })}
        action={t("page-worlds-rename-now")}
        close={() => dialogs.close()}
        run={(title) => worlds.rename(name, title)}
      />
    </Dialog>
  );
}
