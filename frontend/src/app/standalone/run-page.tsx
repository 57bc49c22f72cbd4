/** A run to take home: its world, its program with the step that ran, its values, its output, and why. */

import { type ReadonlySignal, type Signal, useSignal, useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";

import { DrawnBlocks } from "../../features/lessons/drawn-blocks";
import type { RobotContent } from "../../features/standalone/content";
import { Why } from "../../features/why/why";
import { t, translated } from "../../i18n";
import { usePage } from "../../model/page";
import { VIEWS } from "../../model/views";
import type { View } from "../../protocol/messages";
import { IconButton } from "../../ui/button";
import { IslandPlace } from "../../ui/island-place";
import { createVariables } from "../../views/output/variables";
import { EyeMenu } from "../world/eye-menu";
import { WorldPlace } from "../world/world-pane";
import { Texts } from "./texts";
import "../layout.css";
import "../../features/lessons/lessons.css";
import "./run-page.css";

interface Props {
  readonly title: string;
  readonly pupil: string;
  readonly robots: readonly RobotContent[];
  /** The one of them that is shown. */
  readonly shown: ReadonlySignal<RobotContent>;
  choose(robot: RobotContent): void;
}

export function RunPage({ title, pupil, robots, shown, choose }: Props) {
  const { context } = usePage();
  const { robot } = shown.value;
  const scene = context.running.scene.value;
  const world = scene ? translated(`page-catalog-world-${scene.name}`, scene.world.title ?? scene.name) : "";
  const kind = translated(`page-catalog-robot-${robot}`, scene?.robots[0]?.[1].title ?? robot);
  return (
    <div class="take-home">
      <header>
        <h1>{title}</h1>
        {pupil && <p>{t("page-take-home-by", { name: pupil })}</p>}
        <p class="dim">{t("page-project-on-in", { robot: kind, world })}</p>
        <p class="dim take-home-made">{t("page-take-home-made")}</p>
      </header>
      {robots.length > 1 && <Robots robots={robots} shown={shown.value} choose={choose} />}
      <main>
        <section class="take-home-world world-pane" aria-label={t("page-shell-world")}>
          <WorldPlace>
            <EyeMenu />
          </WorldPlace>
          <Play />
        </section>
        <ProgramPane robot={shown.value} />
        <Panels robot={shown.value} />
      </main>
    </div>
  );
}

interface RobotsProps extends Pick<Props, "robots" | "choose"> {
  readonly shown: RobotContent;
}

/** Chooses the robot whose program, values and answers are shown. */
function Robots({ robots, shown, choose }: RobotsProps) {
  const { tabs } = usePage();
  return (
    <div class="areas take-home-robots" role="group" aria-label={t("page-tabs-label")}>
      {robots.map((robot) => (
        <button key={robot.name} type="button" aria-pressed={robot === shown} onClick={() => choose(robot)}>
          <span class="robot-color" style={{ background: tabs.colorOf(robot.name) }} />
          {robot.name}
        </button>
      ))}
    </div>
  );
}

/** Plays the run in real time, from the moment that is shown or again from its start. */
function Play() {
  const { context, lookingBack } = usePage();
  const plays = useSignal(false);
  useSignalEffect(() => {
    if (!plays.value) return undefined;
    // Another robot may have ended later.
    const { begin = 0, end = 0 } = context.running.timeline.value ?? {};
    const start = lookingBack.time >= end - 0.05 ? begin : lookingBack.time;
    const began = performance.now();
    let frame = 0;
    const show = () => {
      const time = start + (performance.now() - began) / 1000;
      lookingBack.look(Math.min(time, end));
      if (time >= end) plays.value = false;
      else frame = requestAnimationFrame(show);
    };
    frame = requestAnimationFrame(show);
    return () => cancelAnimationFrame(frame);
  });
  return (
    <div class="take-home-play">
      <IconButton
        icon={plays.value ? "pause" : "run"}
        word={plays.value ? "page-take-home-pause" : "page-take-home-play"}
        look="go"
        named
        onClick={() => (plays.value = !plays.value)}
      />
    </div>
  );
}

interface AreasProps<Name extends string> {
  readonly label: string;
  readonly names: readonly Name[];
  readonly shown: Signal<Name>;
}

/** Buttons that choose which of several areas is shown. */
function Areas<Name extends string>({ label, names, shown }: AreasProps<Name>) {
  return (
    <div class="areas" role="group" aria-label={label}>
      {names.map((name) => (
        <button key={name} type="button" aria-pressed={shown.value === name} onClick={() => (shown.value = name)}>
          {t(`page-shell-${name}`)}
        </button>
      ))}
    </div>
  );
}

/** The program in one of its notations. */
function ProgramPane({ robot }: { robot: RobotContent }) {
  const { context, views } = usePage();
  const view = useSignal<View>("blocks");
  const revealed = useSignal<string | null>(null);
  useEffect(() => follow(views, context, revealed), []);
  const { workspace, blocktext } = context.program.state.value;
  const marked = revealed.value ?? context.running.block.value;
  return (
    <section class="take-home-program" aria-label={t("page-take-home-program")}>
      <Areas label={t("page-shell-shown")} names={VIEWS} shown={view} />
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a keyboard user must be able to scroll it */}
      <div class="take-home-notation" role="group" aria-label={t(`page-shell-${view.value}`)} tabIndex={0}>
        {view.value === "blocks" ? (
          <DrawnBlocks key={robot.name} workspace={workspace} text={blocktext} marked={marked} />
        ) : (
          <Texts notation={view.value} marked={marked} />
        )}
      </div>
    </section>
  );
}

type Parts = ReturnType<typeof usePage>;

/** Mark the blocks that answers name, until another moment is shown. */
function follow(views: Parts["views"], context: Parts["context"], revealed: Signal<string | null>): () => void {
  const dom = document.createElement("div");
  const reveal = (block: string) => (revealed.value = block);
  const describeStep = (block: string) => lineOf(context, block);
  for (const name of VIEWS) views.put(name, { dom, reveal, describeStep, focus: () => {}, destroy: () => {} });
  return context.running.past.subscribe(() => (revealed.value = null));
}

function lineOf({ program }: Parts["context"], block: string): string {
  const { places, blocktext } = program.state.peek();
  const [, line = 0] = places.find(([id]) => id === block) ?? [];
  return (blocktext.split("\n")[line - 1] ?? "").trim();
}

const PANELS = ["why", "variables", "console"] as const;

function Panels({ robot }: { robot: RobotContent }) {
  const { context, askingWhy } = usePage();
  const { printed } = robot;
  const panel = useSignal<(typeof PANELS)[number]>("why");
  useEffect(() => askingWhy.read(), [robot]);
  useSignalEffect(() => {
    // A question that is asked in the world is answered here.
    if (askingWhy.answer.value) panel.value = "why";
  });
  const count = context.running.printed.value ?? printed.length;
  return (
    <section class="take-home-panels" aria-labelledby="take-home-output">
      <h2 id="take-home-output" class="hidden">
        {t("page-shell-panel")}
      </h2>
      <Areas label={t("page-shell-panel")} names={PANELS} shown={panel} />
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a keyboard user must be able to scroll it */}
      <div class="take-home-panel" role="group" aria-label={t(`page-shell-${panel.value}`)} tabIndex={0}>
        {panel.value === "why" && <Why />}
        {panel.value === "variables" && <IslandPlace load={async () => createVariables(context)} />}
        {panel.value === "console" && <pre>{printed.slice(0, count) || t("page-take-home-nothing")}</pre>}
      </div>
    </section>
  );
}
