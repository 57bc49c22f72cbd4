"""Messages about links that hold a project, and about the run that a link was made with."""

from typing import Annotated, ClassVar

from msgspec import Meta

from learnblock.i18n import Phrase
from learnblock.project.files.share_link import LONGEST_INPUT
from learnblock.server.messages.base import Look, Name, Own, Pace, ShortText, ToPage

# From the page.


class MakeLink(Look, frozen=True):
    """Ask for a link that holds the open project; the reply is `ShareLink`."""

    answer: ClassVar = "ShareLink"


class ExportRun(Look, frozen=True):
    """Ask for the run that is shown as a page in one file; the reply is `RunExported`.

    Args:
        language: of that page.
        pupil: who made it, if the page is to say so; else empty.
    """

    # All questions about the run are answered for it.
    pace: ClassVar = Pace(minute=6, burst=3)

    language: Name = "en"
    pupil: ShortText = ""


class OpenLink(Own, frozen=True):
    """Open the project of a link; one that was opened from it before, if that is unchanged.

    Args:
        link: the link, with any address or none.
    """

    link: Annotated[str, Meta(max_length=LONGEST_INPUT)]


# To the page.


class ShareLink(ToPage, frozen=True):
    """The link of the open project.

    Args:
        request: the number of the request.
        link: the link without an address; empty if the project is too large for one.
        trace_sha256: the hash of the run that it carries; empty if it carries none.
        seconds: how long that run took.
        problem: why there is no link, or why it carries no run.
    """

    request: int
    link: str
    trace_sha256: str = ""
    seconds: float = 0.0
    problem: Phrase | None = None


class RunExported(ToPage, frozen=True):
    """A run as a page in one file."""

    filename: str
    content: bytes


class RunCompared(ToPage, frozen=True):
    """A run of a project from a link has ended, and was compared with the one in the link.

    Args:
        same: whether both are the same, to the last bit of their traces.
        trace_sha256: the hash of the run in the link.
        differences: what is different, if they are not.
    """

    same: bool
    trace_sha256: str
    differences: tuple[Phrase, ...] = ()
