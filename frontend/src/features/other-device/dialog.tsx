/** The address of the open project for another device, as a code to scan. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { addressElsewhere } from "../../protocol/address";
import { Dialog } from "../../ui/dialog";
import "./dialog.css";

/** How other devices can reach the server. */
const COMMAND = "learnblock --host 0.0.0.0";

export function OtherDeviceDialog() {
  const { dialogs, project } = usePage();
  const address = addressElsewhere(project.welcome.value?.address ?? null);
  return (
    <Dialog title={t("page-device-heading")} close={() => dialogs.close()}>
      {address ? <Code address={address} /> : <Alone />}
    </Dialog>
  );
}

function Alone() {
  return (
    <>
      <p>{t("page-device-alone")}</p>
      <pre class="command">{COMMAND}</pre>
    </>
  );
}

function Code({ address }: { address: string }) {
  const { toasts } = usePage();
  const picture = useSignal("");
  useEffect(() => {
    void import("uqr").then(({ renderSVG }) => {
      picture.value = `data:image/svg+xml,${encodeURIComponent(renderSVG(address))}`;
    });
  }, [address]);
  const copy = async () => {
    await navigator.clipboard.writeText(address);
    toasts.note(t("page-device-copied"));
  };
  return (
    <div class="other-device">
      <p>{t("page-device-scan")}</p>
      {picture.value && <img src={picture.value} alt={t("page-device-code")} />}
      <label class="field">
        {t("page-device-address")}
        <input readOnly value={address} onFocus={({ currentTarget }) => currentTarget.select()} />
      </label>
      {/* Browsers allow it on this computer and with HTTPS. */}
      {navigator.clipboard && (
        <button type="button" class="button bordered" onClick={() => void copy()}>
          {t("page-device-copy")}
        </button>
      )}
      <p class="dim">{t("page-device-secret")}</p>
    </div>
  );
}
