import { t } from "../i18n";
import { usePage } from "../model/page";
import { prefer, preferences } from "../model/preferences";
import { IconButton } from "../ui/button";
import type { Toast } from "../ui/toasts";
import "../ui/toasts.css";

/** The toasts over the page, and the offer of a tour to new users. */
export function ToastList() {
  const { toasts } = usePage();
  return (
    <div class="toasts">
      <TourOffer />
      <div role="log" aria-label={t("page-shell-notes")}>
        {toasts.shown.value.map((toast) => (
          <Note key={toast.text} toast={toast} />
        ))}
      </div>
    </div>
  );
}

function Note({ toast }: { toast: Toast }) {
  const { toasts } = usePage();
  const { action } = toast;
  const act = () => {
    toasts.dismiss(toast);
    action?.run();
  };
  return (
    <div class={`toast ${toast.sort}`}>
      <p>{toast.text}</p>
      {action && (
        <button type="button" class="button bordered" onClick={act}>
          {action.text}
        </button>
      )}
      <IconButton icon="close" word="page-shell-dismiss" onClick={() => toasts.dismiss(toast)} />
    </div>
  );
}

function TourOffer() {
  const { dialogs, project } = usePage();
  if (preferences.value.tourDone || dialogs.tour.value || !project.name.value) return null;
  return (
    <section class="toast note" aria-label={t("page-tour-title")}>
      <p>{t("page-tour-offer")}</p>
      <button type="button" class="button filled" onClick={() => (dialogs.tour.value = true)}>
        {t("page-tour-begin")}
      </button>
      <button type="button" class="button bordered" onClick={() => prefer({ tourDone: true })}>
        {t("page-tour-decline")}
      </button>
    </section>
  );
}
