/** The dialog that is open, if any. */

import { BlockSetsDialog } from "../features/block-sets/dialog";
import { CallsBesideDialog } from "../features/calls/beside";
import { ConnectDialog } from "../features/connect/dialog";
import { ContainmentDialog } from "../features/containment/dialog";
import { CustomBlockDialog, CustomBlocksDialog } from "../features/custom-blocks/dialogs";
import { ExamplesDialog } from "../features/examples/dialog";
import { HelpDialog } from "../features/help/dialog";
import { InviteDialog } from "../features/in-class/invite";
import { ShowClassmateDialog } from "../features/in-class/show-classmate";
import { LessonEditorDialog } from "../features/lesson-editor/dialog";
import { DeleteLessonDialog } from "../features/lessons/delete";
import { LessonNotesDialog } from "../features/lessons/notes";
import { LibrariesDialog } from "../features/libraries/dialog";
import { MakeBlockDialog } from "../features/make-block/dialog";
import { NewRobotDialog } from "../features/new-robot/dialog";
import { OtherDeviceDialog } from "../features/other-device/dialog";
import { HistoryDialog } from "../features/projects/history";
import { ImportedDialog } from "../features/projects/imported";
import { NewDialog } from "../features/projects/new";
import { OfferedDialog } from "../features/projects/offered";
import { OpenDialog } from "../features/projects/open";
import { ProjectDialog, RenameDialog, SaveAsDialog } from "../features/projects/save-and-delete";
import { PerceptionDialog, RobotSettingsDialog } from "../features/robot-settings/dialogs";
import { AddRobotsDialog } from "../features/robot-tabs/add";
import { RobotCountDialog } from "../features/robot-tabs/count";
import { RenameRobotDialog } from "../features/robot-tabs/rename";
import { RunDialog } from "../features/runs/dialogs";
import { SettingsDialog, ShortcutsDialog } from "../features/settings/dialogs";
import { ShareDialog } from "../features/share/dialog";
import { OpenLinkDialog } from "../features/share/open-link";
import { ProgramPictureDialog } from "../features/share/picture";
import { TagsDialog } from "../features/tags/dialog";
import { GradingDialog } from "../features/teachers/topics";
import { WorldGalleryDialog } from "../features/worlds/gallery";
import { RenameWorldDialog } from "../features/worlds/rename";
import { WorldVariantDialog } from "../features/worlds/variant";
import { t } from "../i18n";
import { usePage } from "../model/page";
import { Dialog } from "../ui/dialog";
import { IslandPlace } from "../ui/island-place";
import { MoreDialog } from "./bar/more-dialog";

const DIALOGS = {
  open: OpenDialog,
  examples: ExamplesDialog,
  new: NewDialog,
  rename: RenameDialog,
  saveAs: SaveAsDialog,
  history: HistoryDialog,
  moreOfProject: MoreDialog,
  openLink: OpenLinkDialog,
  share: ShareDialog,
  programPicture: ProgramPictureDialog,
  help: HelpDialog,
  shortcuts: ShortcutsDialog,
  settings: SettingsDialog,
  worldEditor: WorldEditorDialog,
  addRobots: AddRobotsDialog,
  invite: InviteDialog,
  robotCount: RobotCountDialog,
  renameRobot: RenameRobotDialog,
  worlds: WorldGalleryDialog,
  worldVariant: WorldVariantDialog,
  blockSets: BlockSetsDialog,
  tags: TagsDialog,
  robotSettings: RobotSettingsDialog,
  perception: PerceptionDialog,
  connect: ConnectDialog,
  newRobot: NewRobotDialog,
  customBlocks: CustomBlocksDialog,
  libraries: LibrariesDialog,
  containment: ContainmentDialog,
  otherDevice: OtherDeviceDialog,
  grading: GradingDialog,
  lessonEditor: LessonEditorDialog,
  callsBeside: CallsBesideDialog,
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
  if (typeof name === "object" && "makeBlock" in name) return <MakeBlockDialog of={name} />;
  if (typeof name === "object" && ("nameRun" in name || "deleteRun" in name)) return <RunDialog of={name} />;
  if (typeof name === "object" && "deleteLesson" in name) return <DeleteLessonDialog of={name} />;
  if (typeof name === "object" && "lessonNotes" in name) return <LessonNotesDialog of={name} />;
  if (typeof name === "object" && "showLink" in name) return <ShowClassmateDialog of={name} />;
  if (typeof name === "object" && "editWorld" in name) return <WorldEditorDialog first={name.editWorld} />;
  if (typeof name === "object" && "renameWorld" in name) return <RenameWorldDialog name={name.renameWorld} />;
  if (typeof name === "object") return <ProjectDialog of={name} />;
  const Shown = DIALOGS[name];
  return <Shown />;
}

function WorldEditorDialog({ first = "" }: { first?: string }) {
  const { context, dialogs, project, toasts } = usePage();
  const saved = (name: string) => {
    dialogs.close();
    toasts.note(t("page-editor-saved", { name }));
  };
  const load = async () => {
    const { createWorldEditor } = await import("../features/world-editor");
    return createWorldEditor(context, (name) => project.freeWorldTitle(name), saved, first);
  };
  return (
    <Dialog title={t("page-bar-edit-world")} close={() => dialogs.close()} size="whole">
      <IslandPlace load={load} />
    </Dialog>
  );
}
