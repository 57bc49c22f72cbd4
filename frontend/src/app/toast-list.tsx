import { t } from "../i18n";
import { usePage } from "../model/page";
import { IconButton } from "../ui/button";
import type { Toast } from "../ui/toasts";
import "../ui/toasts.css";

/** The toasts over the page. */
export function ToastList() {
  const { toasts } = usePage();
  return (
    <div class="toasts" role="log" aria-label={t("page-shell-notes")}>
      {toasts.shown.value.map((toast) => (
        <Note key={toast.text} toast={toast} />
      ))}
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
