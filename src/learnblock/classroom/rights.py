"""Who may what: the one table that every message of a page in a class passes.

What is not in it is refused, so a new kind of message is refused until its roles are decided.
"""

from collections.abc import Iterable, Iterator, Mapping
from enum import StrEnum

from learnblock.classroom import messages as ours
from learnblock.server import messages


class Role(StrEnum):
    """What a page is to the program that it shows."""

    #: The pupil whose program it is.
    PUPIL = "pupil"
    #: The teacher, who looks.
    WATCHER = "watcher"
    #: The teacher, whom the pupil lets write.
    HELPER = "helper"


#: Everybody who sees the program.
_READ = (
    messages.Open, messages.CloseProject, messages.OpenTab, messages.Export,
    messages.ListProjects, messages.ListHistory,
    messages.Complete, messages.Describe, messages.ReadRunsOn, messages.WatchCamera,
    messages.ReadTimeline, messages.ReadPrediction, messages.LookBack, messages.ReadPastPicture,
    messages.ReadValues, messages.ReadCalls, messages.ReadQuestions, messages.AskWhy,
    messages.ListRuns, messages.OpenRun, messages.CloseRun, messages.CompareRuns,
    messages.ReadCallsBeside,
    messages.ReadWorld, messages.CheckWorld, messages.MakeWorld, messages.ExportWorld,
    messages.ListCustomBlocks, messages.CheckCustomBlock, messages.ExportCustomBlock,
    messages.ListBlockSets, messages.ReadBlockSet, messages.ExportBlockSet,
    messages.ReadContainment, messages.ReadNetwork, messages.ReadTags, messages.ExportTags,
    messages.ListLibraries, messages.ListExportable, messages.ReadLibraries,
    messages.DownloadLibrary, messages.ListLessons, messages.Introduce,
)  # fmt: skip
#: Also the teacher who only looks, because a robot must be stopped at once.
_STOP = (messages.Stop,)
#: Who changes the program and runs it.
_WRITE = (
    messages.EditBlocks, messages.EditText, messages.RecoverBlocks, messages.RecoverText,
    messages.Undo, messages.Redo, messages.Format, messages.Rename, messages.SetBreakpoints,
    messages.ChooseRobot, messages.ChooseWorld, messages.ChooseBlockSet,
    messages.Run, messages.Pause, messages.Resume, messages.Step, messages.SetSpeed,
    messages.Answer, messages.HoldKeys, messages.HandleRobot, messages.ResetWorld,
    messages.PlaceRobot, messages.Drive,
    messages.AddTab, messages.CloseTab, messages.ReopenTab, messages.RenameTab,
    messages.SetRobotCount,
    messages.ShowStep, messages.CheckStep, messages.StopChecking, messages.ShowVariant,
)  # fmt: skip
#: The pupil, who alone has the projects, the blocks and the stars.
_OWN = (
    messages.New, messages.OpenExample, messages.Import, messages.ImportOriginal,
    messages.InstallOffered, messages.SaveAs, messages.RenameProject, messages.CopyProject,
    messages.KeepPicture, messages.Delete, messages.Restore,
    messages.NameRun, messages.DeleteRun,
    messages.ImportWorld, messages.RenameWorld, messages.DeleteWorld, messages.RestoreWorld,
    messages.SaveWorld,
    messages.SaveCustomBlock, messages.TryCustomBlock, messages.DuplicateCustomBlock,
    messages.DeleteCustomBlock, messages.RestoreCustomBlock, messages.ImportCustomBlock,
    messages.SaveBlockSet, messages.DeleteBlockSet, messages.SaveTags,
    messages.ImportLibraries, messages.RemoveLibrary, messages.MakeLibrary,
    messages.ConvertLibrary, messages.UseLibrary,
    messages.StartLesson, messages.RestartStep, messages.TakeHint, messages.AnswerQuiz,
    messages.AnswerPuzzle,
    ours.AskForHelp, ours.LetTeacherWrite,
)  # fmt: skip
#: The teacher.
_TEACHER = (ours.AskToWrite,)
#: No one in a class: the computer, its robots and its lessons are the teacher's, who uses them in
#: a separate LearnBlock.
_NOBODY = (
    messages.ReadSettings, messages.ChangeSettings, messages.AllowNetwork,
    messages.FindRobots, messages.ConnectRobot, messages.DisconnectRobot, messages.TryRobot,
    messages.CorrectRobot, messages.NameRobot, messages.UseRobot,
    messages.BeginRobot, messages.MakeRobot,
    messages.ImportLesson, messages.ImportLessonFolder, messages.CopyLesson,
    messages.ReadLessonNotes, messages.DeleteLesson, messages.MakeLesson, messages.ChangeLesson,
    messages.ExamineLesson, messages.SaveLesson, messages.TryLesson, messages.StopTrying,
    messages.ExportLesson,
)  # fmt: skip


# Why: docs/decisions.md, "One table says who may what"
def _table() -> Iterator[tuple[str, frozenset[Role]]]:
    def row(kinds: Iterable[type], *roles: Role) -> Iterator[tuple[str, frozenset[Role]]]:
        return ((kind.__name__, frozenset(roles)) for kind in kinds)

    yield from row(_READ, *Role)
    yield from row(_STOP, *Role)
    yield from row(_WRITE, Role.PUPIL, Role.HELPER)
    yield from row(_OWN, Role.PUPIL)
    yield from row(_TEACHER, Role.WATCHER, Role.HELPER)
    yield from row(_NOBODY)


#: The roles that may send each kind of message.
RIGHTS: Mapping[str, frozenset[Role]] = dict(_table())


def may(role: Role, kind: str) -> bool:
    """Whether a page in this role may send a message of this kind."""
    return role in RIGHTS.get(kind, frozenset())
