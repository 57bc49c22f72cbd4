"""Messages about the code that a project carries."""

from msgspec import Struct

from learnblock.i18n import Phrase
from learnblock.server.messages.base import Own, ToPage

# From the page.


class InstallOffered(Own, frozen=True):
    """Install the code of the last `CodeOffered` at the user's request: `CodeOffered` follows."""


# To the page.


class OfferedCode(Struct, frozen=True):
    """A custom block or a library that a project carries.

    Args:
        name: its name.
        source: its source to read, shortened if it is very long.
        replaces: whether the user has another one with this name, which would go into the trash.
    """

    name: str
    source: str
    replaces: bool


class CodeOffered(ToPage, frozen=True):
    """The code that the project carries and the user has not installed; empty if there is none."""

    blocks: tuple[OfferedCode, ...] = ()
    libraries: tuple[OfferedCode, ...] = ()


class Noted(ToPage, frozen=True):
    """Something that the server has done for the project, such as adding its world."""

    message: Phrase
