/** The real robots: on the left those near this computer, on the right what to do with one. */

import { useSignal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";

import { say, t, translated } from "../../i18n";
import type { Listed } from "../../model/connect";
import { usePage } from "../../model/page";
import { OTHER_SIMULATORS } from "../../model/robots";
import type { AddOn } from "../../protocol/messages";
import { Icon, type IconName } from "../../ui/icons";
import { RobotPicture } from "../../ui/robots/picture";
import { SettingsForm } from "../robot-settings/dialogs";
import { type Aside, ROBOT } from "./aside";
import { Calibrate } from "./calibrate";
import { HelpMe } from "./help-me";
import { kindTitle, titleOf } from "./names";
import { Connected, Idle, Trouble } from "./panel";

export function RealRobots() {
  const { connect } = usePage();
  const aside = useSignal<Aside>(ROBOT);
  // Who has been helped with a robot means that one, wherever they go on.
  const meant = useSignal("");
  const show = (next: Aside) => {
    if ("robot" in next) meant.value = next.robot;
    aside.value = next;
  };
  const state = connect.state.value.state;
  // A new connection is what the user wants to see.
  useEffect(() => {
    if (state === "connecting") show(ROBOT);
  }, [state]);
  return (
    <div class={state === "none" && aside.value === ROBOT ? "connect-real idle" : "connect-real"}>
      <Robots meant={meant.value} show={show} />
      <div class="connect-panel">
        <Panel aside={aside.value} show={show} />
      </div>
    </div>
  );
}

function Panel({ aside, show }: { aside: Aside; show: (next: Aside) => void }) {
  const { connect } = usePage();
  const back = () => show(ROBOT);
  if (aside.what === "help") return <HelpMe key={aside.robot} robot={aside.robot} show={show} />;
  if (aside.what === "address") return <Address robot={aside.robot} back={back} />;
  const { state } = connect.state.value;
  if (state === "none") return <Idle />;
  if (state !== "connected") return <Trouble show={show} />;
  if (aside.what === "calibrate") return <Calibrate back={back} />;
  return <Connected show={show} />;
}

function Robots({ meant, show }: { meant: string; show: (next: Aside) => void }) {
  const { connect } = usePage();
  const { found, before, others } = connect.lists.value;
  const real = others.filter((one) => !OTHER_SIMULATORS.has(one.robot));
  const first = meant || connect.state.value.robot || before[0]?.robot || real[0]?.robot || "cozmo";
  return (
    <div class="connect-list">
      <p class="connect-count" role="status">
        <Icon name="refresh" />
        {t("page-connect-found", { count: found.length })}
      </p>
      <p role="alert" class="refused">
        <Refusal />
      </p>
      <ul>
        {found.map((one) => (
          <Found key={one.id} robot={one} />
        ))}
      </ul>
      <Away title={t("page-connect-before")} robots={before} show={show} />
      <Away title={t("page-connect-others")} robots={real} show={show} />
      <p class="connect-foot">
        <span>
          <Icon name="help" />
          {t("page-connect-hint")}
        </span>
        <button type="button" class="connect-link" onClick={() => show({ what: "address", robot: first })}>
          {t("page-connect-address")}
        </button>
      </p>
    </div>
  );
}

function Refusal() {
  const { refusal } = usePage().connect.requests;
  return <>{refusal.value && say(refusal.value)}</>;
}

const WAYS: Readonly<Record<string, IconName>> = {
  wifi: "wifi",
  usb: "usb",
  bluetooth: "bluetooth",
  computer: "simulated",
};

function Found({ robot }: { robot: Listed }) {
  const { connect } = usePage();
  const { state, id } = connect.state.value;
  const isMine = id === robot.id && (state === "connected" || state === "connecting");
  const isConnected = isMine && state === "connected";
  const isOthers = robot.isBusy && !isMine;
  const title = useTitle(robot);
  return (
    <li class={isConnected ? "connected" : ""} aria-label={title}>
      <RobotPicture robot={robot.robot} />
      <div class="connect-about">
        <strong>{title}</strong>
        <span class="dim">{isConnected ? <Battery /> : isOthers ? t("page-connect-busy") : <Way robot={robot} />}</span>
      </div>
      {isMine ? (
        <button type="button" class="button bordered" onClick={() => connect.disconnect()}>
          {t(isConnected ? "page-connect-disconnect" : "page-shell-cancel")}
        </button>
      ) : (
        <button
          type="button"
          class="button filled"
          aria-label={t("page-connect-connect-named", { robot: title })}
          disabled={isOthers}
          onClick={() => connect.connect(robot.id)}
        >
          {t("page-connect-connect")}
        </button>
      )}
    </li>
  );
}

/** Its own name, or its kind; the place tells two robots of a kind apart. */
function useTitle(robot: Listed): string {
  const { project } = usePage();
  return titleOf(project.welcome.value?.robots ?? [], robot);
}

function Way({ robot: { robot, name, found } }: { robot: Listed }) {
  const { project } = usePage();
  const kind = name ? `${kindTitle(project.welcome.value?.robots ?? [], robot)} · ` : "";
  if (!found) return null;
  return (
    <>
      <Icon name={WAYS[found.way] ?? "wifi"} />
      <span class="connect-text">
        {kind}
        {t(`page-connect-way-${found.way}`)}
        {found.place && ` · ${found.place}`}
      </span>
    </>
  );
}

function Battery() {
  const { values } = usePage().connect;
  const charge = values.value?.charge;
  return (
    <>
      <span class="connect-yes">
        <Icon name="check" />
        {t("page-connect-connected")}
      </span>
      {typeof charge === "number" && (
        <span>
          <Icon name="battery" />
          {t("page-connect-charge", { percent: Math.round(charge * 100) })}
        </span>
      )}
    </>
  );
}

interface AwayProps {
  readonly title: string;
  readonly robots: readonly Listed[];
  readonly show: (next: Aside) => void;
}

function Away({ title, robots, show }: AwayProps) {
  if (robots.length === 0) return null;
  return (
    <section aria-label={title}>
      <h3>{title}</h3>
      <ul class="away">
        {robots.map((one) => (
          <AwayRobot key={one.robot} robot={one} show={show} />
        ))}
      </ul>
    </section>
  );
}

/** The word for why a robot is not there: without its add-on, nothing can find it. */
function state({ isBusy, addOn, isLooking }: Listed): string {
  if (addOn) return addOn.installing ? "page-connect-installing" : "page-connect-needs-add-on";
  if (isBusy) return "page-connect-busy";
  return isLooking ? "page-connect-looking" : "page-connect-away";
}

function AwayRobot({ robot, show }: { robot: Listed; show: (next: Aside) => void }) {
  const title = useTitle(robot);
  const help = useRef<HTMLButtonElement>(null);
  const hadButton = useRef(false);
  const hasButton = robot.addOn?.ours ?? false;
  // An add-on that is installed takes its button away, and the focus with it.
  useLayoutEffect(() => {
    if (hadButton.current && !hasButton && document.activeElement === document.body) help.current?.focus();
    hadButton.current = hasButton;
  }, [hasButton]);
  return (
    <li aria-label={title}>
      <RobotPicture robot={robot.robot} />
      <div class="connect-about">
        <strong>{title}</strong>
        <span class="dim">{t(state(robot))}</span>
        {robot.addOn && <Licence robot={robot.robot} />}
        {robot.addOn && <AddOnText addOn={robot.addOn} />}
        {robot.addOn?.ours && <InstallButton robot={robot.robot} title={title} addOn={robot.addOn} />}
      </div>
      <button
        ref={help}
        type="button"
        class="button soft"
        aria-label={t("page-connect-help-named", { robot: title })}
        onClick={() => show({ what: "help", robot: robot.robot })}
      >
        {t("page-connect-help")}
      </button>
    </li>
  );
}

/** What may not be done with an add-on whose licence is not free. */
function Licence({ robot }: { robot: string }) {
  const words = translated(`page-connect-licence-${robot}`, "");
  return words ? <span class="dim">{words}</span> : null;
}

/** What the installer says, or how to install it in a terminal. */
function AddOnText({ addOn: { command, ours, installing, progress, problem } }: { addOn: AddOn }) {
  if (installing)
    return (
      <span role="status" class="connect-progress">
        {progress}
      </span>
    );
  return (
    <>
      {problem && (
        <span role="alert" class="connect-problem">
          {say(problem)}
        </span>
      )}
      {(problem || !ours) && (
        <>
          <span class="dim">{t("page-connect-install-terminal")}</span>
          <code class="connect-command">{command}</code>
        </>
      )}
    </>
  );
}

/** One button for both, so that the focus stays on it. */
function InstallButton({ robot, title, addOn }: { robot: string; title: string; addOn: AddOn }) {
  const { connect } = usePage();
  const isInstalling = addOn.installing ?? false;
  return (
    <button
      type="button"
      class={isInstalling ? "button halt" : "button filled"}
      aria-label={isInstalling ? undefined : t("page-connect-install-named", { robot: title })}
      onClick={() => connect.install(robot, !isInstalling)}
    >
      {t(isInstalling ? "page-connect-install-stop" : "page-connect-install")}
    </button>
  );
}

function Address({ robot, back }: { robot: string; back: () => void }) {
  const { project } = usePage();
  const chosen = useSignal(robot);
  const { connect } = usePage();
  const robots = project.welcome.value?.robots ?? [];
  return (
    <div class="connect-address">
      <h3>{t("page-connect-address")}</h3>
      <p class="dim">{t("page-connect-address-help")}</p>
      <label class="field">
        {t("page-bar-robot")}
        <select value={chosen.value} onChange={({ currentTarget }) => (chosen.value = currentTarget.value)}>
          {connect.nearby.value?.known?.map((one) => (
            <option key={one.robot} value={one.robot}>
              {kindTitle(robots, one.robot)}
            </option>
          ))}
        </select>
      </label>
      <SettingsForm
        key={chosen.value}
        robot={chosen.value}
        cancel={back}
        next={{
          word: "page-connect-connect",
          savingWord: "page-connect-save-connect",
          go: () => connect.connect(chosen.value),
        }}
      />
    </div>
  );
}
