/** How many robots run the program of the tab that is open. */

import { useSignal } from "@preact/signals";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { MOST_ROBOTS } from "../../model/robot-tabs";
import { Actions, Dialog } from "../../ui/dialog";

export function RobotCountDialog() {
  const { dialogs, tabs } = usePage();
  const name = tabs.open.value;
  const count = useSignal(tabs.countOf(name));
  const close = () => dialogs.close();
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    close();
    tabs.setCount(name, count.value);
  };
  return (
    <Dialog title={t("page-tabs-count-title", { name })} close={close}>
      <form onSubmit={submit}>
        <CountField
          label={t("page-tabs-count")}
          value={count.value}
          most={MOST_ROBOTS - tabs.count.value + tabs.countOf(name)}
          set={(value) => (count.value = value)}
        />
        <p class="dim">{t("page-tabs-same-program-help")}</p>
        <Actions cancel={close}>
          <button type="submit" class="button filled">
            {t("page-tabs-count-action")}
          </button>
        </Actions>
      </form>
    </Dialog>
  );
}

interface CountProps {
  readonly label: string;
  readonly value: number;
  readonly most: number;
  readonly set: (value: number) => void;
}

export function CountField({ label, value, most, set }: CountProps) {
  return (
    <label class="field">
      {label}
      <input
        type="number"
        required
        min={1}
        max={most}
        value={value}
        onFocus={({ currentTarget }) => currentTarget.select()}
        onInput={({ currentTarget }) => set(currentTarget.valueAsNumber)}
      />
    </label>
  );
}
