/** A button in the help on a block. */

import { type IconName, icon } from "../../ui/icons";

export function button(picture: IconName, text: string, act: () => void): HTMLElement {
  const made = document.createElement("button");
  made.type = "button";
  made.className = "lbInsert";
  made.append(icon(picture), text);
  made.addEventListener("click", act);
  return made;
}
