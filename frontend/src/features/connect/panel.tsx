/** The connection to a robot: its readings, and the tests that it can run. */

import { useId, useRef } from "preact/hooks";

import { say, t } from "../../i18n";
import { usePage } from "../../model/page";
import { prefer } from "../../model/preferences";
import { LIMITS, type RobotValues, type TryRobot } from "../../protocol/messages";
import { Icon, type IconName } from "../../ui/icons";
import { RobotPicture } from "../../ui/robots/picture";
import type { Aside } from "./aside";
import { type Gauge, gauges } from "./gauges";
import { kindTitle } from "./names";

const TESTS: readonly { readonly action: TryRobot["action"]; readonly icon: IconName }[] = [
  { action: "wheels", icon: "move" },
  { action: "face", icon: "show" },
  { action: "lamps", icon: "hint" },
  { action: "beep", icon: "speaker" },
];

/** Before a robot is connected. */
export function Idle() {
  return (
    <div class="connect-idle">
      <Icon name="robot" />
      <p>{t("page-connect-idle")}</p>
    </div>
  );
}

/** While it is being connected, and when that has failed or ended. */
export function Trouble({ show }: { show: (next: Aside) => void }) {
  const { connect, project } = usePage();
  const { state, id = "", robot = "", problem } = connect.state.value;
  const title = kindTitle(project.welcome.value?.robots ?? [], robot);
  return (
    <div class="connect-idle">
      <RobotPicture robot={robot} />
      <p role="status">
        <strong>{t(`page-connect-state-${state}`, { robot: title })}</strong>
      </p>
      {problem && <p class="connect-problem">{say(problem)}</p>}
      {state !== "connecting" && (
        <div class="actions">
          <button type="button" class="button soft" onClick={() => show({ what: "help", robot })}>
            {t("page-connect-help")}
          </button>
          <button type="button" class="button filled" onClick={() => connect.connect(id)}>
            {t("page-connect-again")}
          </button>
        </div>
      )}
    </div>
  );
}

export function Connected({ show }: { show: (next: Aside) => void }) {
  const { connect, dialogs, project } = usePage();
  const { actions = [], corrects = false, robot } = connect.state.value;
  const use = () => {
    connect.use();
    // The start page has no program that could use it, but the next one will.
    if (project.atStart.value) prefer({ robot });
    dialogs.close();
  };
  return (
    <>
      <About />
      <Tests />
      {actions.includes("wheels") && (
        <p class="connect-warning">
          <Icon name="hand" />
          {t("page-connect-warning")}
        </p>
      )}
      <Problem />
      <Gauges />
      <p class="connect-measure">
        {corrects ? (
          <button type="button" class="button soft" onClick={() => show({ what: "calibrate" })}>
            <Icon name="ruler" />
            {t("page-connect-calibrate")}
          </button>
        ) : (
          <span class="dim">{t("page-connect-exact")}</span>
        )}{" "}
        <span role="status" class="connect-yes">
          {connect.corrected.value?.saved && t("page-connect-calibrated")}
        </span>
      </p>
      <div class="connect-use">
        <span class="dim">
          {t("page-connect-stop-works")} <kbd>Esc</kbd>
        </span>
        <button type="button" class="button go" onClick={use}>
          <Icon name="check" />
          {t("page-connect-use")}
        </button>
      </div>
    </>
  );
}

/** The dBm from which a radio is good, and from which it is fair. */
const [GOOD, FAIR] = [-65, -80];

function strengthWord(signal: number): string {
  return signal >= GOOD ? "good" : signal >= FAIR ? "fair" : "poor";
}

/** Picture, name, link and battery. */
function About() {
  const { connect, project } = usePage();
  const field = useId();
  const { robot = "" } = connect.state.value;
  const title = kindTitle(project.welcome.value?.robots ?? [], robot);
  const name = connect.nearby.value?.known?.find((one) => one.robot === robot)?.name ?? "";
  const save = ({ currentTarget: { value } }: { currentTarget: HTMLInputElement }) => {
    if (value.trim() !== name) connect.rename(robot, value);
  };
  return (
    <div class="connect-robot">
      <RobotPicture robot={robot} />
      <div>
        <label for={field} class="hidden">
          {t("page-connect-name", { robot: title })}
        </label>
        <input
          id={field}
          class="connect-name"
          value={name}
          placeholder={title}
          maxLength={LIMITS.NameRobot.name}
          spellcheck={false}
          title={t("page-connect-name", { robot: title })}
          onChange={save}
        />
        {name && <span class="dim">{title}</span>}
        <Link />
      </div>
    </div>
  );
}

function Link() {
  const { values } = usePage().connect;
  const now = values.value;
  if (!now) return <p class="dim">{t("page-connect-reading")}</p>;
  const { weak = false, quality, signal } = now;
  return (
    <>
      <p class={weak ? "connect-weak" : "dim"}>
        <Icon name="wifi" />
        <span class="connect-text">
          {t(weak ? "page-connect-signal-weak" : "page-connect-signal-strong")}
          {lastHeard(now)}
          {typeof quality === "number" && quality < 1 && ` · ${Math.round(quality * 100)} %`}
          {typeof signal === "number" && ` · ${t("page-connect-strength", { strength: strengthWord(signal), signal })}`}
        </span>
      </p>
      <Battery now={now} />
    </>
  );
}

/** How full the battery is, or else its voltage; nothing if the robot reports neither. */
function Battery({ now: { charge, battery } }: { now: RobotValues }) {
  const isKnown = typeof charge === "number";
  const volts = typeof battery === "number" ? battery.toFixed(1) : "";
  if (!isKnown && !volts) return null;
  const percent = isKnown ? Math.round(charge * 100) : 0;
  const words = !isKnown
    ? t("page-link-battery", { volts })
    : volts
      ? t("page-connect-battery", { percent, volts })
      : t("page-connect-full", { percent });
  return (
    <p class={isKnown && charge < 0.2 ? "connect-weak" : "dim"}>
      <Icon name="battery" />
      <span class="connect-text">{words}</span>
    </p>
  );
}

/** How fast it answers; without that, or while it is silent, when it was heard last. */
function lastHeard({ weak, round_trip, silence }: RobotValues): string {
  if (typeof round_trip === "number" && !weak) return ` · ${t("page-connect-answers", { milliseconds: round_trip })}`;
  return typeof silence === "number" ? ` · ${t("page-connect-heard", { milliseconds: silence })}` : "";
}

function Tests() {
  const { connect } = usePage();
  const { actions = [], doing = "" } = connect.state.value;
  /** The test that was pressed last; its button gets the focus back from Stop. */
  const last = useRef("");
  const press = (action: TryRobot["action"]) => {
    last.current = action;
    connect.act(action);
  };
  return (
    <div class="connect-tests">
      {doing ? (
        <StopButton />
      ) : (
        TESTS.filter(({ action }) => actions.includes(action)).map(({ action, icon }) => (
          <button
            key={action}
            ref={(button) => takeFocus(action === last.current ? button : null)}
            type="button"
            class="button bordered"
            onClick={() => press(action)}
          >
            <Icon name={icon} />
            {t(`page-connect-test-${action}`)}
          </button>
        ))
      )}
    </div>
  );
}

/** It takes the focus of the button whose place it takes. */
export function StopButton() {
  const { connect } = usePage();
  return (
    <button ref={takeFocus} type="button" class="button halt" onClick={() => connect.act("stop")}>
      <Icon name="stop" />
      {t("page-connect-stop")}
    </button>
  );
}

/** Focus a button, unless the user has gone elsewhere. */
function takeFocus(button: HTMLButtonElement | null): void {
  const held = document.activeElement;
  if (held === null || held === document.body || held.tagName === "DIALOG") button?.focus();
}

/** What went wrong with the last test. */
function Problem() {
  const { problem } = usePage().connect.state.value;
  return (
    <p role="alert" class="connect-problem">
      {problem && say(problem)}
    </p>
  );
}

function Gauges() {
  const { values } = usePage().connect;
  const shown = values.value ? gauges(values.value) : [];
  return (
    <ul class="connect-gauges" aria-label={t("page-connect-values")}>
      {shown.map((gauge) => (
        <GaugeCard key={gauge.id} gauge={gauge} />
      ))}
    </ul>
  );
}

function GaugeCard({ gauge: { name, text, part, tone } }: { gauge: Gauge }) {
  return (
    <li>
      <span>{name}</span>
      <strong>{text}</strong>
      <span class={`gauge ${tone}`} aria-hidden="true">
        <span style={{ inlineSize: `${Math.round(part * 100)}%` }} />
      </span>
    </li>
  );
}
