/** The dialog that is open, if any. */

import { t } from "../../i18n";
import { Dialog } from "../widgets/dialog";
import { BlockSetsDialog } from "./blocksets";
import { ExamplesDialog } from "./examples";
import { HistoryDialog } from "./history";
import { IslandPlace } from "../widgets/island";
import { LibrariesDialog } from "./libraries";
import { NewRobotDialog } from "./newrobot";
import { OpenDialog } from "./open";
import { OwnBlockDialog, OwnBlocksDialog } from "./ownblocks";
import { usePage } from "../page";
import { DeleteDialog, SaveAsDialog } from "./project";
import { PerceptionDialog, RobotSettingsDialog } from "./machine";
import { TagsDialog } from "./tags";
import { SettingsDialog, ShortcutsDialog } from "./settings";

const DIALOGS = {
  open: OpenDialog,
  examples: ExamplesDialog,
  saveAs: SaveAsDialog,
  history: HistoryDialog,
  shortcuts: ShortcutsDialog,
  settings: SettingsDialog,
  worldEditor: WorldEditorDialog,
  blockSets: BlockSetsDialog,
  tags: TagsDialog,
  robotSettings: RobotSettingsDialog,
  perception: PerceptionDialog,
  newRobot: NewRobotDialog,
  ownBlocks: OwnBlocksDialog,
  libraries: LibrariesDialog,
} as const;

export function OpenedDialog() {
  const name = usePage().dialogs.open.value;
  if (name === null) return null;
  if (typeof name === "object" && "ownBlock" in name) return <OwnBlockDialog key={name.ownBlock} name={name} />;
  if (typeof name === "object") return <DeleteDialog name={name.delete} />;
  const Shown = DIALOGS[name];
  return <Shown />;
}

function WorldEditorDialog() {
  const { context, dialogs } = usePage();
  const load = async () => {
    const { createWorldEditor } = await import("../../world/editor");
    return createWorldEditor(context, () => dialogs.close());
  };
  return (
    <Dialog title={t("bar.editWorld")} close={() => dialogs.close()} size="whole">
      <IslandPlace load={load} />
    </Dialog>
  );
}
