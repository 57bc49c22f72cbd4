"""Projects from single files, and as single files: programs, projects, files of the original."""

from typing import TYPE_CHECKING, Literal

from learnblock import language, robots
from learnblock.blocks.known import all_configurations
from learnblock.errors import Diagnostic, LearnBlockError, ProgramError, ProjectError
from learnblock.i18n import Phrase
from learnblock.language.python.robot_import import robot_import
from learnblock.project.document.views import LONGEST_TEXT
from learnblock.project.files import ENDING
from learnblock.project.files.packing import encode_whole
from learnblock.project.files.project import Project, ProjectPart
from learnblock.project.files.project_file import decode
from learnblock.running import DEFAULT_ROBOT

if TYPE_CHECKING:
    from learnblock.importing import FindLibrary, ImportReport

Format = Literal["bt", "py", "learnblock"]


def project_of(filename: str, text: str) -> Project:
    """Create a project from a file's text; it is called as the file, and is not saved yet.

    Args:
        filename: the file name, ending in .bt, .py or .learnblock.
        text: the text of a program, which may have mistakes, or of a project.

    Raises:
        ProjectError: the file has another type, or is not a valid project.
    """
    stem, _, ending = filename.replace("\\", "/").rpartition("/")[2].rpartition(".")
    ending = ending.lower()
    text = text.removeprefix("\ufeff").replace("\r\n", "\n")
    if ending in ("bt", "py"):
        _require_short(text, filename)
    if ending == "bt":
        return Project(stem, text)
    if ending == "py":
        return _from_python(stem, text)
    if f".{ending}" != ENDING:
        raise ProjectError(filename, [Diagnostic("unknown-file", Phrase("project-type"))])
    project = decode(text.encode("utf-8", "replace"), stem)
    for part in project.parts:
        _require_short(part.blocktext, filename)
        _require_short(part.python or "", filename)
    return project


def project_of_original(
    filename: str, data: bytes, find_library: "FindLibrary"
) -> "tuple[Project, ImportReport]":
    """Create a project from a file of the original LearnBlock; it is called as the file.

    Args:
        filename: ends in .blockProject or .lb.
        data: the file.
        find_library: finds the libraries that a project imports.

    Raises:
        FileError: the file is damaged, or has another type.
    """
    from learnblock import importing  # noqa: PLC0415 - few pages open such files

    stem, _, ending = filename.replace("\\", "/").rpartition("/")[2].rpartition(".")
    skills = all_configurations()
    if f".{ending}".lower() == importing.ENDING.lower():
        imported = importing.import_project(data, filename, skills, find_library)
    elif f".{ending}".lower() == importing.LIBRARY_ENDING:
        imported = importing.import_text(data, filename, skills)
    else:
        raise ProjectError(filename, [Diagnostic("unknown-file", Phrase("import-type"))])
    _require_short(imported.blocktext, filename)
    project = Project(stem, imported.blocktext, workspace=imported.workspace)
    return project, imported.report


def export(project: Project, format_: Format, part: int = 0) -> tuple[str, str]:
    """Export a project, or the program of one of its robots: the name and text of a file.

    Args:
        project: the project.
        format_: the format; only `learnblock` has all robots.
        part: the index of the robot whose program is exported.

    Raises:
        ProgramError: the format is Python and the program has mistakes.
        ProjectError: the project can't be written as a file.
    """
    if format_ == "learnblock":
        return f"{project.name}.{format_}", encode_whole(project, leaves=True).decode()
    program_part = project.parts[part]
    name = program_part.name if project.has_several else project.name
    if format_ == "bt":
        return f"{name}.{format_}", program_part.blocktext
    text = program_part.python if program_part.python is not None else _python(program_part)
    return f"{name}.{format_}", text


def _require_short(text: str, filename: str) -> None:
    """Check that a program from a page can be edited there.

    Raises:
        ProjectError: it is longer than any program that a page may send.
    """
    if len(text) > LONGEST_TEXT:
        message = Phrase("project-program-too-long", size=len(text), limit=LONGEST_TEXT)
        raise ProjectError(filename, [Diagnostic("too-large", message)])


def _from_python(name: str, text: str) -> Project:
    """Create a project from a Python file, which may have mistakes."""
    module = robot_import(text)
    robot = _robot_of(module[1]) if module else DEFAULT_ROBOT
    try:
        blocktext = language.format(language.from_python(text))
    except ProgramError:
        # The page shows the mistakes in the Python itself.
        blocktext = ""
    return Project(name, blocktext, text, robot=robot)


def _robot_of(module: str) -> str:
    try:
        return robots.find(module).name
    except LearnBlockError:
        # The robot is not installed; the program can still be parsed, and run on another robot.
        return DEFAULT_ROBOT


def _python(part: ProjectPart) -> str:
    tree = language.parse(part.blocktext, f"{part.name}.bt")
    return language.to_python(tree, robots.module_of(part.robot)).text
