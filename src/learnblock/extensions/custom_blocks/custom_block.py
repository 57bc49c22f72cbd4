"""A custom block: a Python file, and the configuration of the blocks in it."""

import re
import unicodedata
from dataclasses import dataclass
from typing import Literal

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.schema.writing import written
from learnblock.errors import CustomBlockError, Diagnostic
from learnblock.i18n import Phrase
from learnblock.storage.files import is_device_name

#: The part of a custom block that has a problem.
Part = Literal["name", "source", "configuration"]
LONGEST_NAME = 60

# No separators and no dots; Windows strips and Unix hides some characters at the ends.
_NAME = re.compile(r"[^\W_](?:[\w -]*[\w-])?")


@dataclass(frozen=True, slots=True)
class Problem:
    """An error or a warning, and the part that it is about."""

    part: Part
    diagnostic: Diagnostic

    @property
    def is_error(self) -> bool:
        return self.diagnostic.severity == "error"


@dataclass(frozen=True, slots=True)
class Checked:
    """The result of a check.

    Args:
        problems: the problems of each part, in order.
        blocks: the blocks of the source, as far as it can be parsed.
        chosen: the configuration without what the source already says, as JSON; this is saved.
    """

    problems: tuple[Problem, ...]
    blocks: tuple[BlockConfiguration, ...] = ()
    chosen: str = ""

    @property
    def complete(self) -> str:
        """The whole configuration of the blocks, as JSON."""
        return written(self.blocks) if self.blocks else ""

    @property
    def errors(self) -> tuple[Problem, ...]:
        """The problems that prevent saving."""
        return tuple(problem for problem in self.problems if problem.is_error)

    def require_no_errors(self, name: str) -> None:
        """Raise the errors, if there are any.

        Raises:
            CustomBlockError: the block has errors.
        """
        if self.errors:
            raise CustomBlockError(f"{name}.py", [problem.diagnostic for problem in self.errors])


@dataclass(frozen=True, slots=True)
class CustomBlock:
    """A custom block as it is saved.

    Args:
        name: the name of the file, without its suffix.
        source: the Python source.
        configuration: the configuration of its blocks, as JSON; empty for the defaults.
        functions: the names of its skills, even if the source is not valid Python.
        category: the palette tab of its first block.
        problems: the problems of the source and the configuration.
    """

    name: str
    source: str
    configuration: str
    functions: tuple[str, ...]
    category: str
    problems: tuple[Problem, ...]


def checked_name(name: str) -> str:
    """The name in the form used for files.

    Raises:
        CustomBlockError: a custom block cannot have this name.
    """
    name = unicodedata.normalize("NFC", name)
    if not _NAME.fullmatch(name) or len(name) > LONGEST_NAME:
        wrong = Phrase("custom-bad-name", name=name[:LONGEST_NAME], most=LONGEST_NAME)
        raise CustomBlockError(name, [Diagnostic("wrong-name", wrong)])
    if is_device_name(name):
        wrong = Phrase("custom-device-name", name=name)
        raise CustomBlockError(name, [Diagnostic("wrong-name", wrong)])
    return name
