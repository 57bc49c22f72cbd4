"""All messages between the server and a page.

A page first sends `Open` or `New`; all other messages are about the project that it has opened.
Each message is a JSON object with a `kind`; only camera frames are binary (see `CameraFrame`).
``python -m learnblock.server.typescript`` writes the page's types from this module.
"""

from learnblock.server.messages.base import (
    LONGEST_CONTENT,
    LONGEST_TEXT,
    MOST_CARRIED,
    Coordinate,
    Id,
    Message,
    Name,
    Notation,
    ShortText,
    StateName,
    Text,
    View,
)
from learnblock.server.messages.block_sets import (
    BlockSetRead,
    BlockSets,
    BlocksShown,
    ChooseBlockSet,
    DeleteBlockSet,
    ExportBlockSet,
    ListBlockSets,
    ReadBlockSet,
    SaveBlockSet,
)
from learnblock.server.messages.carrying import (
    CodeOffered,
    InstallOffered,
    Noted,
    OfferedCode,
)
from learnblock.server.messages.containment import (
    AllowNetwork,
    Containment,
    Network,
    ReadContainment,
    ReadNetwork,
)
from learnblock.server.messages.custom_blocks import (
    MOST_ARGUMENTS,
    CheckCustomBlock,
    CustomBlock,
    CustomBlockChecked,
    CustomBlockPreview,
    CustomBlockProblem,
    CustomBlocks,
    CustomBlockSaved,
    DeleteCustomBlock,
    DuplicateCustomBlock,
    ExportCustomBlock,
    ImportCustomBlock,
    ListCustomBlocks,
    PaletteChanged,
    RestoreCustomBlock,
    SaveCustomBlock,
    TryCustomBlock,
)
from learnblock.server.messages.libraries import (
    MOST_LIBRARIES,
    MOST_SKILLS,
    ConvertLibrary,
    DownloadLibrary,
    Exportable,
    ExportableBlocks,
    ExportableFunction,
    ImportLibraries,
    InstalledLibrary,
    Libraries,
    LibrariesRead,
    LibraryConverted,
    LibraryFile,
    LibraryMade,
    LibraryRead,
    ListExportable,
    ListLibraries,
    MakeLibrary,
    ReadLibraries,
    RemoveLibrary,
    SkillClash,
    UseLibrary,
)
from learnblock.server.messages.program import (
    MOST_BREAKPOINTS,
    Complete,
    Completion,
    Completions,
    Conflict,
    Describe,
    Description,
    Document,
    EditBlocks,
    EditText,
    Format,
    Place,
    Problem,
    RecoverBlocks,
    RecoverText,
    Redo,
    Rename,
    SetBreakpoints,
    Undo,
)
from learnblock.server.messages.projects import (
    Delete,
    ExampleChoice,
    Export,
    Failed,
    File,
    History,
    Import,
    ImportOriginal,
    ListHistory,
    ListProjects,
    New,
    Open,
    Opened,
    OriginalImported,
    PastRun,
    ProjectEntry,
    ProjectRenamed,
    Projects,
    RenameProject,
    Restore,
    RobotChoice,
    SaveAs,
    Saved,
    Settings,
    TakenIn,
    Version,
    Welcome,
)
from learnblock.server.messages.robots import (
    BeginRobot,
    MakeRobot,
    RobotBegun,
    RobotMade,
    RobotProblem,
    Robots,
)
from learnblock.server.messages.running import (
    Answer,
    CameraFrame,
    ChooseRobot,
    ChooseWorld,
    Drive,
    Ended,
    GoalNow,
    InputWanted,
    Pause,
    PlaceRobot,
    Printed,
    ResetWorld,
    Resume,
    Robot,
    RobotLink,
    Run,
    RunningLine,
    RunState,
    Seen,
    Sensor,
    SetSpeed,
    Sound,
    Step,
    Stop,
    Telemetry,
    Variables,
    WatchCamera,
    WhenNow,
)
from learnblock.server.messages.settings import ChangeSettings, ReadSettings, Setting, SettingsTable
from learnblock.server.messages.tags import (
    MOST_TAGS,
    ExportTags,
    ReadTags,
    SaveTags,
    Tags,
    TagsRead,
)
from learnblock.server.messages.worlds import (
    CheckWorld,
    DeleteWorld,
    ExportWorld,
    ImportWorld,
    ReadWorld,
    RenameWorld,
    RestoreWorld,
    SaveWorld,
    Scene,
    WorldChecked,
    WorldChoice,
    WorldDeleted,
    WorldExported,
    Worlds,
    WorldToEdit,
)

FromPage = (
    Open
    | New
    | Import
    | ImportOriginal
    | InstallOffered
    | ImportWorld
    | ExportWorld
    | RenameWorld
    | DeleteWorld
    | RestoreWorld
    | SaveAs
    | RenameProject
    | Delete
    | Export
    | ListProjects
    | ListHistory
    | Restore
    | EditBlocks
    | EditText
    | RecoverBlocks
    | RecoverText
    | Undo
    | Redo
    | Format
    | Rename
    | Complete
    | Describe
    | SetBreakpoints
    | ChooseRobot
    | ChooseWorld
    | Run
    | Stop
    | Pause
    | Resume
    | Step
    | SetSpeed
    | Answer
    | ResetWorld
    | PlaceRobot
    | Drive
    | WatchCamera
    | ReadWorld
    | CheckWorld
    | SaveWorld
    | ListCustomBlocks
    | CheckCustomBlock
    | SaveCustomBlock
    | TryCustomBlock
    | DuplicateCustomBlock
    | DeleteCustomBlock
    | RestoreCustomBlock
    | ExportCustomBlock
    | ImportCustomBlock
    | ListBlockSets
    | ChooseBlockSet
    | ReadBlockSet
    | SaveBlockSet
    | DeleteBlockSet
    | ExportBlockSet
    | ReadContainment
    | ReadNetwork
    | AllowNetwork
    | ReadSettings
    | ChangeSettings
    | SaveTags
    | ReadTags
    | ExportTags
    | ListLibraries
    | ListExportable
    | ReadLibraries
    | ImportLibraries
    | RemoveLibrary
    | DownloadLibrary
    | MakeLibrary
    | ConvertLibrary
    | UseLibrary
    | BeginRobot
    | MakeRobot
)

ToPage = (
    Welcome
    | Worlds
    | Projects
    | Opened
    | ProjectRenamed
    | OriginalImported
    | Settings
    | File
    | History
    | Saved
    | TakenIn
    | Failed
    | Document
    | Conflict
    | Completions
    | Description
    | RunState
    | InputWanted
    | Printed
    | Ended
    | Variables
    | RunningLine
    | Telemetry
    | RobotLink
    | Sound
    | CameraFrame
    | Scene
    | WorldToEdit
    | WorldChecked
    | WorldExported
    | WorldDeleted
    | CodeOffered
    | Noted
    | CustomBlocks
    | CustomBlockChecked
    | CustomBlockSaved
    | PaletteChanged
    | BlockSets
    | BlocksShown
    | BlockSetRead
    | Containment
    | Network
    | SettingsTable
    | Tags
    | TagsRead
    | Libraries
    | LibrariesRead
    | Exportable
    | LibraryMade
    | LibraryConverted
    | RobotBegun
    | RobotMade
    | Robots
)

__all__ = [
    "LONGEST_CONTENT",
    "LONGEST_TEXT",
    "MOST_ARGUMENTS",
    "MOST_BREAKPOINTS",
    "MOST_CARRIED",
    "MOST_LIBRARIES",
    "MOST_SKILLS",
    "MOST_TAGS",
    "AllowNetwork",
    "Answer",
    "BeginRobot",
    "BlockSetRead",
    "BlockSets",
    "BlocksShown",
    "CameraFrame",
    "ChangeSettings",
    "CheckCustomBlock",
    "CheckWorld",
    "ChooseBlockSet",
    "ChooseRobot",
    "ChooseWorld",
    "CodeOffered",
    "Complete",
    "Completion",
    "Completions",
    "Conflict",
    "Containment",
    "ConvertLibrary",
    "Coordinate",
    "CustomBlock",
    "CustomBlockChecked",
    "CustomBlockPreview",
    "CustomBlockProblem",
    "CustomBlockSaved",
    "CustomBlocks",
    "Delete",
    "DeleteBlockSet",
    "DeleteCustomBlock",
    "DeleteWorld",
    "Describe",
    "Description",
    "Document",
    "DownloadLibrary",
    "Drive",
    "DuplicateCustomBlock",
    "EditBlocks",
    "EditText",
    "Ended",
    "ExampleChoice",
    "Export",
    "ExportBlockSet",
    "ExportCustomBlock",
    "ExportTags",
    "ExportWorld",
    "Exportable",
    "ExportableBlocks",
    "ExportableFunction",
    "Failed",
    "File",
    "Format",
    "FromPage",
    "GoalNow",
    "History",
    "Id",
    "Import",
    "ImportCustomBlock",
    "ImportLibraries",
    "ImportOriginal",
    "ImportWorld",
    "InputWanted",
    "InstallOffered",
    "InstalledLibrary",
    "Libraries",
    "LibrariesRead",
    "LibraryConverted",
    "LibraryFile",
    "LibraryMade",
    "LibraryRead",
    "ListBlockSets",
    "ListCustomBlocks",
    "ListExportable",
    "ListHistory",
    "ListLibraries",
    "ListProjects",
    "MakeLibrary",
    "MakeRobot",
    "Message",
    "Name",
    "Network",
    "New",
    "Notation",
    "Noted",
    "OfferedCode",
    "Open",
    "Opened",
    "OriginalImported",
    "PaletteChanged",
    "PastRun",
    "Pause",
    "Place",
    "PlaceRobot",
    "Printed",
    "Problem",
    "ProjectEntry",
    "ProjectRenamed",
    "Projects",
    "ReadBlockSet",
    "ReadContainment",
    "ReadLibraries",
    "ReadNetwork",
    "ReadSettings",
    "ReadTags",
    "ReadWorld",
    "RecoverBlocks",
    "RecoverText",
    "Redo",
    "RemoveLibrary",
    "Rename",
    "RenameProject",
    "RenameWorld",
    "ResetWorld",
    "Restore",
    "RestoreCustomBlock",
    "RestoreWorld",
    "Resume",
    "Robot",
    "RobotBegun",
    "RobotChoice",
    "RobotLink",
    "RobotMade",
    "RobotProblem",
    "Robots",
    "Run",
    "RunState",
    "RunningLine",
    "SaveAs",
    "SaveBlockSet",
    "SaveCustomBlock",
    "SaveTags",
    "SaveWorld",
    "Saved",
    "Scene",
    "Seen",
    "Sensor",
    "SetBreakpoints",
    "SetSpeed",
    "Setting",
    "Settings",
    "SettingsTable",
    "ShortText",
    "SkillClash",
    "Sound",
    "StateName",
    "Step",
    "Stop",
    "Tags",
    "TagsRead",
    "TakenIn",
    "Telemetry",
    "Text",
    "ToPage",
    "TryCustomBlock",
    "Undo",
    "UseLibrary",
    "Variables",
    "Version",
    "View",
    "WatchCamera",
    "Welcome",
    "WhenNow",
    "WorldChecked",
    "WorldChoice",
    "WorldDeleted",
    "WorldExported",
    "WorldToEdit",
    "Worlds",
]
