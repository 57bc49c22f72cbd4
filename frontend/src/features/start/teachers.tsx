/** What LearnBlock has for teachers. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Dialog } from "../../ui/dialog";
import { Icon, type IconName } from "../../ui/icons";

const TOPICS: readonly (readonly [string, IconName])[] = [
  ["blocks", "blocks"],
  ["notes", "hint"],
  ["lesson", "lesson"],
  ["share", "share"],
  ["class", "globe"],
  ["robots", "robot"],
  ["grade", "check"],
  ["batch", "console"],
];

export function TeachersDialog() {
  const { dialogs } = usePage();
  return (
    <Dialog title={t("page-start-teachers")} close={() => dialogs.close()}>
      <p class="dim">{t("page-start-teachers-help")}</p>
      <ul class="topics">
        {TOPICS.map(([topic, icon]) => (
          <li key={topic}>
            <Icon name={icon} />
            <div>
              <strong>{t(`page-start-teachers-${topic}-title`)}</strong>
              <p>{t(`page-start-teachers-${topic}`)}</p>
              {topic === "grade" && (
                <button type="button" class="button bordered" onClick={() => dialogs.show("grading")}>
                  {t("page-start-teachers-grade-more")}
                </button>
              )}
            </div>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}

/** The command as a teacher types it. */
const COMMAND = "learnblock grade class-7b --lesson 1-03-square --out results";

/** What the command `learnblock grade` does. */
export function GradingDialog() {
  const { dialogs } = usePage();
  return (
    <Dialog title={t("page-start-grade-title")} close={() => dialogs.close()}>
      <p>{t("page-start-grade-begin")}</p>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: a keyboard user must be able to scroll it */}
      <pre class="command" tabIndex={0}>
        {COMMAND}
      </pre>
      <ul>
        {["runs", "results", "again", "final", "more"].map((topic) => (
          <li key={topic}>{t(`page-start-grade-${topic}`)}</li>
        ))}
      </ul>
      <div class="actions">
        <button type="button" class="button bordered" onClick={() => dialogs.show("teachers")}>
          {t("page-start-grade-back")}
        </button>
      </div>
    </Dialog>
  );
}
