/** Asks for a link that holds a project. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { LIMITS } from "../../protocol/messages";
import { Actions, Dialog } from "../../ui/dialog";

export function OpenLinkDialog() {
  const { dialogs, links } = usePage();
  const link = useSignal("");
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    dialogs.close();
    links.open(link.value);
  };
  return (
    <Dialog title={t("page-share-open-title")} close={() => dialogs.close()}>
      <form onSubmit={submit}>
        <label class="field">
          {t("page-share-link")}
          <input
            required
            autofocus
            maxLength={LIMITS.OpenLink.link}
            value={link.value}
            onInput={({ currentTarget }) => (link.value = currentTarget.value)}
          />
        </label>
        <p class="dim">{t("page-share-open-help")}</p>
        <Actions cancel={() => dialogs.close()}>
          <button type="submit" class="button filled">
            {t("page-share-open-now")}
          </button>
        </Actions>
      </form>
    </Dialog>
  );
}
