/** What helps teachers before and after a lesson. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Dialog } from "../../ui/dialog";
import { Icon, type IconName } from "../../ui/icons";

const TOPICS: readonly (readonly [string, IconName])[] = [
  ["blocks", "blocks"],
  ["notes", "hint"],
  ["lesson", "lesson"],
  ["share", "share"],
  ["robots", "robot"],
  ["grade", "check"],
  ["batch", "console"],
];

export function Topics() {
  const { dialogs } = usePage();
  return (
    <section aria-labelledby="teachers-topics">
      <h2 id="teachers-topics">{t("page-teachers-topics")}</h2>
      <ul class="topics">
        {TOPICS.map(([topic, icon]) => (
          <li key={topic} class="start-card">
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
    </section>
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
        <button type="button" class="button bordered" onClick={() => dialogs.close()}>
          {t("page-start-grade-back")}
        </button>
      </div>
    </Dialog>
  );
}
