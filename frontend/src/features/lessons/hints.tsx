/** The hints that the pupil has asked for; another one is offered, not forced. */

import { useEffect, useRef } from "preact/hooks";
import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Icon } from "../../ui/icons";
import { sayWords } from "./lessons";

export function Hints() {
  const { lessons } = usePage();
  const told = lessons.hints.value;
  const hints = told?.hints ?? [];
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (told) place.current?.lastElementChild?.scrollIntoView({ block: "nearest" });
  }, [told]);
  const offers = lessons.failed.value && hints.length === 0;
  return (
    <div class="lesson-hints" role="status" ref={place}>
      {offers && <p class="lesson-offer">{t("page-lesson-hint-offer")}</p>}
      {hints.map((hint, index) => (
        <div key={index} class="lesson-hint-text">
          <Icon name="hint" />
          <div>
            {hint.levels.map((level, number) => (
              <p key={number}>{sayWords(level)}</p>
            ))}
          </div>
        </div>
      ))}
      {hints.length > 0 && (
        <p class="dim">
          {t("page-lesson-hints-taken", { count: told?.count ?? 0 })}{" "}
          {t(told?.more ? "page-lesson-hints-more" : "page-lesson-hints-all")}
        </p>
      )}
    </div>
  );
}
