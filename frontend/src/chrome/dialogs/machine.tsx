/** Dialogs for what is set of real robots and of perception. */

import { useComputed, useSignal } from "@preact/signals";
import { Fragment } from "preact";
import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { changes, PERCEPTION, valuesOf, type Values } from "../../machine/settings";
import type { SettingsTable } from "../../messages";
import { said } from "../../sentences";
import { usePage } from "../page";
import { Actions, Dialog } from "../widgets/dialog";
import { SettingField } from "./settingfield";
import "./machine.css";

const EMOTIONS = "emotions_on_cameras";

export function RobotSettingsDialog() {
  const { context, dialogs, project } = usePage();
  const real = project.welcome.value?.robots.filter((one) => !one.simulated) ?? [];
  const chosen = real.find((one) => one.name === context.running.robot.peek()) ?? real[0];
  const robot = useSignal(chosen?.name ?? "");
  return (
    <Dialog title={t("machine.robots")} close={() => dialogs.close()}>
      <p class="dim">{t("machine.robotsHelp")}</p>
      <label class="field">
        {t("bar.robot")}
        <select value={robot.value} onChange={({ currentTarget }) => (robot.value = currentTarget.value)}>
          {real.map(({ name, title }) => (
            <option key={name} value={name}>
              {title}
            </option>
          ))}
        </select>
      </label>
      {robot.value && <SettingsForm key={robot.value} robot={robot.value} />}
    </Dialog>
  );
}

export function PerceptionDialog() {
  const { dialogs } = usePage();
  return (
    <Dialog title={t("machine.perception")} close={() => dialogs.close()}>
      <p class="dim">{t("machine.perceptionHelp")}</p>
      <SettingsForm robot={PERCEPTION} />
    </Dialog>
  );
}

function SettingsForm({ robot }: { robot: string }) {
  const { machine } = usePage();
  useEffect(() => machine.read(robot), []);
  const table = useComputed(() => (machine.table.value?.robot === robot ? machine.table.value : null));
  const problem = machine.refusal.value || table.value?.problem;
  return (
    <>
      <p role="alert" class="refused">
        {problem && said(problem)}
      </p>
      {table.value?.settings && <Form table={table.value} robot={robot} />}
    </>
  );
}

function Form({ table, robot }: { table: SettingsTable; robot: string }) {
  const { dialogs, machine } = usePage();
  const { settings = [], wrong = {} } = table;
  const values = useSignal<Values>(valuesOf(settings));
  const agreed = useSignal(false);
  // What was saved may be told in other words: a video by its whole path.
  useEffect(() => {
    if (Object.keys(wrong).length === 0) values.value = valuesOf(settings);
  }, [table]);
  const changed = changes(settings, values.value);
  const asks = changed[EMOTIONS] === true;
  const save = (event: SubmitEvent) => {
    event.preventDefault();
    machine.change(robot, changed, agreed.value);
  };
  const isChanged = Object.keys(changed).length > 0;
  return (
    <form onSubmit={save} noValidate>
      {settings.map((setting) => (
        <Fragment key={setting.name}>
          <SettingField
            setting={setting}
            value={values.value[setting.name]}
            wrong={setting.name in changed ? wrong[setting.name] : undefined}
            change={(value) => (values.value = { ...values.value, [setting.name]: value })}
          />
          {setting.name === EMOTIONS && <Law asks={asks} agreed={agreed.value} agree={(on) => (agreed.value = on)} />}
        </Fragment>
      ))}
      <p role="status" class="dim">
        {t(isChanged ? "machine.unsaved" : "machine.saved")}
      </p>
      <Actions cancel={() => dialogs.close()}>
        <button type="submit" class="button filled" disabled={!isChanged || (asks && !agreed.value)}>
          {t("machine.save")}
        </button>
      </Actions>
    </form>
  );
}

interface LawProps {
  /** Whether recognition of emotions on real cameras is about to be switched on. */
  readonly asks: boolean;
  readonly agreed: boolean;
  readonly agree: (on: boolean) => void;
}

/** Why emotions are not recognised on real cameras. */
function Law({ asks, agreed, agree }: LawProps) {
  return (
    <section class="law" aria-label={t("machine.law")}>
      <h3>{t("machine.law")}</h3>
      <p>{t("machine.lawText")}</p>
      <p>{t("machine.lawPictures")}</p>
      {asks && (
        <label class="check">
          <input type="checkbox" checked={agreed} onChange={({ currentTarget }) => agree(currentTarget.checked)} />
          {t("machine.agree")}
        </label>
      )}
    </section>
  );
}
