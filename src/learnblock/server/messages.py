"""The whole conversation between the server and a page.

A page speaks first: `Open` or `New`; everything else is about the project it has opened. Each
message is a JSON object whose `kind` names it; camera frames alone are binary (`CameraFrame` says
how). ``python -m learnblock.server.typescript`` writes the page's types from this module.
"""

from typing import Annotated, Any, Literal

from msgspec import Meta, Struct, field

from learnblock.blocks.block_sets import BlockSet
from learnblock.language.workspace import Workspace

#: Longer texts are no program that a person wrote.
LONGEST_TEXT = 1_000_000
MOST_BREAKPOINTS = 1000
#: Names of tags; there are 587 tags, and each may have several.
MOST_TAGS = 2000
#: Sets of blocks that a project takes along.
MOST_CARRIED = 8
#: Of a function.
MOST_ARGUMENTS = 100
#: That are imported at once.
MOST_LIBRARIES = 20
#: Of a library, or that are made one.
MOST_SKILLS = 200

Notation = Literal["blocktext", "python"]
View = Literal["blocks", "blocktext", "python"]
StateName = Literal["idle", "starting", "running", "paused", "held", "input", "ended"]
Text = Annotated[str, Meta(max_length=LONGEST_TEXT)]
Name = Annotated[str, Meta(min_length=1, max_length=100)]
#: A name, or nothing.
ShortText = Annotated[str, Meta(max_length=100)]
#: Of a block.
Id = Annotated[str, Meta(min_length=1, max_length=100)]
Coordinate = Annotated[float, Meta(ge=-5000, le=5000)]


class Message(Struct, tag_field="kind", omit_defaults=True, frozen=True):
    """A message of the conversation."""


# The page speaks: projects.


class Open(Message, frozen=True):
    """Open a project; the page then hears `Opened`."""

    name: Name


class New(Message, frozen=True):
    """Make a project and open it.

    Args:
        name: made unique by a number behind it where there is one of that name.
        example: begin with this example, or else with an empty program.
    """

    name: Name = "program"
    example: str | None = None


class Import(Message, frozen=True):
    """Make a project from a file and open it.

    Args:
        filename: ends in .bt, .py or .learnblock.
        text: what stands in it.
    """

    filename: Name
    text: Text


class SaveAs(Message, frozen=True):
    """Go on with a copy of the project under another name."""

    name: Name


class Delete(Message, frozen=True):
    """Delete a project that is not open; it is kept in the folder's trash."""

    name: Name


class Export(Message, frozen=True):
    """Ask for a file of the open project: `File`."""

    format: Literal["bt", "py", "learnblock"]


class ListProjects(Message, frozen=True):
    """Ask for `Projects`."""


class ListHistory(Message, frozen=True):
    """Ask for `History`."""


class Restore(Message, frozen=True):
    """Go back to a version; the present one becomes a version itself."""

    version: Name


# The page speaks: the program.


class EditBlocks(Message, frozen=True):
    """The workspace as it is now.

    Args:
        edit: counts the page's edits; the `Document` that answers has the same number.
    """

    edit: int
    workspace: Workspace


class EditText(Message, frozen=True):
    """A text as it is now."""

    edit: int
    notation: Notation
    text: Text


class Undo(Message, frozen=True):
    """Take the last edit back, whichever view it was made in."""


class Redo(Message, frozen=True):
    """Make the last edit that was taken back again."""


class Format(Message, frozen=True):
    """Give Block-Text its canonical form."""


class Rename(Message, frozen=True):
    """Rename a variable, a function or a `when` everywhere; answered by a `Document`."""

    sort: Literal["variable", "function", "when"]
    name: Name
    new: Name


class Complete(Message, frozen=True):
    """Ask for `Completions` at a place (both from 1) of a text as last sent."""

    request: int
    notation: Notation
    line: int
    column: int
    language: Name = "en"


class Describe(Message, frozen=True):
    """Ask for the `Description` of what stands at a place of a text, and where it is defined."""

    request: int
    notation: Notation
    line: int
    column: int
    language: Name = "en"


class SetBreakpoints(Message, frozen=True):
    """Hold the program before these blocks."""

    blocks: Annotated[list[Id], Meta(max_length=MOST_BREAKPOINTS)]


# The page speaks: running.


class ChooseRobot(Message, frozen=True):
    name: Name


class ChooseWorld(Message, frozen=True):
    name: Name


class Run(Message, frozen=True):
    """Run the program from the beginning.

    Args:
        paused: hold it before its first line.
    """

    paused: bool = False


class Stop(Message, frozen=True):
    """Stop the program and the robot."""


class Pause(Message, frozen=True):
    """Hold program and world where they are."""


class Resume(Message, frozen=True):
    """Go on after a pause or a breakpoint."""


class Step(Message, frozen=True):
    """Run to the next line; `over` does not follow calls into functions."""

    over: bool = False


class SetSpeed(Message, frozen=True):
    """How fast simulated time runs: times real time; None is as fast as it goes."""

    factor: Annotated[float, Meta(ge=0.01, le=100)] | None


class Answer(Message, frozen=True):
    """The line that the program asked for by `InputWanted`."""

    text: Annotated[str, Meta(max_length=10_000)]


class ResetWorld(Message, frozen=True):
    """Put everything back to where it was at first; only while no program runs."""


class PlaceRobot(Message, frozen=True):
    """Set the robot down elsewhere; the next run starts there. Only while the world stands still.

    Args:
        x: mm east.
        y: mm north.
        heading: degrees clockwise, 0 looks east.
    """

    x: Coordinate
    y: Coordinate
    heading: Annotated[float, Meta(ge=-360, le=360)]


class Drive(Message, frozen=True):
    """Drive by hand while no program runs; told again at least twice a second, else it stops.

    Args:
        advance: of the robot's fastest, -1 to 1, forward positive.
        rotation: of the robot's fastest, -1 to 1, clockwise positive.
    """

    advance: Annotated[float, Meta(ge=-1, le=1)]
    rotation: Annotated[float, Meta(ge=-1, le=1)]


class WatchCamera(Message, frozen=True):
    """Send camera frames from now on, or no more."""

    on: bool


# The page speaks: worlds.


class ReadWorld(Message, frozen=True):
    """Ask for a world to edit: `WorldToEdit`."""

    name: Name


class CheckWorld(Message, frozen=True):
    """Ask what is wrong with a world, and how it looks: `WorldChecked`."""

    world: dict[str, Any]


class SaveWorld(Message, frozen=True):
    """Save a world in the user's folder and choose it; `WorldChecked` when it is wrong.

    Args:
        name: to be, and of the file.
        world: its values.
        replace: the user's own world of that name, if there is one; otherwise that is refused.
    """

    name: Name
    world: dict[str, Any]
    replace: bool = False


# The page speaks: blocks of one's own.


class ListOwnBlocks(Message, frozen=True):
    """Ask for `OwnBlocks`."""


class CheckOwnBlock(Message, frozen=True):
    """Ask what is wrong with a block, and how it looks: `OwnBlockChecked`.

    Args:
        request: comes back with the answer.
        name: of its file, without the ending; empty where it has none yet.
        source: the Python of its functions.
        configuration: what is chosen for them, as JSON; empty for nothing.
        replaces: the name that it is saved under, since it clashes with everything but itself.
        language: of the previews.
    """

    request: int
    name: ShortText
    source: Text
    configuration: Text = ""
    replaces: ShortText = ""
    language: Name = "en"


class SaveOwnBlock(Message, frozen=True):
    """Save a block: `OwnBlockSaved`, or `OwnBlockChecked` with the request 0 when it is wrong.

    Args:
        name: to be, of its file.
        source: see `CheckOwnBlock`.
        configuration: likewise.
        replaces: the name that it had until now; empty for a new one.
    """

    name: Name
    source: Text
    configuration: Text = ""
    replaces: ShortText = ""


class TryOwnBlock(Message, frozen=True):
    """Run one function on the current robot, as a program of one line, without saving it.

    What it returns is printed; how it ends is `Ended`, with `tried`.

    Args:
        name: see `CheckOwnBlock`.
        source: likewise.
        function: which; empty for the first.
        arguments: in the order of its parameters; those left out have their defaults.
    """

    name: ShortText
    source: Text
    function: ShortText = ""
    arguments: Annotated[list[Any], Meta(max_length=MOST_ARGUMENTS)] = field(default_factory=list)


class DuplicateOwnBlock(Message, frozen=True):
    """Copy a block; its functions get names that are free. `OwnBlockSaved` follows."""

    name: Name
    new: Name


class DeleteOwnBlock(Message, frozen=True):
    """Delete a block; it is kept until one of the same name is deleted."""

    name: Name


class RestoreOwnBlock(Message, frozen=True):
    """Take back that a block was deleted: `OwnBlockSaved`."""

    name: Name


class ExportOwnBlock(Message, frozen=True):
    """Ask for a block as one file: `File`."""

    name: Name


class ImportOwnBlock(Message, frozen=True):
    """Add the block in a file that was exported: `OwnBlockSaved`, or `Failed` if it cannot be.

    Args:
        content: of the file.
        replace: the block of the same name, if there is one; otherwise that is refused.
    """

    content: Text
    replace: bool = False


# The page speaks: which blocks are shown.


class ListBlockSets(Message, frozen=True):
    """Ask for `BlockSets`."""


class ChooseBlockSet(Message, frozen=True):
    """Show the blocks of a set in this project, which takes the set along: `BlocksShown`."""

    set: BlockSet


class ReadBlockSet(Message, frozen=True):
    """Ask for the set in a file's text: `BlockSetRead`."""

    filename: Name
    text: Text


class SaveBlockSet(Message, frozen=True):
    """Save a set in the user's folder.

    Args:
        set: under its name.
        replace: the user's own set of that name, if there is one; otherwise that is refused.
    """

    set: BlockSet
    replace: bool = False


class DeleteBlockSet(Message, frozen=True):
    """Delete a set from the user's folder; projects that took it along keep it."""

    name: Name


class ExportBlockSet(Message, frozen=True):
    """Ask for a set as a file: `File`."""

    set: BlockSet


# The page speaks: settings of this machine.


class ReadSettings(Message, frozen=True):
    """Ask for what is set of a real robot, or of perception: `SettingsTable`.

    Args:
        robot: its name; empty for perception.
    """

    robot: ShortText = ""


class ChangeSettings(Message, frozen=True):
    """Change settings, all of them or none; `SettingsTable` says what is wrong.

    Args:
        robot: its name; empty for perception.
        values: by name; None puts a default back.
        agreed: the user has read why feelings are not looked for on real cameras.
    """

    robot: ShortText
    values: Annotated[dict[ShortText, Any], Meta(max_length=100)]
    agreed: bool = False


# The page speaks: names of tags.


class SaveTags(Message, frozen=True):
    """Save the dictionary of tags; all pages then hear `Tags`."""

    names: Annotated[dict[ShortText, int], Meta(max_length=MOST_TAGS)]


class ReadTags(Message, frozen=True):
    """Ask for the names in a file's text, TOML or CSV: `TagsRead`."""

    filename: Name
    text: Text


class ExportTags(Message, frozen=True):
    """Ask for the dictionary of tags as a file, or its tags on paper: `File`."""

    format: Literal["toml", "csv", "html"] = "toml"


# The page speaks: libraries.


class LibraryFile(Struct, frozen=True, omit_defaults=True):
    """A library in one file.

    Args:
        filename: as the user calls it.
        content: its bytes, in base 64.
        renames: other names for skills of it.
    """

    filename: Name
    content: Annotated[bytes, Meta(max_length=LONGEST_TEXT)]
    renames: Annotated[dict[ShortText, ShortText], Meta(max_length=MOST_SKILLS)] = {}


class ListLibraries(Message, frozen=True):
    """Ask which libraries are installed: `Libraries`."""


class ListExportable(Message, frozen=True):
    """Ask what a library could be made of: `Exportable`."""


class ReadLibraries(Message, frozen=True):
    """Ask what is in files, and what keeps them from being imported: `LibrariesRead`."""

    files: Annotated[tuple[LibraryFile, ...], Meta(max_length=MOST_LIBRARIES)]


class ImportLibraries(Message, frozen=True):
    """Install libraries, all or none; `replace` versions that are as new. Then `Libraries`."""

    files: Annotated[tuple[LibraryFile, ...], Meta(max_length=MOST_LIBRARIES)]
    replace: bool = False


class RemoveLibrary(Message, frozen=True):
    """Take an installed library away: all pages hear `Libraries`."""

    name: Name


class DownloadLibrary(Message, frozen=True):
    """Ask for an installed library in one file: `LibraryMade`."""

    name: Name


class MakeLibrary(Message, frozen=True):
    """Ask for a library of functions of the program and blocks of one's own: `LibraryMade`.

    Args:
        name: by which programs import it.
        version: one to three numbers.
        title: the tab of the palette by language code.
        functions: those that they call come along.
        own: files of blocks of one's own.
    """

    name: Name
    version: Name
    title: Annotated[dict[ShortText, ShortText], Meta(max_length=20)] = {}
    functions: Annotated[tuple[Name, ...], Meta(max_length=MOST_SKILLS)] = ()
    own: Annotated[tuple[Name, ...], Meta(max_length=MOST_SKILLS)] = ()


class UseLibrary(Message, frozen=True):
    """Have the program import an installed library."""

    name: Name


FromPage = (
    Open
    | New
    | Import
    | SaveAs
    | Delete
    | Export
    | ListProjects
    | ListHistory
    | Restore
    | EditBlocks
    | EditText
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
    | ListOwnBlocks
    | CheckOwnBlock
    | SaveOwnBlock
    | TryOwnBlock
    | DuplicateOwnBlock
    | DeleteOwnBlock
    | RestoreOwnBlock
    | ExportOwnBlock
    | ImportOwnBlock
    | ListBlockSets
    | ChooseBlockSet
    | ReadBlockSet
    | SaveBlockSet
    | DeleteBlockSet
    | ExportBlockSet
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
    | UseLibrary
)


# The server speaks: what there is.


class RobotChoice(Struct, frozen=True):
    """A robot one can choose; `simulated` ones live in a world."""

    name: str
    title: str
    simulated: bool


class WorldChoice(Struct, frozen=True):
    """A world one can choose; `own` ones can be edited in place."""

    name: str
    title: str
    own: bool


class ExampleChoice(Struct, frozen=True):
    """An example to open, with the robot and world that suit it."""

    name: str
    title: str
    description: str
    robot: str
    world: str


class Welcome(Message, frozen=True):
    """The first message of the server."""

    version: str
    robots: tuple[RobotChoice, ...]
    worlds: tuple[WorldChoice, ...]
    examples: tuple[ExampleChoice, ...]
    folder: str


class Worlds(Message, frozen=True):
    """The worlds there are now, after one was saved."""

    worlds: tuple[WorldChoice, ...]


class ProjectEntry(Struct, frozen=True):
    """A project; `changed` is seconds since 1970."""

    name: str
    changed: float


class Projects(Message, frozen=True):
    """Every project, the last changed first."""

    projects: tuple[ProjectEntry, ...]


class Opened(Message, frozen=True):
    """A project is open; a `Document`, a `Scene` and a `RunState` follow."""

    name: str
    robot: str
    world: str
    breakpoints: tuple[str, ...] = ()


class Settings(Message, frozen=True):
    """What is set for the next run, after anyone has changed it."""

    robot: str
    world: str
    breakpoints: tuple[str, ...] = ()


class File(Message, frozen=True):
    """A file to download."""

    filename: str
    text: str


class Version(Struct, frozen=True):
    """A version of the program that one can go back to.

    Args:
        id: for `Restore`.
        time: seconds since 1970.
        reason: why it was kept.
        lines: of its Block-Text.
    """

    id: str
    time: float
    reason: Literal["run", "time", "restored", "opened"]
    lines: int


class PastRun(Struct, frozen=True):
    """A run of the program: see `Ended`."""

    time: float
    robot: str
    world: str
    ended: str
    seconds: float
    goals: tuple[str, ...]
    trace_sha256: str
    version: str


class History(Message, frozen=True):
    """What was, the newest first."""

    versions: tuple[Version, ...]
    runs: tuple[PastRun, ...]


class Saved(Message, frozen=True):
    """The project is on disk as it was at `edit`."""

    edit: int


class Failed(Message, frozen=True):
    """A message could not be obeyed; nothing has changed."""

    message: str
    request: str = ""


# The server speaks: the program.


class Problem(Struct, frozen=True, omit_defaults=True):
    """An error or a warning.

    Args:
        code: what kind of problem, for tests and help.
        message: what is wrong and what to do.
        severity: an error keeps the program from running.
        view: the text that `line` and `column` speak of; `blocks` where there is a block alone.
        line: from 1; 0 for all of it.
        column: from 1; 0 for the whole line.
        end_column: behind the last character; 0 where it is not known.
        block: the block it belongs to, if any.
    """

    code: str
    message: str
    severity: Literal["error", "warning"]
    view: View
    line: int = 0
    column: int = 0
    end_column: int = 0
    block: str | None = None


class Place(Struct, frozen=True, array_like=True):
    """Where a statement stands in each view: block, and first and last lines from 1 (0 nowhere)."""

    block: str
    blocktext: int
    blocktext_end: int
    python: int
    python_end: int


class Document(Message, frozen=True):
    """The program as it is now; a view that is None has not changed.

    Args:
        edit: the page's last edit that is in it.
        origin: the view that was edited last.
        blocktext: the text, as its author wrote it if they wrote it.
        python: likewise.
        workspace: with ids and places kept.
        places: every statement in all three views.
        problems: of all views.
        stale: the views that show the last good program, since another one has errors.
    """

    edit: int
    origin: View
    blocktext: str | None = None
    python: str | None = None
    workspace: Workspace | None = None
    places: tuple[Place, ...] = ()
    problems: tuple[Problem, ...] = ()
    stale: tuple[View, ...] = ()
    can_undo: bool = False
    can_redo: bool = False


class Completion(Struct, frozen=True, omit_defaults=True):
    """Something that could stand here.

    Args:
        label: what is shown and filtered by.
        insert: what is inserted.
        sort: skill, function, variable, when, keyword, robot, library.
        detail: its parameters.
        help: one sentence.
        category: of a skill, as sets of blocks name it.
    """

    label: str
    insert: str
    sort: str
    detail: str = ""
    help: str = ""
    category: str = ""


class Completions(Message, frozen=True):
    """They replace the text from `from_column` (from 1) to the place that was asked for."""

    request: int
    from_column: int
    options: tuple[Completion, ...]


class Description(Message, frozen=True):
    """What stands at a place.

    Args:
        title: its name with its parameters; empty when there is nothing to say.
        text: what it does.
        needs: devices that it needs and the chosen robot lacks.
        line: where it is defined in the same text, from 1; 0 for nowhere.
        column: likewise.
        from_column: where its name begins.
        to_column: behind its end.
        sort: of what can be renamed (variable, function, when), else empty.
        name: as `Rename` wants it.
    """

    request: int
    title: str = ""
    text: str = ""
    needs: tuple[str, ...] = ()
    line: int = 0
    column: int = 0
    from_column: int = 0
    to_column: int = 0
    sort: Literal["variable", "function", "when", ""] = ""
    name: str = ""


# The server speaks: running.


class RunState(Message, frozen=True):
    """What the program does.

    Args:
        state: ``idle`` before the first run, ``ended`` after one; ``paused`` holds the world,
            ``held`` holds the program before a line; ``input`` waits for `Answer`.
        block: the block before which it is held.
    """

    state: StateName
    block: str | None = None
    speed: float | None = 1.0


class InputWanted(Message, frozen=True):
    """The program waits for a line."""

    prompt: str


class Printed(Message, frozen=True):
    """What the program printed, at most some thousand characters at once."""

    text: str


class GoalNow(Struct, frozen=True):
    """A goal of the world."""

    name: str
    sort: str
    state: Literal["open", "reached", "failed"]
    time: float | None


class Ended(Message, frozen=True):
    """How a run ended: the report of ``learnblock run``.

    Args:
        ended: one word, such as ``finished``, ``stopped`` or ``error``.
        message: a sentence when it did not end well.
        block: where it went wrong.
        no_effect: skills that had none, each with the device that is missing.
        own_block: the file's name of the own block in which it went wrong, if in one.
        own_line: the line of its source, from 1; 0 where it is not known.
        tried: it was `TryOwnBlock` and no program.
    """

    ended: str
    message: str = ""
    block: str | None = None
    time: float = 0.0
    distance: float | None = None
    goals: tuple[GoalNow, ...] = ()
    emotions: tuple[str, ...] = ()
    no_effect: tuple[tuple[str, str], ...] = ()
    trace_sha256: str = ""
    own_block: str = ""
    own_line: int = 0
    tried: bool = False


class WhenNow(Struct, frozen=True):
    """A `when`: whether it is active, and since how many seconds."""

    name: str
    active: bool
    time: float


class Variables(Message, frozen=True):
    """The program's variables as text: those of the function it is in, and its own."""

    local: dict[str, str]
    shared: dict[str, str]
    whens: tuple[WhenNow, ...] = ()


class Robot(Struct, frozen=True, omit_defaults=True):
    """A robot as it is now.

    Args:
        name: in its world.
        x: mm east.
        y: mm north.
        heading: degrees clockwise, 0 looks east.
        joints: degrees, by key.
        leds: red, green, blue, by key.
        emotion: what it shows; ``none`` is nothing.
    """

    name: str
    x: float
    y: float
    heading: float
    joints: dict[str, float] = field(default_factory=dict)
    leds: dict[str, tuple[int, int, int]] = field(default_factory=dict)
    emotion: str = "none"


class Telemetry(Message, frozen=True):
    """The world as it is now, about twenty times a second while something moves.

    Args:
        time: seconds of the world.
        robots: ours is the first.
        pushed: x, y, heading of what can be pushed, in the order of the world's description:
            boxes with a mass first, then cylinders.
        sensors: readings by sensor, such as ``Distance front 1`` in its unit; None where nothing is
            measured.
        block: the block that runs.
        goals: as they stand.
    """

    time: float
    robots: tuple[Robot, ...]
    pushed: tuple[tuple[float, float, float], ...] = ()
    sensors: dict[str, float | bool | None] = field(default_factory=dict)
    block: str | None = None
    goals: tuple[GoalNow, ...] = ()


class Sound(Message, frozen=True):
    """The robot would be heard.

    Args:
        device: such as ``Speaker``.
        action: such as ``say``.
        values: as the robot was told.
    """

    device: str
    action: str
    values: tuple[Any, ...]


class Seen(Struct, frozen=True, omit_defaults=True):
    """Something that perception found in a camera frame.

    Args:
        sort: tag, face or line.
        label: such as the tag's number.
        corners: x, y in pixels of the frame.
    """

    sort: Literal["tag", "face", "line"]
    label: str
    corners: tuple[tuple[float, float], ...]


class CameraFrame(Message, frozen=True):
    """What the next binary message is: a JPEG of the camera, and what was found in it."""

    width: int
    height: int
    time: float
    seen: tuple[Seen, ...] = ()


class Scene(Message, frozen=True):
    """What stands in the world, for drawing it; `Telemetry` moves it.

    Args:
        name: the world's.
        world: as its file says (`WorldFile`).
        lines: for each painted line the corners of its middle, mm.
        robots: name and description of each (`RobotDescription`).
        start: x, y, heading where the next run begins.
    """

    name: str
    world: dict[str, Any]
    lines: tuple[tuple[tuple[float, float], ...], ...]
    robots: tuple[tuple[str, dict[str, Any]], ...]
    start: tuple[float, float, float] | None = None


class WorldToEdit(Message, frozen=True):
    """A world as its file says (`WorldFile`), and the corners of its lines, mm.

    Args:
        save_as: its own name where it is the user's; else a free one, so that none is replaced.
    """

    name: str
    world: dict[str, Any]
    lines: tuple[tuple[tuple[float, float], ...], ...]
    save_as: str


class WorldChecked(Message, frozen=True):
    """What is wrong with a world; `lines` as in `Scene` when nothing is."""

    problems: tuple[str, ...]
    lines: tuple[tuple[tuple[float, float], ...], ...] = ()


# The server speaks: blocks of one's own.


class OwnBlockProblem(Struct, frozen=True, omit_defaults=True):
    """What is wrong or doubtful in a block.

    Args:
        part: where `line` and `column` lie.
        code: what kind of problem, for tests and help.
        message: what is wrong and what to do.
        severity: an error keeps the block from being saved, and from being used.
        line: from 1; 0 for all of it.
        column: from 1; 0 for the whole line.
        end_column: behind the last character; 0 where it is not known.
    """

    part: Literal["name", "source", "configuration"]
    code: str
    message: str
    severity: Literal["error", "warning"]
    line: int = 0
    column: int = 0
    end_column: int = 0


class OwnBlock(Struct, frozen=True):
    """A file of the user's own, which makes one block or several.

    Args:
        name: of the file, without the ending.
        category: the tab of the palette.
        blocks: the names of its functions.
        source: its Python.
        configuration: what is chosen for them, as JSON; empty for nothing.
        problems: of both.
    """

    name: str
    category: str
    blocks: tuple[str, ...]
    source: str
    configuration: str
    problems: tuple[OwnBlockProblem, ...] = ()


class OwnBlocks(Message, frozen=True):
    """Every block of the user's own; all pages hear it whenever one has changed."""

    blocks: tuple[OwnBlock, ...]


class OwnBlockPreview(Struct, frozen=True):
    """A block as it would look.

    Args:
        name: of the function.
        definition: of the block, as Blockly's JSON has it.
        block: as it lies in the palette, with its shadows.
    """

    name: str
    definition: dict[str, Any]
    block: dict[str, Any]


class OwnBlockChecked(Message, frozen=True):
    """What is wrong with a block, and how it looks.

    Args:
        request: of the question; 0 where it could not be saved.
        problems: of the source, the configuration and the name.
        configuration: complete, as JSON: what the source says and what was chosen. Empty where the
            source cannot be read.
        chosen: the same without the words that the source says by itself, such as those of a
            docstring: this is what is saved, and what to send after something was chosen, or else
            an old docstring goes before a new one.
        previews: each block, in the language that was asked for.
    """

    request: int
    problems: tuple[OwnBlockProblem, ...] = ()
    configuration: str = ""
    chosen: str = ""
    previews: tuple[OwnBlockPreview, ...] = ()


class OwnBlockSaved(Message, frozen=True):
    """A block is saved under this name."""

    name: str


class PaletteChanged(Message, frozen=True):
    """Other blocks are there than before: fetch the palette anew."""


# The server speaks: which blocks are shown.


class BlockSets(Message, frozen=True):
    """Every set one can choose.

    Args:
        ours: from the first lesson to everything.
        own: the user's.
        problems: of files in the user's folder that are no sets.
    """

    ours: tuple[BlockSet, ...]
    own: tuple[BlockSet, ...]
    problems: tuple[str, ...] = ()


class BlocksShown(Message, frozen=True):
    """Which blocks the project's palette shows, and the sets that the project takes along."""

    set: BlockSet
    carried: tuple[BlockSet, ...] = ()


class BlockSetRead(Message, frozen=True):
    """The set in a file, which is not saved yet."""

    set: BlockSet


# The server speaks: settings of this machine.


class Setting(Struct, frozen=True, omit_defaults=True):
    """One setting.

    Args:
        name: of the setting.
        sort: a ``list`` is of texts.
        value: as it is now.
        default: as it is where nobody has chosen.
        allowed: what it may be, in words.
        description: what it is, in words; empty where the name says it.
        least: of a number.
        most: of a number.
        choices: what it may be, where that is one of a few; of a number, the word for none.
        secret: not to be read over anybody's shoulder.
    """

    name: str
    sort: Literal["text", "number", "whole", "choice", "boolean", "list"]
    value: Any
    default: Any
    allowed: str
    description: str = ""
    least: float | None = None
    most: float | None = None
    choices: tuple[str, ...] = ()
    secret: bool = False


class SettingsTable(Message, frozen=True):
    """What is set of a real robot, or of perception.

    Args:
        robot: its name; empty for perception.
        settings: in their order; none for a robot that has none.
        wrong: why nothing was changed: a sentence for each setting that cannot be so.
        problem: why the user's file cannot be read.
    """

    robot: str
    settings: tuple[Setting, ...] = ()
    wrong: dict[str, str] = field(default_factory=dict)
    problem: str = ""


# The server speaks: names of tags.


class Tags(Message, frozen=True):
    """The dictionary of tags: the number of each name; a page hears it first with its project.

    Args:
        problem: why the user's file cannot be read; then there are no names.
    """

    names: dict[str, int]
    problem: str = ""


class TagsRead(Message, frozen=True):
    """The names in a file, which are not saved yet."""

    names: dict[str, int]


# The server speaks: libraries.


class InstalledLibrary(Struct, frozen=True, omit_defaults=True):
    """A library that is installed.

    Args:
        name: by which programs import it.
        version: of one to three numbers; empty where it cannot be read.
        title: by language code.
        description: what it is for.
        skills: the names of its skills.
        problem: why it cannot be used.
    """

    name: str
    version: str = ""
    title: dict[str, str] = {}
    description: str = ""
    skills: tuple[str, ...] = ()
    problem: str = ""


class Libraries(Message, frozen=True):
    """The libraries that are installed; all pages hear it whenever one has changed."""

    libraries: tuple[InstalledLibrary, ...]


class SkillClash(Struct, frozen=True):
    """A skill of a library whose name somebody has; `place` says who."""

    skill: str
    place: str


class LibraryRead(Struct, frozen=True, omit_defaults=True):
    """What is in a file.

    Args:
        filename: as it was sent.
        library: what it would be; None where it is none.
        installed: the version that is installed; empty for none.
        is_newer: than that one.
        clashes: names that somebody has already.
        problem: why it cannot be imported at all, or a new name cannot be given.
    """

    filename: str
    library: InstalledLibrary | None = None
    installed: str = ""
    is_newer: bool = True
    clashes: tuple[SkillClash, ...] = ()
    problem: str = ""


class LibrariesRead(Message, frozen=True):
    """What is in files, in the order in which they were sent; nothing of them was run."""

    files: tuple[LibraryRead, ...]


class ExportableFunction(Struct, frozen=True, omit_defaults=True):
    """A function of the program.

    Args:
        name: of the function.
        parameters: their names.
        takes_along: the functions that it calls.
        problem: why it cannot be part of a library.
    """

    name: str
    parameters: tuple[str, ...]
    takes_along: tuple[str, ...] = ()
    problem: str = ""


class ExportableBlocks(Struct, frozen=True):
    """A file of blocks of the user's own, and the names of these."""

    name: str
    blocks: tuple[str, ...]


class Exportable(Message, frozen=True):
    """What a library could be made of."""

    functions: tuple[ExportableFunction, ...]
    own: tuple[ExportableBlocks, ...]


class LibraryMade(Message, frozen=True):
    """A library in one file, in base 64."""

    filename: str
    content: bytes


ToPage = (
    Welcome
    | Worlds
    | Projects
    | Opened
    | Settings
    | File
    | History
    | Saved
    | Failed
    | Document
    | Completions
    | Description
    | RunState
    | InputWanted
    | Printed
    | Ended
    | Variables
    | Telemetry
    | Sound
    | CameraFrame
    | Scene
    | WorldToEdit
    | WorldChecked
    | OwnBlocks
    | OwnBlockChecked
    | OwnBlockSaved
    | PaletteChanged
    | BlockSets
    | BlocksShown
    | BlockSetRead
    | SettingsTable
    | Tags
    | TagsRead
    | Libraries
    | LibrariesRead
    | Exportable
    | LibraryMade
)
