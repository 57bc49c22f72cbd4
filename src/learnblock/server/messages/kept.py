"""Messages about the runs of a project that were kept."""

from typing import Annotated

from msgspec import Meta, Struct

from learnblock.i18n import Phrase
from learnblock.project.files.kept_runs import LONGEST_RUN_NAME, KeptRun
from learnblock.server.messages.base import Look, Own, ToPage
from learnblock.server.messages.looking import CallGraph

#: A kept run: the time at which it began in milliseconds since 1970, and a number.
RunId = Annotated[str, Meta(pattern=r"^[0-9]{13,15}-[0-9]{1,3}$")]
RunName = Annotated[str, Meta(max_length=LONGEST_RUN_NAME)]

# From the page.


class ListRuns(Look, frozen=True):
    """Ask for the project's kept runs; the reply is `KeptRuns`."""


class OpenRun(Look, frozen=True):
    """Look back at a kept run instead of the newest; every page of the robot gets `RunShown`."""

    run: RunId


class CloseRun(Look, frozen=True):
    """Look back at the newest run again; every page of the robot gets `RunShown`."""


class NameRun(Own, frozen=True):
    """Name a run, so that it is kept until it is deleted; without a name it can be discarded again.

    The reply is `KeptRuns`.
    """

    run: RunId
    name: RunName


class DeleteRun(Own, frozen=True):
    """Delete a run; the reply is `KeptRuns`."""

    run: RunId


class CompareRuns(Look, frozen=True):
    """Compare two kept runs; the reply is `RunsCompared`."""

    first: RunId
    second: RunId


class ReadCallsBeside(Look, frozen=True):
    """Ask for the call graphs of two kept runs; the reply is `CallsBeside`."""

    first: RunId
    second: RunId


# From the server.


class KeptRuns(ToPage, frozen=True):
    """The runs of the project that were kept, the newest first."""

    runs: tuple[KeptRun, ...]


class RunShown(ToPage, frozen=True):
    """The run that the timeline, the calls and the answers are about.

    Args:
        run: None for the newest one.
        changed: whether the program has changed since.
        remarks: what can't be shown exactly.
        printed: what the program printed.
    """

    run: KeptRun | None = None
    changed: bool = False
    remarks: tuple[Phrase, ...] = ()
    printed: str = ""


class RunStep(Struct, frozen=True):
    """What one of two compared runs did when they parted.

    Args:
        phrase: its action in words.
        time: when, in s of that run.
    """

    phrase: Phrase
    time: float


class ComparedRun(Struct, frozen=True):
    """One of two compared runs.

    Args:
        id: the run.
        way: where its robot was, if that is known: the time in s, mm east and mm north.
        step: what it did when they parted; None if they never did.
    """

    id: str
    way: tuple[tuple[float, float, float], ...] = ()
    step: RunStep | None = None


class RunsCompared(ToPage, frozen=True):
    """Two kept runs compared.

    Args:
        first: the first run.
        second: the second run.
        together: until when they did the same, in s of the first run; None if they never parted.
        because: why they parted, if both answered the same question differently.
        causes: what was different about them from the start.
    """

    first: ComparedRun
    second: ComparedRun
    together: float | None = None
    because: Phrase | None = None
    causes: tuple[Phrase, ...] = ()


class CallsBeside(ToPage, frozen=True):
    """The call graphs of two runs, with the same name for the program in both.

    Args:
        first: that of the first run.
        second: that of the second run.
    """

    first: CallGraph
    second: CallGraph
