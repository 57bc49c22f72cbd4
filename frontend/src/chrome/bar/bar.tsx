/** The bar: the project, running, and what is run where. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { IconButton } from "../widgets/button";
import { HelpMenu, LanguageMenu, ThemeMenu } from "./menus";
import { usePage } from "../page";
import { ProjectMenu } from "./projectmenu";
import { RobotChoice, SpeedChoice, WorldChoice } from "./choices";
import "./bar.css";

export function Bar() {
  const more = useSignal(false);
  return (
    <header class={more.value ? "bar more-open" : "bar"} data-region="bar" data-tour="bar">
      <h1 class="hidden">LearnBlock</h1>
      <div class="bar-group project-group">
        <ProjectMenu />
        <UndoButtons />
      </div>
      <RunButtons />
      <div class="bar-group choices">
        <SpeedChoice />
        <RobotChoice />
        <WorldChoice />
      </div>
      <div class="bar-group page-group">
        <LanguageMenu />
        <ThemeMenu />
        <HelpMenu />
        <div class="more" data-tour="robot">
          <IconButton icon="more" word="bar.more" pressed={more.value} onClick={() => (more.value = !more.value)} />
        </div>
      </div>
    </header>
  );
}

function UndoButtons() {
  const { program } = usePage().context;
  const { canUndo, canRedo } = program.state.value;
  return (
    <>
      <IconButton icon="undo" word="bar.undo" off={!canUndo} onClick={() => program.undo()} />
      <IconButton icon="redo" word="bar.redo" off={!canRedo} onClick={() => program.redo()} />
    </>
  );
}

function RunButtons() {
  const { context, controls, views } = usePage();
  const { state } = context.running.state.value;
  const active = context.running.active.value;
  const waiting = state === "paused" || state === "held";
  const run = () => {
    controls.run();
    // On a narrow screen the robot would drive unseen.
    views.area.value = "world";
  };
  return (
    <div id="run" class="bar-group run-group" role="group" aria-label={t("bar.running")} data-tour="run">
      <IconButton icon="run" word="bar.run" look="go" named off={active && !waiting} onClick={run} />
      <IconButton icon="stop" word="bar.stop" look="halt" named off={!active} onClick={() => controls.stop()} />
      <IconButton
        icon={waiting ? "resume" : "pause"}
        word={waiting ? "bar.resume" : "bar.pause"}
        off={!active}
        onClick={() => controls.pauseOrResume()}
      />
      <IconButton icon="step" word="bar.step" onClick={() => controls.step(false)} />
      <IconButton icon="stepOver" word="bar.stepOver" onClick={() => controls.step(true)} />
      <IconButton icon="restart" word="bar.restart" onClick={() => controls.restart()} />
    </div>
  );
}
