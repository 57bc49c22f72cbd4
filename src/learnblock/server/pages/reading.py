"""What a page may do while another server has the right to write."""

from learnblock.errors import LearnBlockError
from learnblock.server import messages

#: All other messages write, either to the projects or to the user's folder.
READING = frozenset(
    {
        # Robot, world, breakpoints and block set hold for this session, and are not saved.
        messages.Open, messages.Export, messages.ListProjects, messages.ListHistory,
        messages.SetBreakpoints, messages.ChooseRobot, messages.ChooseWorld,
        messages.ChooseBlockSet, messages.Complete, messages.Describe,
        messages.Run, messages.Stop, messages.Pause, messages.Resume, messages.Step,
        messages.SetSpeed, messages.Answer, messages.ResetWorld, messages.PlaceRobot,
        messages.Drive, messages.WatchCamera, messages.TryCustomBlock,
        messages.ReadWorld, messages.CheckWorld, messages.ExportWorld,
        messages.ListCustomBlocks, messages.CheckCustomBlock, messages.ExportCustomBlock,
        messages.ListBlockSets, messages.ReadBlockSet, messages.ExportBlockSet,
        messages.ReadContainment, messages.ReadNetwork,
        messages.ReadSettings, messages.ReadTags, messages.ExportTags,
        messages.ListLibraries, messages.ListExportable, messages.ReadLibraries,
        messages.DownloadLibrary, messages.MakeLibrary, messages.ConvertLibrary,
        messages.BeginRobot,
    }
)  # fmt: skip


def require_reading(message: messages.Message) -> None:
    """Check that a message writes nothing.

    Raises:
        LearnBlockError: it would write.
    """
    if type(message) not in READING:
        raise LearnBlockError("server-read-only")
