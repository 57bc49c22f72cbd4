"""Projects: programs with their robots in one world; usually it is one robot."""

import re
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated

from msgspec import Meta, Struct

from learnblock.blocks.block_sets import EVERYTHING, BlockSet
from learnblock.errors import Diagnostic, ProjectError
from learnblock.i18n import Phrase
from learnblock.language.workspace.blocks import Workspace
from learnblock.project.files.carried import NOTHING, Carried
from learnblock.running import DEFAULT_ROBOT
from learnblock.storage.files import is_device_name

LONGEST_NAME = 100
#: The maximum number of characters of a robot's name.
LONGEST_PART_NAME = 40
MOST_BREAKPOINTS = 1000
#: The maximum number of block sets saved in one project.
MOST_BLOCK_SETS = 8

BlockId = Annotated[str, Meta(min_length=1, max_length=100)]

# No separators, no first character that hides a file on Unix, no last one that Windows strips.
_NAME = re.compile(r"[^\W_](?:[\w .-]*[\w-])?")


@dataclass(frozen=True)
class ProjectPart:
    """One of the programs of a project, with its robot or several robots of one kind.

    Args:
        name: the robot's name in the world, in messages and on its tab; several are numbered.
        blocktext: the program in Block-Text.
        python: the Python that its author wrote by hand; None if it is generated.
        workspace: its blocks; None to lay them out.
        robot: the name of the kind of robot.
        breakpoints: the ids of blocks.
        count: how many robots run it.
    """

    name: str
    blocktext: str = ""
    python: str | None = None
    workspace: Workspace | None = None
    robot: str = DEFAULT_ROBOT
    breakpoints: tuple[str, ...] = ()
    count: int = 1

    @property
    def is_python(self) -> bool:
        """Whether its author wrote it in Python."""
        return self.python is not None

    @property
    def text(self) -> str:
        """The text that its author wrote, which the other notation follows."""
        return self.blocktext if self.python is None else self.python


@dataclass(frozen=True)
class Project:
    """A program with the layout of its blocks, its robot and its world; or several in one world.

    Args:
        name: the name, also of its file.
        blocktext: the program in Block-Text.
        python: the Python that its author wrote by hand; None if it is generated.
        workspace: its blocks; None to lay them out.
        robot: its name.
        world: its name; empty for the usual world of the robot.
        breakpoints: the ids of blocks.
        shown: the name of the block set that the palette shows.
        block_sets: the block sets that are saved in the project.
        libraries: the versions with which the program was made, by name.
        tags: the numbers of tags, by name, that this project uses instead of the user's.
        carried: the author's own things that the program needs.
        count: how many robots run this program.
        first: the name of the first robot, whose program is the one above; empty for the name of
            the project.
        others: the other programs with their robots.
    """

    name: str
    blocktext: str = ""
    python: str | None = None
    workspace: Workspace | None = None
    robot: str = DEFAULT_ROBOT
    world: str = ""
    breakpoints: tuple[str, ...] = ()
    shown: str = EVERYTHING
    block_sets: tuple[BlockSet, ...] = ()
    libraries: Mapping[str, str] = field(default_factory=dict)
    tags: Mapping[str, int] = field(default_factory=dict)
    carried: Carried = NOTHING
    count: int = 1
    first: str = ""
    others: tuple[ProjectPart, ...] = ()

    @property
    def parts(self) -> tuple[ProjectPart, ...]:
        """All programs with their robots."""
        first = ProjectPart(
            name=self.first or self.name[:LONGEST_PART_NAME].rstrip(" ."),
            blocktext=self.blocktext,
            python=self.python,
            workspace=self.workspace,
            robot=self.robot,
            breakpoints=self.breakpoints,
            count=self.count,
        )
        return (first, *self.others)

    def count_robots(self) -> int:
        """How many robots there are."""
        return sum(part.count for part in self.parts)

    @property
    def has_several(self) -> bool:
        """Whether there are several robots, which need names."""
        return self.count_robots() > 1

    def with_parts(self, parts: Sequence[ProjectPart]) -> "Project":
        """The project with other programs and robots."""
        first, *others = parts
        return replace(
            self,
            count=first.count,
            first=first.name if others or first.count > 1 else "",
            blocktext=first.blocktext,
            python=first.python,
            workspace=first.workspace,
            robot=first.robot,
            breakpoints=first.breakpoints,
            others=tuple(others),
        )


class ProjectEntry(Struct, frozen=True):
    """A project in the list of a folder.

    Args:
        name: its name.
        changed: when it was changed, in seconds since 1970.
        picture: when its picture was taken; 0 if it has none.
    """

    name: str
    changed: float
    picture: float = 0.0


def is_plain(name: str) -> bool:
    """Whether a name has no separators or other characters that files can't have everywhere."""
    return bool(_NAME.fullmatch(name))


def is_part_name(name: str) -> bool:
    """Whether a robot of a project can have this name."""
    return len(name) <= LONGEST_PART_NAME and is_plain(name)


def checked_name(name: str) -> str:
    """Check a name, and return it in the form of file names.

    Raises:
        ProjectError: a project can't have this name.
    """
    name = unicodedata.normalize("NFC", name)
    if not is_plain(name) or len(name.encode("utf-8", "replace")) > LONGEST_NAME:
        message = Phrase("project-name-wrong", name=name[:120], limit=LONGEST_NAME)
        raise ProjectError(name, [Diagnostic("wrong-name", message)])
    if is_device_name(name):
        message = Phrase("project-name-device", name=name)
        raise ProjectError(name, [Diagnostic("wrong-name", message)])
    return name


def is_same_program(first: Project, second: Project) -> bool:
    """Whether two projects have the same programs on the same robots in the same world."""

    def program(project: Project) -> tuple[object, ...]:
        parts = ((part.blocktext, part.python, part.robot, part.count) for part in project.parts)
        return project.world, *parts

    return program(first) == program(second)
