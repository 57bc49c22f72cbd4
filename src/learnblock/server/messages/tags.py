"""What is said of the names of tags."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.server.messages.base import Message, Name, ShortText, Text

#: Names of tags; there are 587 tags, and each may have several.
MOST_TAGS = 2000

# The page speaks.


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


# The server speaks.


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
