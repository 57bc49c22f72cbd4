"""Checks in a lesson's own Python: they come from anyone, so they run contained, like programs.

A process of its own gets the run as JSON, puts itself behind the fence of programs, and answers in
JSON. Anything but a clear yes counts as no.
"""

import socket
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import cached_property, partial
from subprocess import TimeoutExpired
from typing import Any, TypeVar

import msgspec

from learnblock.errors import LearnBlockError
from learnblock.evidence.evidence import Evidence, Noted
from learnblock.i18n import ENGLISH, Multilingual, Phrase
from learnblock.lessons import expert_child
from learnblock.lessons.check_texts import Texts, check_texts
from learnblock.lessons.checks import Expert
from learnblock.lessons.finding import Finding
from learnblock.lessons.opened import EXPERTS, OpenLesson
from learnblock.runtime.activity import Allowance, of_process
from learnblock.runtime.fork_server import ForkServer
from learnblock.runtime.limits import MEGABYTE, Limits
from learnblock.runtime.standby import Standby

T = TypeVar("T")

#: The resources that a check may use; `blocked` is how long it may compute and wait in all.
LIMITS = Limits(memory=1024 * MEGABYTE, cpu=5, file_size=MEGABYTE, open_files=32, blocked=10.0)
#: Seconds of the wall clock that a check may take on a busy machine; then there is no verdict.
LONGEST = 300.0
#: Seconds between two looks at what a check does.
_LOOK = 0.05
#: The largest answer, in bytes; it may have a reason in several languages.
_LARGEST_ANSWER = 64 * 1024
_LONGEST_REASON = 300
_CHILD = expert_child.__name__


class ExpertAnswer(msgspec.Struct, forbid_unknown_fields=True):
    """What a check answers.

    Args:
        met: whether the check is met.
        reason: why not, in one language or by language.
        error: the error of its Python.
    """

    met: bool
    reason: str | dict[str, str] = ""
    error: str = ""


class NoVerdictError(LearnBlockError, RuntimeError):
    """This computer was too busy for a check: not the program's fault."""


class _SilentError(Exception):
    """A check has computed or waited for too long."""


class Experts:
    """Judges by a lesson's own Python.

    Args:
        opened: the lesson.
        limits: the resources that a check may use.
        processes: forks a process for each check, to judge many runs faster; without it, each check
            starts one. See `expert_processes`.
        longest: the most seconds of the wall clock of a check.
    """

    def __init__(
        self,
        opened: OpenLesson,
        limits: Limits = LIMITS,
        processes: ForkServer | None = None,
        longest: float = LONGEST,
    ) -> None:
        self._source = opened.text(EXPERTS) if EXPERTS in opened.files else ""
        self._opened = opened
        self._longest = longest
        self._limits = limits
        self._processes = processes

    def __call__(self, check: Expert, evidence: Evidence) -> Finding:
        """Judge a run that is over.

        Raises:
            NoVerdictError: this computer was too busy for the check.
        """
        task = {
            "source": self._source,
            "function": check.function,
            "texts": self._texts,
            "run": _plain(evidence),
            "limits": self._limits,
        }
        with self._process() as process:
            answer = _answer(self._said(process, msgspec.json.encode(task)))
        if answer is None:
            return Finding("failed", evidence.now, Phrase("lesson-expert-silent"))
        if answer.error:
            error = answer.error[:_LONGEST_REASON]
            return Finding("failed", evidence.now, Phrase("lesson-expert-error", error=error))
        if answer.met:
            return Finding("met", evidence.now)
        return Finding("failed", evidence.now, _reason(answer.reason))

    def _said(self, process: Standby, task: bytes) -> bytes:
        """What a contained process answers; "" if there is no answer."""
        activity = partial(of_process, process.process.pid)
        allowance = Allowance(self._limits.blocked, self._longest, activity)

        def look() -> None:
            allowance.look()
            if allowance.is_spent:
                raise _SilentError
            if allowance.is_over:
                raise NoVerdictError("lesson-expert-no-verdict", seconds=self._longest)

        try:
            return _reply(process, task, look)
        except (OSError, _SilentError):
            return b""

    @cached_property
    def _texts(self) -> Mapping[str, Texts]:
        # Most steps have no check in Python.
        return check_texts(self._opened)

    def _process(self) -> Standby:
        if self._processes:
            self._processes.begin()
            # It may have been killed meanwhile.
            with suppress(OSError):
                return self._processes.standby()
        return Standby(_CHILD)


def expert_processes() -> ForkServer:
    """What forks the processes of checks; it starts with the first of them."""
    return ForkServer(_CHILD)


def _reason(reason: str | dict[str, str]) -> Phrase:
    texts = {ENGLISH: reason} if isinstance(reason, str) else reason
    if not any(texts.values()):
        return Phrase("lesson-expert-no")
    cut = {language: text[:_LONGEST_REASON] for language, text in texts.items()}
    usual = cut.get(ENGLISH) or next(iter(cut.values()))
    return Phrase("lesson-expert-says", reason=Multilingual({**cut, ENGLISH: usual}))


def _answer(data: bytes) -> ExpertAnswer | None:
    """The answer; None if there is no clear one."""
    try:
        return msgspec.json.decode(data, type=ExpertAnswer)
    except (msgspec.MsgspecError, ValueError):
        return None


def _reply(process: Standby, task: bytes, look: Callable[[], object]) -> bytes:
    """What the contained process answers; "" if it says too much or fails.

    Args:
        process: the process.
        task: its task.
        look: is called again and again meanwhile.

    Raises:
        OSError: the connection is gone.
    """
    answer, connection = bytearray(), process.connection
    connection.settimeout(_LOOK)
    unsent = memoryview(task)
    while unsent:
        unsent = unsent[_patiently(partial(connection.send, unsent), look) :]
    connection.shutdown(socket.SHUT_WR)
    while received := _patiently(partial(connection.recv, _LARGEST_ANSWER), look):
        answer += received
        if len(answer) > _LARGEST_ANSWER:
            return b""
    status = _patiently(partial(process.process.wait, _LOOK), look)
    return bytes(answer) if status == 0 else b""


def _patiently(attempt: Callable[[], T], look: Callable[[], object]) -> T:
    """The value of an attempt that times out after a moment, and is made again then."""
    while True:
        look()
        with suppress(TimeoutError, TimeoutExpired):
            return attempt()


def _plain(evidence: Evidence) -> dict[str, Any]:
    """What a check gets to see: see docs/lessons.md."""
    report = evidence.report
    return {
        "ended": report.ended if report else "",
        "time": evidence.now,
        "distance": evidence.distance,
        "path": [
            [placed.moment.time, placed.x, placed.y, placed.heading] for placed in evidence.path
        ],
        "goals": {name: moment.time for name, moment in evidence.reached.items()},
        "failed": {name: moment.time for name, moment in evidence.failed.items()},
        "prints": _pairs(evidence.prints),
        "calls": _pairs(evidence.calls),
        "shows": _pairs(evidence.shows),
        "says": _pairs(evidence.says),
        "sends": _pairs(evidence.sends),
        "collisions": _pairs(evidence.collisions),
        "keys": evidence.keys,
        "game": [{"t": moment.time, **line} for moment, line in evidence.game],
    }


def _pairs(noted: Sequence[Noted]) -> list[tuple[float, str]]:
    return [(note.moment.time, note.text) for note in noted]
