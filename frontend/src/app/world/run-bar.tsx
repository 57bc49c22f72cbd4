/** Run, Stop, the buttons of the debugger, the speed, and the switch of the output. */

import { useLessonMove } from "../../features/lessons/narrow";
import { t } from "../../i18n";
import { countProblems } from "../../model/findings";
import { usePage } from "../../model/page";
import { showsDebugger } from "../../model/preferences";
import { IconButton } from "../../ui/button";
import { SpeedSlider } from "./speed-slider";
import "./run-bar.css";

/** On a phone, what a lesson asks to be pressed has the place of the speed, which is there again during a run. */
export function RunBar() {
  const move = useLessonMove();
  return (
    <div class="run-bar">
      <RunButtons />
      {move ? <div class="lesson-move">{move}</div> : <SpeedSlider />}
      <OutputButton />
    </div>
  );
}

export function RunButtons() {
  const { context, controls, lessons } = usePage();
  const active = context.running.active.value;
  const waiting = context.running.waits.value;
  return (
    <div
      id="run"
      class={["run-group", showsDebugger.value && "crowded", lessons.isAsking && "quiet"].filter(Boolean).join(" ")}
      role="group"
      aria-label={t("page-bar-running")}
      data-tour="run"
    >
      <IconButton
        icon="run"
        word="page-bar-run"
        look="go"
        named
        off={active && !waiting}
        onClick={() => controls.run()}
      />
      <IconButton icon="stop" word="page-bar-stop" look="halt" named off={!active} onClick={() => controls.stop()} />
      {showsDebugger.value && <DebugButtons active={active} waiting={waiting} />}
    </div>
  );
}

/** Step begins a run; the others appear once there is one. */
function DebugButtons({ active, waiting }: { active: boolean; waiting: boolean }) {
  const { controls } = usePage();
  return (
    <>
      <IconButton icon="step" word="page-bar-step" onClick={() => controls.step(false)} />
      <IconButton icon="stepOver" word="page-bar-step-over" off={!active} onClick={() => controls.step(true)} />
      <IconButton
        icon={waiting ? "resume" : "pause"}
        word={waiting ? "page-bar-resume" : "page-bar-pause"}
        off={!active}
        onClick={() => controls.pauseOrResume()}
      />
      <IconButton icon="restart" word="page-bar-restart" off={!active} onClick={() => controls.restart()} />
    </>
  );
}

/** Shows and hides the output; while it is hidden, it counts the problems. */
function OutputButton() {
  const { context, views } = usePage();
  const { count } = countProblems(context);
  const shown = views.shows("panel");
  return (
    <div class="output-button">
      <IconButton icon="console" word="page-shell-panel" named pressed={shown} onClick={() => views.togglePanel()} />
      {!shown && count > 0 && (
        <span class="badge" aria-hidden="true">
          {count}
        </span>
      )}
    </div>
  );
}
