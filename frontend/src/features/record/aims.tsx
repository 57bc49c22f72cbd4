/** What the pupil has learned, based on what the programs did: what is in progress comes first. */

import { t } from "../../i18n";
import type { PupilRecord } from "../../protocol/classroom";
import { Icon } from "../../ui/icons";
import { inLanguage } from "../lessons/texts";
import { aimsOf } from "./record";

export function Aims({ record }: { record: PupilRecord }) {
  return (
    <section class="record-card record-aims" aria-labelledby="record-aims">
      <h3 id="record-aims">
        {t("page-record-aims")} <small>{t("page-record-aims-from")}</small>
      </h3>
      <ul>
        {aimsOf(record).map(({ aim, lesson }, index) => {
          const { reached, stars = 0, all_stars = 0, standards = [] } = aim;
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
