"""Messages about tag names."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.i18n import Phrase
from learnblock.server.messages.base import Look, Name, Own, ShortText, Text, ToPage

#: The maximum number of tag names; there are 587 tags, and a tag may have several names.
MOST_TAGS = 2000

# From the page.


class SaveTags(Own, frozen=True):
    """Save the tag names; every page receives `Tags`."""

    names: Annotated[dict[ShortText, int], Meta(max_length=MOST_TAGS)]


class ReadTags(Look, frozen=True):
    """Ask for the names in a file's text, TOML or CSV; the reply is `TagsRead`."""

    filename: Name
    text: Text


class ExportTags(Look, frozen=True):
    """Ask for the tag names as a file, or for a sheet to print; the reply is `File`."""

    format: Literal["toml", "csv", "html"] = "toml"


# To the page.


class Tags(ToPage, frozen=True):
    """The tag number of each name; sent when a page opens a project, and after changes.

    Args:
        problem: why the user's file can't be read; in that case there are no names.
    """

    names: dict[str, int]
    problem: Phrase | None = None


class TagsRead(ToPage, frozen=True):
    """The names in a file, which are not saved yet."""

    names: dict[str, int]
