/** Which variant of the world to run in. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Actions, Dialog } from "../../ui/dialog";

/** The server's limit. */
const LAST_VARIANT = 9999;

export function WorldVariantDialog() {
  const { context, controls, dialogs } = usePage();
  const { scene, world } = context.running;
  const number = useSignal(String(scene.value?.variant ?? 0));
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    dialogs.close();
    controls.chooseWorld(world.value, Number(number.value));
  };
  const another = () => (number.value = String(1 + Math.floor(Math.random() * LAST_VARIANT)));
  return (
    <Dialog title={t("page-worlds-variant-title")} close={() => dialogs.close()}>
      <form onSubmit={submit}>
        <label class="field">
          {t("page-worlds-variant-number")}
          <input
            type="number"
            required
            autofocus
            min={0}
            max={LAST_VARIANT}
            value={number.value}
            onFocus={({ currentTarget }) => currentTarget.select()}
            onInput={({ currentTarget }) => (number.value = currentTarget.value)}
          />
        </label>
        <p class="dim">{t("page-worlds-variant-help")}</p>
        <Actions cancel={() => dialogs.close()}>
          <button type="button" class="button bordered" onClick={another}>
            {t("page-worlds-variant-any")}
          </button>
          <button type="submit" class="button filled">
            {t("page-worlds-variant-show")}
          </button>
        </Actions>
      </form>
    </Dialog>
  );
}
