"""What a page may do while another server has the right to write."""

from learnblock.errors import LearnBlockError
from learnblock.server import messages

#: All other messages write, either to the projects or to the user's folder.
READING = frozenset(
    {
        # Robot, world, breakpoints and block set hold for this session, and are not saved.
        messages.Open, messages.CloseProject, messages.OpenTab, messages.Export,
        messages.ListProjects, messages.ListHistory, messages.SetBreakpoints,
        messages.ChooseRobot, messages.ChooseWorld,
        messages.ChooseBlockSet, messages.Complete, messages.Describe, messages.ReadRunsOn,
        messages.Run, messages.Stop, messages.Pause, messages.Resume, messages.Step,
        messages.SetSpeed, messages.Answer, messages.ResetWorld, messages.PlaceRobot,
        messages.Drive, messages.WatchCamera, messages.TryCustomBlock,
        messages.ListRuns, messages.OpenRun, messages.CloseRun, messages.CompareRuns,
        messages.ReadCallsBeside,
        messages.ReadTimeline, messages.LookBack, messages.ReadPastPicture, messages.ReadValues,
        messages.ReadPrediction, messages.ReadCalls, messages.ReadQuestions, messages.AskWhy,
        messages.ReadWorld, messages.CheckWorld, messages.MakeWorld, messages.ExportWorld,
        messages.ListCustomBlocks, messages.CheckCustomBlock, messages.ExportCustomBlock,
        messages.ListBlockSets, messages.ReadBlockSet, messages.ExportBlockSet,
        messages.ReadContainment, messages.ReadNetwork,
        messages.ReadSettings, messages.ReadTags, messages.ExportTags,
        messages.ListLibraries, messages.ListExportable, messages.ReadLibraries,
        messages.DownloadLibrary, messages.MakeLibrary, messages.ConvertLibrary,
        messages.BeginRobot,
        messages.Introduce, messages.ListLessons, messages.CheckStep, messages.StopChecking,
        messages.AnswerQuiz, messages.AnswerPuzzle, messages.TakeHint, messages.ShowVariant,
        messages.MakeLesson, messages.ChangeLesson, messages.ExamineLesson, messages.TryLesson,
        messages.StopTrying, messages.ExportLesson, messages.ReadLessonNotes,
        messages.FindRobots, messages.ConnectRobot, messages.DisconnectRobot, messages.TryRobot,
    }
)  # fmt: skip


def require_reading(message: messages.Message) -> None:
    """Check that a message writes nothing.

    Raises:
        LearnBlockError: it would write.
    """
    if type(message) not in READING:
        raise LearnBlockError("server-read-only")
