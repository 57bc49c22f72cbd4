/** In a class: shows the project to the teacher, or a copy of it to a classmate. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { Tile } from "./tile";

/** @param link of the project; empty if it is too large for one, or not made yet. */
export function InClass({ link }: { link: string }) {
  const { classNews, dialogs, lessons, shownPrograms } = usePage();
  const news = classNews.now.value;
  if (news?.role !== "pupil") return null;
  const isLesson = lessons.shown.value !== null;
  const showTeacher = () => {
    dialogs.close();
    shownPrograms.showTeacher();
  };
  return (
    <>
      <h3>{t("page-share-class")}</h3>
      <div class="share-tiles">
        <Tile
          icon="lesson"
          word="teacher"
          help={t("page-share-teacher-help", { title: news.title ?? "" })}
          onClick={showTeacher}
        />
        {shownPrograms.now.value?.allowed && (
          <Tile
            icon="teachers"
            word="classmate"
            help={t(isLesson ? "page-share-classmate-lesson" : "page-share-classmate-help")}
            off={isLesson || !link}
            onClick={() => dialogs.show({ showLink: link })}
          />
        )}
      </div>
    </>
  );
}
