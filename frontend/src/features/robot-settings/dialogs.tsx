/** The dialogs for robot settings and camera recognition. */

import { useComputed, useSignal } from "@preact/signals";
import { type ComponentChildren, Fragment } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { plainTitle, realOf } from "../../model/robots";
import type { SettingsTable } from "../../protocol/messages";
import { Actions, Dialog } from "../../ui/dialog";
import { SettingField } from "./field";
import { changes, PERCEPTION, type Values, valuesOf } from "./robot-settings";
import { TestConnection } from "./test-connection";
import "./dialogs.css";

const EMOTIONS = "emotions_on_cameras";

export function RobotSettingsDialog() {
  const { context, dialogs, project } = usePage();
  const real = project.welcome.value?.robots.filter((one) => !one.simulated) ?? [];
  const chosen = realOf(context.running.robot.peek(), real) ?? real[0];
  const robot = useSignal(chosen?.name ?? "");
  const shown = real.find((one) => one.name === robot.value);
  return (
    <Dialog title={t("page-robots-robots")} close={() => dialogs.close()}>
      <p class="dim">{t("page-robots-robots-help")}</p>
      <label class="field">
        {t("page-bar-robot")}
        <select value={robot.value} onChange={({ currentTarget }) => (robot.value = currentTarget.value)}>
          {real.map((one) => (
            <option key={one.name} value={one.name}>
              {plainTitle(one)}
            </option>
          ))}
        </select>
      </label>
      {shown && (
        <SettingsForm key={shown.name} robot={shown.name} cancel={() => dialogs.close()}>
          {(isSaved) => <TestConnection robot={shown.name} title={plainTitle(shown)} isSaved={isSaved} />}
        </SettingsForm>
      )}
    </Dialog>
  );
}

export function PerceptionDialog() {
  const { dialogs } = usePage();
  return (
    <Dialog title={t("page-robots-perception")} close={() => dialogs.close()}>
      <p class="dim">{t("page-robots-perception-help")}</p>
      <SettingsForm robot={PERCEPTION} cancel={() => dialogs.close()} />
    </Dialog>
  );
}

interface SettingsFormProps {
  readonly robot: string;
  readonly cancel: () => void;
  /** What the button does once the settings are saved, such as to connect; by default it only saves. */
  readonly next?: { readonly word: string; readonly savingWord: string; readonly go: () => void };
  /** Below the settings; told whether they are saved as they are shown. */
  readonly children?: (isSaved: boolean) => ComponentChildren;
}

export function SettingsForm({ robot, cancel, next, children }: SettingsFormProps) {
  const machine = usePage().robotSettings;
  // Before the form of an older answer is shown.
  useLayoutEffect(() => machine.read(robot), []);
  const table = useComputed(() => (machine.table.value?.robot === robot ? machine.table.value : null));
  const problem = machine.requests.refusal.value || table.value?.problem;
  return (
    <>
      <p role="alert" class="refused">
        {problem && say(problem)}
      </p>
      {table.value?.settings && (
        <Form table={table.value} robot={robot} cancel={cancel} next={next} children={children} />
      )}
    </>
  );
}

function Form({ table, robot, cancel, next, children }: SettingsFormProps & { readonly table: SettingsTable }) {
  const machine = usePage().robotSettings;
  const { settings = [], wrong = {} } = table;
  const values = useSignal<Values>(valuesOf(settings));
  const agreed = useSignal(false);
  const saves = useSignal(false);
  const goes = useRef(false);
  // The server may change a saved value, such as a video's path into an absolute one. Before the
  // browser shows the answer, so that nothing is lost that a user has typed into it.
  useLayoutEffect(() => {
    if (Object.keys(wrong).length > 0) {
      goes.current = false;
      return;
    }
    values.value = valuesOf(settings);
    if (goes.current) next?.go();
    goes.current = false;
  }, [table]);
  const changed = changes(settings, values.value);
  const asks = changed[EMOTIONS] === true;
  const save = (event: SubmitEvent) => {
    event.preventDefault();
    if (next && !isChanged) {
      next.go();
      return;
    }
    saves.value = true;
    goes.current = next !== undefined;
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
      {children?.(!isChanged)}
      <p role="status" class="dim">
        {isChanged ? t("page-robots-unsaved") : saves.value && t("page-robots-saved")}
      </p>
      <Actions cancel={cancel}>
        <button type="submit" class="button filled" disabled={!(isChanged || next) || (asks && !agreed.value)}>
          {t(next ? (isChanged ? next.savingWord : next.word) : "page-robots-save")}
        </button>
      </Actions>
    </form>
  );
}

interface LawProps {
  /** Whether the user is switching on emotion recognition for real cameras. */
  readonly asks: boolean;
  readonly agreed: boolean;
  readonly agree: (on: boolean) => void;
}

/** The reason why emotion recognition is off for real cameras. */
function Law({ asks, agreed, agree }: LawProps) {
  return (
    <section class="law" aria-label={t("page-robots-law")}>
      <h3>{t("page-robots-law")}</h3>
      <p>{t("page-robots-law-text")}</p>
      <p>{t("page-robots-law-pictures")}</p>
      {asks && (
        <label class="check">
          <input type="checkbox" checked={agreed} onChange={({ currentTarget }) => agree(currentTarget.checked)} />
          {t("page-robots-agree")}
        </label>
      )}
    </section>
  );
}
