/** The dialog that shows what programs may do. */

import { useEffect } from "preact/hooks";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import type { AttemptResult } from "../../protocol/messages";
import { Dialog } from "../../ui/dialog";
import { Icon } from "../../ui/icons";
import { isContained } from "./containment";
import "./dialog.css";

export function ContainmentDialog() {
  const { dialogs, containment } = usePage();
  useEffect(() => containment.read(), []);
  const refusal = containment.requests.refusal.value;
  return (
    <Dialog title={t("page-containment-title")} close={() => dialogs.close()} size="large">
      <Findings />
      <NetworkSetting />
      <p role="alert" class="refused">
        {refusal && say(refusal)}
      </p>
    </Dialog>
  );
}

function Findings() {
  const findings = usePage().containment.findings.value;
  if (!findings) return <p role="status">{t("page-containment-trying")}</p>;
  return (
    <>
      {!isContained(findings) && (
        <p class="containment-warning">
          <Icon name="warning" /> {t("page-containment-warning")}
        </p>
      )}
      <p class="dim">{t("page-containment-help")}</p>
      <table class="containment-table">
        <thead>
          <tr>
            <th scope="col">{t("page-containment-attempt")}</th>
            <th scope="col">{t("page-containment-result")}</th>
            <th scope="col">{t("page-containment-reason")}</th>
          </tr>
        </thead>
        <tbody>
          {findings.map((one) => (
            <FindingRow key={one.name.code} one={one} />
          ))}
        </tbody>
      </table>
    </>
  );
}

function FindingRow({ one: { name, contained, reason } }: { one: AttemptResult }) {
  return (
    <tr class={contained ? "contained" : "free"}>
      <th scope="row">{say(name)}</th>
      <td>
        <span class="containment-result">
          <Icon name={contained ? "check" : "warning"} />
          {t(contained ? "page-containment-refused" : "page-containment-allowed")}
        </span>
      </td>
      <td>{say(reason)}</td>
    </tr>
  );
}

function NetworkSetting() {
  const { project, containment } = usePage();
  const network = containment.network.value;
  if (!network) return null;
  const { allowed, key = "", reason } = network;
  return (
    <section aria-labelledby="containment-network">
      <h3 id="containment-network">{t("page-containment-network")}</h3>
      <label class="check">
        <input
          type="checkbox"
          checked={allowed}
          disabled={!key}
          aria-describedby="containment-network-about"
          onChange={({ currentTarget }) => containment.allowNetwork(currentTarget.checked)}
        />
        {t("page-containment-network-allow", { name: project.name.value })}
      </label>
      <p id="containment-network-about" class="dim">
        {reason ? say(reason) : t("page-containment-network-help")}
      </p>
    </section>
  );
}
