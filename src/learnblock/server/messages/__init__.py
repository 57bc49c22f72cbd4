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
from learnblock.server.messages.connecting import (
    ConnectRobot,
    Correction,
    CorrectRobot,
    DisconnectRobot,
    FindRobots,
    KnownRobot,
    NameRobot,
    NearbyRobot,
    RobotConnected,
    RobotCorrected,
    RobotsNearby,
    RobotValues,
    TryRobot,
    UseRobot,
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
from learnblock.server.messages.kept import (
    CallsBeside,
    CloseRun,
    ComparedRun,
    CompareRuns,
    DeleteRun,
    KeptRun,
    KeptRuns,
    ListRuns,
    NameRun,
    OpenRun,
    ReadCallsBeside,
    RunsCompared,
    RunShown,
    RunStep,
)
from learnblock.server.messages.lesson_editor import (
    ChangeLesson,
    CopyLesson,
    ExaminedStep,
    ExamineLesson,
    ExportLesson,
    LessonExamined,
    LessonExported,
    LessonNotes,
    LessonProblem,
    LessonSaved,
    LessonToEdit,
    LessonTried,
    MakeLesson,
    ReadLessonNotes,
    SaveLesson,
    SolvedStep,
    StopTrying,
    TriedProgram,
    TryLesson,
    WrongProgram,
)
from learnblock.server.messages.lessons import (
    LARGEST_LESSON,
    AnswerPuzzle,
    AnswerQuiz,
    CheckStep,
    DeleteLesson,
    ImportLesson,
    ImportLessonFolder,
    Introduce,
    LessonAttempt,
    LessonChecked,
    LessonChoice,
    LessonGoal,
    LessonGoals,
    LessonHint,
    LessonHints,
    LessonImported,
    LessonPuzzle,
    LessonQuiz,
    Lessons,
    LessonShown,
    LessonStep,
    LessonText,
    LessonWords,
    ListLessons,
    PuzzleJudged,
    QuizJudged,
    RestartStep,
    ShowStep,
    ShowVariant,
    StartLesson,
    StopChecking,
    TakeHint,
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
from learnblock.server.messages.looking import (
    Asked,
    AskWhy,
    CalledFunction,
    CallEdge,
    CallGraph,
    LookBack,
    Past,
    Predicted,
    Questions,
    ReadCalls,
    ReadPastPicture,
    ReadPrediction,
    ReadQuestions,
    ReadTimeline,
    ReadValues,
    Timeline,
    TimeMark,
    TwinFinding,
    ValuesThere,
    ValueThere,
    WhyAnswer,
    WhyQuestion,
    WhySentence,
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
    ReadRunsOn,
    RecoverBlocks,
    RecoverText,
    Redo,
    Rename,
    RunsOn,
    SetBreakpoints,
    Undo,
    Verdict,
)
from learnblock.server.messages.projects import (
    LARGEST_PICTURE,
    CloseProject,
    CopyProject,
    Delete,
    ExampleChoice,
    Export,
    Failed,
    File,
    History,
    Import,
    ImportOriginal,
    KeepPicture,
    ListHistory,
    ListProjects,
    New,
    Open,
    Opened,
    OpenExample,
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
    Stage,
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
    Bumped,
    CameraFrame,
    ChooseRobot,
    ChooseWorld,
    Drawing,
    Drive,
    Ended,
    GoalNow,
    HandleRobot,
    HoldKeys,
    InputWanted,
    KeysWanted,
    Pause,
    PlaceRobot,
    Printed,
    PrintedByRobots,
    PrintedPart,
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
    StrokePart,
    Telemetry,
    Variables,
    WatchCamera,
    WhenNow,
)
from learnblock.server.messages.settings import ChangeSettings, ReadSettings, Setting, SettingsTable
from learnblock.server.messages.tabs import (
    AddTab,
    CloseTab,
    OpenTab,
    RenameTab,
    ReopenTab,
    SetRobotCount,
    Tab,
    TabOpened,
    TabRobot,
    Tabs,
)
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
    MakeWorld,
    ReadWorld,
    RenameWorld,
    RestoreWorld,
    SaveWorld,
    Scene,
    UnreachableGoal,
    WorldChecked,
    WorldChoice,
    WorldDeleted,
    WorldExported,
    WorldMade,
    Worlds,
    WorldToEdit,
)

FromPage = (
    Open
    | New
    | OpenExample
    | CloseProject
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
    | CopyProject
    | KeepPicture
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
    | HoldKeys
    | HandleRobot
    | ResetWorld
    | PlaceRobot
    | Drive
    | WatchCamera
    | ReadTimeline
    | ReadPrediction
    | LookBack
    | ReadPastPicture
    | ReadValues
    | ReadCalls
    | ReadQuestions
    | AskWhy
    | ListRuns
    | OpenRun
    | CloseRun
    | NameRun
    | DeleteRun
    | CompareRuns
    | ReadCallsBeside
    | ReadWorld
    | CheckWorld
    | MakeWorld
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
    | ReadRunsOn
    | ReadSettings
    | ChangeSettings
    | AddTab
    | SetRobotCount
    | OpenTab
    | CloseTab
    | ReopenTab
    | RenameTab
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
    | FindRobots
    | ConnectRobot
    | DisconnectRobot
    | TryRobot
    | CorrectRobot
    | NameRobot
    | UseRobot
    | Introduce
    | ListLessons
    | StartLesson
    | ShowStep
    | RestartStep
    | CheckStep
    | StopChecking
    | ShowVariant
    | TakeHint
    | AnswerQuiz
    | AnswerPuzzle
    | ImportLesson
    | ImportLessonFolder
    | DeleteLesson
    | MakeLesson
    | ChangeLesson
    | ExamineLesson
    | SaveLesson
    | TryLesson
    | StopTrying
    | ExportLesson
    | ReadLessonNotes
    | CopyLesson
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
    | RunsOn
    | RunState
    | InputWanted
    | KeysWanted
    | Bumped
    | Printed
    | PrintedByRobots
    | Ended
    | Variables
    | RunningLine
    | Timeline
    | Predicted
    | Past
    | ValuesThere
    | CallGraph
    | Questions
    | WhyAnswer
    | KeptRuns
    | RunShown
    | RunsCompared
    | CallsBeside
    | Telemetry
    | Drawing
    | RobotLink
    | Sound
    | CameraFrame
    | Scene
    | WorldToEdit
    | WorldChecked
    | WorldMade
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
    | Tabs
    | TabOpened
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
    | RobotsNearby
    | RobotConnected
    | RobotValues
    | RobotCorrected
    | Lessons
    | LessonShown
    | LessonGoals
    | LessonChecked
    | LessonHints
    | QuizJudged
    | PuzzleJudged
    | LessonImported
    | LessonToEdit
    | LessonExamined
    | LessonSaved
    | LessonTried
    | LessonExported
    | LessonNotes
)

__all__ = [
    "LARGEST_LESSON",
    "LARGEST_PICTURE",
    "LONGEST_CONTENT",
    "LONGEST_TEXT",
    "MOST_ARGUMENTS",
    "MOST_BREAKPOINTS",
    "MOST_CARRIED",
    "MOST_LIBRARIES",
    "MOST_SKILLS",
    "MOST_TAGS",
    "AddTab",
    "AllowNetwork",
    "Answer",
    "AnswerPuzzle",
    "AnswerQuiz",
    "AskWhy",
    "Asked",
    "BeginRobot",
    "BlockSetRead",
    "BlockSets",
    "BlocksShown",
    "Bumped",
    "CallEdge",
    "CallGraph",
    "CalledFunction",
    "CallsBeside",
    "CameraFrame",
    "ChangeLesson",
    "ChangeSettings",
    "CheckCustomBlock",
    "CheckStep",
    "CheckWorld",
    "ChooseBlockSet",
    "ChooseRobot",
    "ChooseWorld",
    "CloseProject",
    "CloseRun",
    "CloseTab",
    "CodeOffered",
    "CompareRuns",
    "ComparedRun",
    "Complete",
    "Completion",
    "Completions",
    "Conflict",
    "ConnectRobot",
    "Containment",
    "ConvertLibrary",
    "Coordinate",
    "CopyLesson",
    "CopyProject",
    "CorrectRobot",
    "Correction",
    "CustomBlock",
    "CustomBlockChecked",
    "CustomBlockPreview",
    "CustomBlockProblem",
    "CustomBlockSaved",
    "CustomBlocks",
    "Delete",
    "DeleteBlockSet",
    "DeleteCustomBlock",
    "DeleteLesson",
    "DeleteRun",
    "DeleteWorld",
    "Describe",
    "Description",
    "DisconnectRobot",
    "Document",
    "DownloadLibrary",
    "Drawing",
    "Drive",
    "DuplicateCustomBlock",
    "EditBlocks",
    "EditText",
    "Ended",
    "ExamineLesson",
    "ExaminedStep",
    "ExampleChoice",
    "Export",
    "ExportBlockSet",
    "ExportCustomBlock",
    "ExportLesson",
    "ExportTags",
    "ExportWorld",
    "Exportable",
    "ExportableBlocks",
    "ExportableFunction",
    "Failed",
    "File",
    "FindRobots",
    "Format",
    "FromPage",
    "GoalNow",
    "HandleRobot",
    "History",
    "HoldKeys",
    "Id",
    "Import",
    "ImportCustomBlock",
    "ImportLesson",
    "ImportLessonFolder",
    "ImportLibraries",
    "ImportOriginal",
    "ImportWorld",
    "InputWanted",
    "InstallOffered",
    "InstalledLibrary",
    "Introduce",
    "KeepPicture",
    "KeptRun",
    "KeptRuns",
    "KeysWanted",
    "KnownRobot",
    "LessonAttempt",
    "LessonChecked",
    "LessonChoice",
    "LessonExamined",
    "LessonExported",
    "LessonGoal",
    "LessonGoals",
    "LessonHint",
    "LessonHints",
    "LessonImported",
    "LessonNotes",
    "LessonProblem",
    "LessonPuzzle",
    "LessonQuiz",
    "LessonSaved",
    "LessonShown",
    "LessonStep",
    "LessonText",
    "LessonToEdit",
    "LessonTried",
    "LessonWords",
    "Lessons",
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
    "ListLessons",
    "ListLibraries",
    "ListProjects",
    "ListRuns",
    "LookBack",
    "MakeLesson",
    "MakeLibrary",
    "MakeRobot",
    "MakeWorld",
    "Message",
    "Name",
    "NameRobot",
    "NameRun",
    "NearbyRobot",
    "Network",
    "New",
    "Notation",
    "Noted",
    "OfferedCode",
    "Open",
    "OpenExample",
    "OpenRun",
    "OpenTab",
    "Opened",
    "OriginalImported",
    "PaletteChanged",
    "Past",
    "PastRun",
    "Pause",
    "Place",
    "PlaceRobot",
    "Predicted",
    "Printed",
    "PrintedByRobots",
    "PrintedPart",
    "Problem",
    "ProjectEntry",
    "ProjectRenamed",
    "Projects",
    "PuzzleJudged",
    "Questions",
    "QuizJudged",
    "ReadBlockSet",
    "ReadCalls",
    "ReadCallsBeside",
    "ReadContainment",
    "ReadLessonNotes",
    "ReadLibraries",
    "ReadNetwork",
    "ReadPastPicture",
    "ReadPrediction",
    "ReadQuestions",
    "ReadRunsOn",
    "ReadSettings",
    "ReadTags",
    "ReadTimeline",
    "ReadValues",
    "ReadWorld",
    "RecoverBlocks",
    "RecoverText",
    "Redo",
    "RemoveLibrary",
    "Rename",
    "RenameProject",
    "RenameTab",
    "RenameWorld",
    "ReopenTab",
    "ResetWorld",
    "RestartStep",
    "Restore",
    "RestoreCustomBlock",
    "RestoreWorld",
    "Resume",
    "Robot",
    "RobotBegun",
    "RobotChoice",
    "RobotConnected",
    "RobotCorrected",
    "RobotLink",
    "RobotMade",
    "RobotProblem",
    "RobotValues",
    "Robots",
    "RobotsNearby",
    "Run",
    "RunShown",
    "RunState",
    "RunStep",
    "RunningLine",
    "RunsCompared",
    "RunsOn",
    "SaveAs",
    "SaveBlockSet",
    "SaveCustomBlock",
    "SaveLesson",
    "SaveTags",
    "SaveWorld",
    "Saved",
    "Scene",
    "Seen",
    "Sensor",
    "SetBreakpoints",
    "SetRobotCount",
    "SetSpeed",
    "Setting",
    "Settings",
    "SettingsTable",
    "ShortText",
    "ShowStep",
    "ShowVariant",
    "SkillClash",
    "SolvedStep",
    "Sound",
    "Stage",
    "StartLesson",
    "StateName",
    "Step",
    "Stop",
    "StopChecking",
    "StopTrying",
    "StrokePart",
    "Tab",
    "TabOpened",
    "TabRobot",
    "Tabs",
    "Tags",
    "TagsRead",
    "TakeHint",
    "TakenIn",
    "Telemetry",
    "Text",
    "TimeMark",
    "Timeline",
    "ToPage",
    "TriedProgram",
    "TryCustomBlock",
    "TryLesson",
    "TryRobot",
    "TwinFinding",
    "Undo",
    "UnreachableGoal",
    "UseLibrary",
    "UseRobot",
    "ValueThere",
    "ValuesThere",
    "Variables",
    "Verdict",
    "Version",
    "View",
    "WatchCamera",
    "Welcome",
    "WhenNow",
    "WhyAnswer",
    "WhyQuestion",
    "WhySentence",
    "WorldChecked",
    "WorldChoice",
    "WorldDeleted",
    "WorldExported",
    "WorldMade",
    "WorldToEdit",
    "Worlds",
    "WrongProgram",
]
