/** Chooses a classmate whose program is to drive the second robot. */

import { useEffect } from "preact/hooks";

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import type { Classmate } from "../../protocol/classroom";
import { Dialog } from "../../ui/dialog";
import "./pairs.css";

export function InviteDialog() {
  const { dialogs, pairs } = usePage();
  useEffect(() => pairs.ask(), []);
  const close = () => dialogs.close();
  const invite = ({ id }: Classmate) => {
    close();
    pairs.invite(id);
  };
  return (
    <Dialog title={t("page-pair-title")} close={close}>
      <p>{t("page-pair-how")}</p>
      <Choice classmates={pairs.classmates.value} choose={invite} />
    </Dialog>
  );
}

interface ChoiceProps {
  readonly classmates: readonly Classmate[] | null;
  readonly choose: (classmate: Classmate) => void;
}

function Choice({ classmates, choose }: ChoiceProps) {
  if (classmates === null) return null;
  if (classmates.length === 0) return <p class="dim">{t("page-pair-nobody")}</p>;
  return (
    <ul class="classmates">
      {classmates.map((one) => (
        <li key={one.id}>
          <button type="button" class="button bordered" onClick={() => choose(one)}>
            {one.name}
          </button>
        </li>
      ))}
    </ul>
  );
}
