"""What a block of one's own is: a Python file, and what is chosen for the blocks that it makes."""

import re
import unicodedata
from dataclasses import dataclass
from typing import Literal

from learnblock.blocks.configuration import BlockConfiguration
from learnblock.blocks.written import written
from learnblock.errors import Diagnostic, OwnBlockError
from learnblock.files import is_device_name

#: Where a problem lies.
Part = Literal["name", "source", "configuration"]
LONGEST_NAME = 60

# No separators and no dots, and neither end may be what Windows strips or Unix hides.
_NAME = re.compile(r"[^\W_](?:[\w -]*[\w-])?")


@dataclass(frozen=True, slots=True)
class Problem:
    """Something that is wrong or doubtful, and where."""

    part: Part
    diagnostic: Diagnostic

    @property
    def is_error(self) -> bool:
        return self.diagnostic.severity == "error"


@dataclass(frozen=True, slots=True)
class Checked:
    """What a check has found.

    Args:
        problems: in the order of each part.
        blocks: as they would be, as far as the source can be read.
        chosen: what is chosen for them besides what the source says, as JSON; this is saved.
    """

    problems: tuple[Problem, ...]
    blocks: tuple[BlockConfiguration, ...] = ()
    chosen: str = ""

    @property
    def complete(self) -> str:
        """The configuration of the blocks with all that is known of them, as JSON."""
        return written(self.blocks) if self.blocks else ""

    @property
    def errors(self) -> tuple[Problem, ...]:
        """The problems that keep it from being saved."""
        return tuple(problem for problem in self.problems if problem.is_error)

    def require_no_errors(self, name: str) -> None:
        """Refuse what cannot be saved.

        Raises:
            OwnBlockError: it has errors.
        """
        if self.errors:
            raise OwnBlockError(f"{name}.py", [problem.diagnostic for problem in self.errors])


@dataclass(frozen=True, slots=True)
class OwnBlock:
    """A file of the user's own.

    Args:
        name: of the file, without the ending.
        source: its Python.
        configuration: what is chosen for its blocks, as JSON; empty for nothing.
        functions: the names of its skills, also while it is no Python.
        category: the tab of the first.
        problems: of both texts.
    """

    name: str
    source: str
    configuration: str
    functions: tuple[str, ...]
    category: str
    problems: tuple[Problem, ...]


def checked_name(name: str) -> str:
    """The name in the form in which files are called.

    Raises:
        OwnBlockError: no block of one's own can be called so.
    """
    name = unicodedata.normalize("NFC", name)
    wrong = ""
    if not _NAME.fullmatch(name) or len(name) > LONGEST_NAME:
        wrong = (
            f"a block cannot be called {name!r:.80}: letters, digits, blanks, `-` and `_` make a"
            f" name, at most {LONGEST_NAME} of them, and it begins with a letter or digit"
        )
    elif is_device_name(name):
        wrong = f"`{name}` is a device's name on Windows: choose another one"
    if wrong:
        raise OwnBlockError(name, [Diagnostic("wrong-name", wrong)])
    return name
