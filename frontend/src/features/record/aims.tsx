/** What the pupil has learned, based on what the programs did: what is in progress comes first. */

import { t } from "../../i18n";
import type { PupilRecord } from "../../protocol/classroom";
import { Icon } from "../../ui/icons";
import { inLanguage } from "../lessons/texts";
import { type ChosenRecord, tableOf, tablesIn } from "./choice";
import { aimsOf } from "./record";

interface AimsProps {
  readonly record: PupilRecord;
  readonly chosen: ChosenRecord;
}

export function Aims({ record, chosen }: AimsProps) {
  const table = chosen.now.value.standards;
  return (
    <section class="record-card record-aims" aria-labelledby="record-aims">
      <div class="record-aims-head">
        <h3 id="record-aims">
          {t("page-record-aims")} <small>{t("page-record-aims-from")}</small>
        </h3>
        <Tables record={record} chosen={chosen} />
      </div>
      <ul>
        {aimsOf(record).map(({ aim, lesson }, index) => {
          const { reached, stars = 0, all_stars = 0 } = aim;
          const standards = (aim.standards ?? []).filter((standard) => !table || tableOf(standard) === table);
          return (
            <li key={index} class={reached ? "reached" : "on-the-way"}>
              <Icon name={reached ? "check" : "notBegun"} />
              <div>
                <strong>{inLanguage(aim.say)}</strong>
                <p>
                  {reached
                    ? t("page-record-shown", { lesson: inLanguage(lesson.title) })
                    : t("page-record-on-the-way", { lesson: inLanguage(lesson.title), stars, all: all_stars })}
                </p>
                {standards.length > 0 && (
                  <p class="record-standards">
                    {standards.map((standard) => (
                      <span key={standard}>{standard}</span>
                    ))}
                  </p>
                )}
              </div>
            </li>
          );
        })}
      </ul>
    </section>
  );
}

/** Whose references are shown. A table that no aim refers to now may be in the address. */
function Tables({ record, chosen }: AimsProps) {
  const { standards } = chosen.now.value;
  const tables = tablesIn(record);
  if (tables.length < 2 && !standards) return null;
  return (
    <select
      class="record-tables"
      aria-label={t("page-record-standards")}
      value={standards}
      onChange={({ currentTarget }) => chosen.choose({ standards: currentTarget.value })}
    >
      <option value="">{t("page-record-all-standards")}</option>
      {[...new Set([...tables, ...(standards ? [standards] : [])])].map((table) => (
        <option key={table} value={table}>
          {table}
        </option>
      ))}
    </select>
  );
}
