/** The run of what was handed in, in its world; it can be looked back at, run again, and asked why. */

import { Goals } from "../features/lessons/goals";
import { Why } from "../features/why/why";
import { t } from "../i18n";
import { usePage } from "../model/page";
import { ToastList } from "./toast-list";
import { EyeMenu } from "./world/eye-menu";
import { RunButtons } from "./world/run-bar";
import { SpeedSlider } from "./world/speed-slider";
import { WorldPlace } from "./world/world-pane";
import "../ui/fonts.css";
import "../ui/theme.css";
import "../ui/controls.css";
import "./layout.css";
import "../features/lessons/lessons.css";
import "./hand-in-run-page.css";

export function HandInRunPage() {
  const { askingWhy } = usePage();
  const hasAsked = (askingWhy.answer.value ?? askingWhy.questions.value) !== null;
  return (
    <main class="hand-in-run">
      <section class="world-pane" aria-label={t("page-shell-world")}>
        <WorldPlace>
          <EyeMenu />
        </WorldPlace>
        <div class="run-bar">
          <RunButtons />
          <SpeedSlider />
        </div>
      </section>
      {hasAsked ? <Why /> : <Goals />}
      <ToastList />
    </main>
  );
}
