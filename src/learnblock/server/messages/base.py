"""Types that all messages share, and errors as phrases for the page."""

from typing import Annotated, Literal

from msgspec import Meta, MsgspecError, Struct, json

from learnblock.project.document.views import LONGEST_TEXT

#: The limit in characters of other files, such as blocks or a library.
LONGEST_FILE = 1_000_000
#: That of a file with a picture in it: a world, or a project with its world.
LONGEST_CONTENT = 3_500_000

StateName = Literal["idle", "starting", "running", "paused", "held", "input", "done", "ended"]
Text = Annotated[str, Meta(max_length=LONGEST_TEXT)]
FileText = Annotated[str, Meta(max_length=LONGEST_FILE)]
Name = Annotated[str, Meta(min_length=1, max_length=100)]
#: A name or an empty string.
ShortText = Annotated[str, Meta(max_length=100)]
Coordinate = Annotated[float, Meta(ge=-5000, le=5000)]


class Message(Struct, tag_field="kind", omit_defaults=True, frozen=True):
    """A message of the conversation."""


class FromPage(Message, frozen=True, kw_only=True):
    """A message from a page.

    Args:
        request: the page's number for it if it waits for the answer, which repeats the number:
            `Done`, `Failed`, or a message of its own.
    """

    request: Annotated[int, Meta(ge=0)] = 0


class Head(Struct, frozen=True):
    """What a refusal repeats of a message from a page, see `FromPage`."""

    kind: str = ""
    request: int = 0


_heads = json.Decoder(Head)


def head_of(text: str | bytes) -> Head:
    """The head of a message, also of one that is otherwise wrong; empty if it has none."""
    try:
        return _heads.decode(text)
    except (MsgspecError, UnicodeError, RecursionError):
        return Head()


class FromReader(FromPage, frozen=True):
    """One that a page may also send while another server has the right to write.

    It writes neither to the projects nor to the user's folder. Robot, world, breakpoints and block
    set hold for a session, and are not saved.
    """


class ToPage(Message, frozen=True):
    """A message to a page."""
