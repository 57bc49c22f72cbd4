import { usePage } from "../../model/page";
import { IconButton } from "../../ui/button";
import { room } from "../../ui/screen";

/** Opens the dialog that takes the program elsewhere. */
export function ShareButton() {
  const { dialogs } = usePage();
  return (
    <IconButton
      icon="share"
      word="page-share-menu"
      named={room.value !== "narrow"}
      onClick={() => dialogs.show("share")}
    />
  );
}
