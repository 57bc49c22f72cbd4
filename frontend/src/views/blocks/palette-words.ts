/** The words of the palette's offers. */

import { t } from "../../i18n";
import { deviceWord } from "../../model/robots";
import type { Words } from "./offers";

/** @param robot the robot's display name */
export function paletteWords(robot: string): Words {
  return {
    more: (count) => `+ ${t("page-blocks-more", { count })}`,
    fewer: () => `− ${t("page-blocks-fewer")}`,
    from: (stage) => t("page-blocks-from-stage", { stage: t(`page-bar-stage-${stage}`) }),
    missing: (need) => t("page-blocks-missing", { robot, device: deviceWord(need) }),
    standIn: (need) => t("page-blocks-stand-in", { robot, device: deviceWord(need) }),
  };
}
