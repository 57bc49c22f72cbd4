/** Drives a known way, asks how far it was, and corrects the robot's settings. */

import { type Signal, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { say, t, translated } from "../../i18n";
import { usePage } from "../../model/page";
import type { TryRobot } from "../../protocol/messages";
import { Icon } from "../../ui/icons";
import { StopButton } from "./panel";

/** The drive in mm and the turn in degrees that are measured; see `learnblock.robots.calibration`. */
const DISTANCE = 500;
const ANGLE = 360;

export function Calibrate({ back }: { back: () => void }) {
  const { connect } = usePage();
  const distance = useSignal(String(DISTANCE));
  const angle = useSignal(String(ANGLE));
  const { doing = "", problem } = connect.state.value;
  const measured = [Number(distance.value), Number(angle.value)] as const;
  const isGood = measured.every((one) => Number.isFinite(one) && one > 0);
  // The server computes the new settings whenever a measurement changes.
  useEffect(() => {
    if (isGood) connect.correct(...measured, false);
  }, [distance.value, angle.value]);
  const corrected = connect.corrected.value;
  return (
    <div class="connect-calibrate">
      <h3>{t("page-connect-calibrate")}</h3>
      <p class="dim">{t("page-connect-calibrate-help")}</p>
      <p class="connect-warning">
        <Icon name="hand" />
        {t("page-connect-calibrate-warning")}
      </p>
      {doing && (
        <div class="connect-tests">
          <StopButton />
        </div>
      )}
      <Measure action="distance" value={distance} unit="mm" isBusy={doing !== ""} />
      <Measure action="angle" value={angle} unit="°" isBusy={doing !== ""} />
      <p role="alert" class="connect-problem">
        {problem ? say(problem) : corrected?.problem ? say(corrected.problem) : ""}
      </p>
      <table class="connect-corrections">
        <caption>{t("page-connect-corrections")}</caption>
        <thead>
          <tr>
            <th scope="col">{t("page-connect-setting")}</th>
            <th scope="col">{t("page-connect-before-correction")}</th>
            <th scope="col">{t("page-connect-after-correction")}</th>
          </tr>
        </thead>
        <tbody>
          {corrected?.corrections?.map(({ setting, before, after }) => (
            <tr key={setting}>
              <th scope="row">{translated(`page-robots-setting-${setting.replaceAll("_", "-")}`, setting)}</th>
              <td>{before}</td>
              <td>
                <strong>{after}</strong>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      <div class="actions">
        <button type="button" class="button bordered" onClick={back}>
          {t("page-connect-back")}
        </button>
        <button
          type="button"
          class="button filled"
          disabled={!isGood || !corrected || !!corrected.problem || doing !== ""}
          onClick={() => connect.correct(...measured, true)}
        >
          {t("page-connect-save-correction")}
        </button>
      </div>
    </div>
  );
}

interface MeasureProps {
  readonly action: TryRobot["action"];
  readonly value: Signal<string>;
  readonly unit: string;
  readonly isBusy: boolean;
}

function Measure({ action, value, unit, isBusy }: MeasureProps) {
  const { connect } = usePage();
  return (
    <div class="connect-measured">
      <button type="button" class="button bordered" disabled={isBusy} onClick={() => connect.act(action)}>
        <Icon name={action === "distance" ? "move" : "restart"} />
        {t(`page-connect-drive-${action}`)}
      </button>
      <label>
        {t(`page-connect-measured-${action}`)}
        <span>
          <input
            type="number"
            step="any"
            min={1}
            value={value.value}
            onInput={({ currentTarget }) => (value.value = currentTarget.value)}
          />
          {unit}
        </span>
      </label>
    </div>
  );
}
