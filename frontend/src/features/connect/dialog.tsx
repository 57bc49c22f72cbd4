/** The dialog in which a robot is chosen, or a real one is found, connected and tried. */

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Dialog } from "../../ui/dialog";
import { Icon, type IconName } from "../../ui/icons";
import { RealRobots } from "./real";
import { SimulatedRobots } from "./simulated";
import "./dialog.css";

type Side = "simulated" | "real";

export function ConnectDialog() {
  const { dialogs, connect } = usePage();
  const side = useSignal<Side>("real");
  useEffect(() => {
    connect.begin();
    return () => connect.end();
  }, []);
  // Escape stops a robot that moves; only then does it close the dialog.
  const cancel = () => (connect.isActing.peek() ? connect.act("stop") : dialogs.close());
  return (
    <Dialog
      title={t("page-connect-title")}
      close={() => dialogs.close()}
      cancel={cancel}
      size="large"
      head={<Switch side={side.value} choose={(chosen) => (side.value = chosen)} />}
    >
      <div class="connect">{side.value === "simulated" ? <SimulatedRobots /> : <RealRobots />}</div>
    </Dialog>
  );
}

const SIDES: readonly { readonly name: Side; readonly icon: IconName }[] = [
  { name: "simulated", icon: "simulated" },
  { name: "real", icon: "robot" },
];

function Switch({ side, choose }: { side: Side; choose: (side: Side) => void }) {
  return (
    <fieldset class="connect-switch">
      <legend class="hidden">{t("page-connect-which")}</legend>
      {SIDES.map(({ name, icon }) => (
        <label key={name}>
          <input type="radio" name="connect-side" checked={side === name} onChange={() => choose(name)} />
          <span>
            <Icon name={icon} />
            {t(`page-connect-${name}`)}
          </span>
        </label>
      ))}
    </fieldset>
  );
}
