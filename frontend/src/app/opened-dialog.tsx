/** The dialog that is open, if any. */

import { BlockSetsDialog } from "../features/block-sets/dialog";
import { ContainmentDialog } from "../features/containment/dialog";
import { CustomBlockDialog, CustomBlocksDialog } from "../features/custom-blocks/dialogs";
import { ExamplesDialog } from "../features/examples/dialog";
import { LibrariesDialog } from "../features/libraries/dialog";
import { NewRobotDialog } from "../features/new-robot/dialog";
import { HistoryDialog } from "../features/projects/history";
import { ImportedDialog } from "../features/projects/imported";
import { OfferedDialog } from "../features/projects/offered";
import { OpenDialog } from "../features/projects/open";
import { DeleteDialog, NewDialog, RenameDialog, SaveAsDialog } from "../features/projects/save-and-delete";
import { PerceptionDialog, RobotSettingsDialog } from "../features/robot-settings/dialogs";
import { SettingsDialog, ShortcutsDialog } from "../features/settings/dialogs";
import { TagsDialog } from "../features/tags/dialog";
import { RenameWorldDialog } from "../features/worlds/rename";
import { t } from "../i18n";
import { usePage } from "../model/page";
import { Dialog } from "../ui/dialog";
import { IslandPlace } from "../ui/island-place";

const DIALOGS = {
  open: OpenDialog,
  examples: ExamplesDialog,
  new: NewDialog,
  rename: RenameDialog,
  saveAs: SaveAsDialog,
  history: HistoryDialog,
  shortcuts: ShortcutsDialog,
  settings: SettingsDialog,
  worldEditor: WorldEditorDialog,
  renameWorld: RenameWorldDialog,
  blockSets: BlockSetsDialog,
  tags: TagsDialog,
  robotSettings: RobotSettingsDialog,
  perception: PerceptionDialog,
  newRobot: NewRobotDialog,
  customBlocks: CustomBlocksDialog,
  libraries: LibrariesDialog,
  containment: ContainmentDialog,
} as const;

export function OpenedDialog() {
  const { dialogs, project } = usePage();
  const name = dialogs.open.value;
  const report = project.imported.value;
  const offered = project.offered.value;
  if (name === null && report) return <ImportedDialog report={report} />;
  if (name === null) return offered && project.reviewing.value && <OfferedDialog offered={offered} />;
  if (typeof name === "object" && "customBlock" in name)
    return <CustomBlockDialog key={name.customBlock} name={name} />;
  if (typeof name === "object") return <DeleteDialog name={name.delete} />;
  const Shown = DIALOGS[name];
  return <Shown />;
}

function WorldEditorDialog() {
  const { context, dialogs, project } = usePage();
  const load = async () => {
    const { createWorldEditor } = await import("../features/world-editor");
    return createWorldEditor(
      context,
      () => dialogs.close(),
      (name) => project.freeWorldTitle(name),
    );
  };
  return (
    <Dialog title={t("page-bar-edit-world")} close={() => dialogs.close()} size="whole">
      <IslandPlace load={load} />
    </Dialog>
  );
}
