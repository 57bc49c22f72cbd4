/** The bar: project, run buttons, robot and world. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { IconButton } from "../../ui/button";
import { RobotChoice, SpeedChoice, WorldChoice } from "./choices";
import { HelpMenu, LanguageMenu, ThemeMenu } from "./menus";
import { ProjectMenu } from "./project-menu";
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
          <IconButton
            icon="more"
            word="page-bar-more"
            pressed={more.value}
            onClick={() => (more.value = !more.value)}
          />
        </div>
      </div>
    </header>
  );
}

function UndoButtons() {
  const { program } = usePage().context;
  const { canUndo, canRedo } = program.state.value;
  const readOnly = program.readOnly.value !== null;
  return (
    <>
      <IconButton icon="undo" word="page-bar-undo" off={readOnly || !canUndo} onClick={() => program.undo()} />
      <IconButton icon="redo" word="page-bar-redo" off={readOnly || !canRedo} onClick={() => program.redo()} />
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
    // A narrow screen would otherwise not show the robot that drives.
    views.area.value = "world";
  };
  return (
    <div id="run" class="bar-group run-group" role="group" aria-label={t("page-bar-running")} data-tour="run">
      <IconButton icon="run" word="page-bar-run" look="go" named off={active && !waiting} onClick={run} />
      <IconButton icon="stop" word="page-bar-stop" look="halt" named off={!active} onClick={() => controls.stop()} />
      <IconButton
        icon={waiting ? "resume" : "pause"}
        word={waiting ? "page-bar-resume" : "page-bar-pause"}
        off={!active}
        onClick={() => controls.pauseOrResume()}
      />
      <IconButton icon="step" word="page-bar-step" onClick={() => controls.step(false)} />
      <IconButton icon="stepOver" word="page-bar-step-over" onClick={() => controls.step(true)} />
      <IconButton icon="restart" word="page-bar-restart" onClick={() => controls.restart()} />
    </div>
  );
}
