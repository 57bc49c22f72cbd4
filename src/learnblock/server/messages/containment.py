"""Messages about what programs may do on the server's computer."""

from learnblock.i18n import Phrase
from learnblock.runtime.containment.survey import AttemptResult
from learnblock.server.messages.base import Computer, Look, ShortText, ToPage

# From the page.


class ReadContainment(Look, frozen=True):
    """Ask how programs are contained; the reply is `Containment`."""


class ReadNetwork(Look, frozen=True):
    """Ask whether the project's programs may use the network; the reply is `Network`."""


class AllowNetwork(Computer, frozen=True):
    """Allow the project's programs the network from the next run on, or forbid it.

    The reply is `Network`.

    Args:
        allowed: whether they may use it.
        key: that of the last `Network`.
    """

    allowed: bool
    key: ShortText


# To the page.


class Containment(ToPage, frozen=True):
    """The attempts to do what programs must not do on the server's computer, and their results."""

    findings: tuple[AttemptResult, ...]


class Network(ToPage, frozen=True):
    """Whether the project's programs may use the network.

    Args:
        allowed: whether they may.
        key: what this page needs to change it; empty if it can't.
        reason: why it can't.
    """

    allowed: bool
    key: str = ""
    reason: Phrase | None = None
