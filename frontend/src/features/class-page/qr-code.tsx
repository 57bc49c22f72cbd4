/** The address of a class as a code to scan, with the word that children then need not type. */

import { renderSVG } from "uqr";

import { t } from "../../i18n";

export function QrCode({ address, word }: { address: string; word: string }) {
  const link = word ? `${address}/?word=${encodeURIComponent(word)}` : `${address}/`;
  return (
    <img
      class="qr-code"
      src={`data:image/svg+xml,${encodeURIComponent(renderSVG(link))}`}
      alt={t("page-device-code")}
    />
  );
}
