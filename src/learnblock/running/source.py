"""Source files of programs."""

from dataclasses import dataclass
from pathlib import Path

from learnblock import language
from learnblock.errors import Diagnostic, ProgramError
from learnblock.i18n import Phrase
from learnblock.language.python.imports import PACKAGE
from learnblock.language.python.robot_import import robot_import
from learnblock.language.tree.nodes import Import
from learnblock.language.tree.nodes import Program as Tree
from learnblock.runtime.limits import MEGABYTE

#: A program larger than this, in bytes, was not written by a person.
LARGEST_PROGRAM = 4 * MEGABYTE


@dataclass(frozen=True)
class Source:
    """A source file.

    Args:
        path: the path as the user gave it.
        text: its content.
        tree: the program as a tree.
        is_python: whether the text is Python.
    """

    path: Path
    text: str
    tree: Tree
    is_python: bool = False

    @property
    def imports(self) -> frozenset[str]:
        """The libraries and files that it imports."""
        return frozenset(item.module for item in self.tree.items if isinstance(item, Import))

    @property
    def libraries(self) -> frozenset[str]:
        """The imports whose skills become skills of the robot: in Block-Text, all imports."""
        if not self.is_python:
            return self.imports
        return frozenset(name for name in self.imports if f"{PACKAGE}.{name} import" in self.text)

    @property
    def robot(self) -> str | None:
        """The module of the robot that a Python file imports; None for Block-Text."""
        match = robot_import(self.text) if self.is_python else None
        return match[1] if match else None


def read(path: Path) -> Source:
    """Read a program in Block-Text (.bt) or Python (.py).

    Raises:
        ProgramError: it is invalid; the error lists every mistake found.
        OSError: it cannot be read.
    """
    name = str(path)
    ending = path.suffix.lower()
    if ending not in {".bt", ".py"}:
        problem = Diagnostic("unknown-notation", Phrase("run-unknown-file-type"))
        raise ProgramError(name, [problem])
    return source_of(path, read_text(path), is_python=ending == ".py")


def source_of(path: Path, text: str, *, is_python: bool) -> Source:
    """Read the text of a program.

    Raises:
        ProgramError: it is invalid; the error lists every mistake found.
    """
    notation = language.from_python if is_python else language.parse
    return Source(path, text, notation(text, str(path)), is_python)


def read_text(path: Path) -> str:
    """Read the text of a program's file.

    Raises:
        ProgramError: it is too large or not UTF-8.
        OSError: it cannot be read.
    """
    with path.open("rb") as file:
        data = file.read(LARGEST_PROGRAM + 1)
    if len(data) > LARGEST_PROGRAM:
        limit = LARGEST_PROGRAM // MEGABYTE
        too_large = Phrase("file-too-large", name=path.name, limit=limit)
        raise ProgramError(str(path), [Diagnostic("too-large", too_large)])
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        not_utf_8 = Phrase("run-not-utf-8", byte=f"{data[error.start]:#x}")
        raise ProgramError(str(path), [Diagnostic("not-utf-8", not_utf_8, line)]) from error
