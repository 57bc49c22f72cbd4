/** An address as a code to scan. */

import { renderSVG } from "uqr";

import { t } from "../../i18n";

export function QrCode({ address }: { address: string }) {
  return (
    <img
      class="qr-code"
      src={`data:image/svg+xml,${encodeURIComponent(renderSVG(address))}`}
      alt={t("page-device-code")}
    />
  );
}
