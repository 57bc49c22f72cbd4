import { t } from "../../i18n";
import { prefer, preferences } from "../../preferences";
import { IconButton } from "../widgets/button";
import { usePage } from "../page";
import type { Toast } from "./toasts";
import "./toasts.css";

/** The notes over the page, and the offer of a tour to whoever is new. */
export function ToastList() {
  const { toasts } = usePage();
  return (
    <div class="toasts">
      <TourOffer />
      <div role="log" aria-label={t("chrome.notes")}>
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
      <IconButton icon="close" word="chrome.dismiss" onClick={() => toasts.dismiss(toast)} />
    </div>
  );
}

function TourOffer() {
  const { dialogs, project } = usePage();
  if (preferences.value.tourDone || dialogs.tour.value || !project.name.value) return null;
  return (
    <section class="toast note" aria-label={t("tour.title")}>
      <p>{t("tour.offer")}</p>
      <button type="button" class="button filled" onClick={() => (dialogs.tour.value = true)}>
        {t("tour.begin")}
      </button>
      <button type="button" class="button bordered" onClick={() => prefer({ tourDone: true })}>
        {t("tour.decline")}
      </button>
    </section>
  );
}
