"""Checks in a lesson's own Python: they come from anyone, so they run contained, like programs.

A process of its own gets the run as JSON, puts itself behind the fence of programs, and writes the
answer as JSON. Anything but a clear yes counts as no.
"""

import subprocess
import sys
from collections.abc import Mapping, Sequence
from tempfile import TemporaryFile
from typing import Any, BinaryIO

import msgspec

from learnblock.evidence.evidence import Evidence, Noted
from learnblock.i18n import ENGLISH, Multilingual, Phrase
from learnblock.lessons import expert_child
from learnblock.lessons.check_texts import check_texts
from learnblock.lessons.checks import Expert
from learnblock.lessons.finding import Finding
from learnblock.lessons.opened import EXPERTS, OpenLesson
from learnblock.runtime import process_group
from learnblock.runtime.containment.environment import environment
from learnblock.runtime.containment.scratch import Scratch
from learnblock.runtime.limits import MEGABYTE, Limits

#: The most seconds of a check.
SECONDS = 10.0
#: The resources that a check may use.
LIMITS = Limits(memory=1024 * MEGABYTE, cpu=5, file_size=MEGABYTE, open_files=32)
#: The largest answer, in bytes; it may have a reason in several languages.
_LARGEST_ANSWER = 64 * 1024
_LONGEST_REASON = 300


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


class Experts:
    """Judges by a lesson's own Python.

    Args:
        opened: the lesson.
        seconds: the most seconds of a check.
        limits: the resources that a check may use.
    """

    def __init__(
        self, opened: OpenLesson, seconds: float = SECONDS, limits: Limits = LIMITS
    ) -> None:
        self._source = opened.text(EXPERTS) if EXPERTS in opened.files else ""
        self._texts = check_texts(opened)
        self._seconds = seconds
        self._limits = limits

    def __call__(self, check: Expert, evidence: Evidence) -> Finding:
        """Judge a run that is over."""
        task = {
            "source": self._source,
            "function": check.function,
            "texts": self._texts,
            "run": _plain(evidence),
            "limits": self._limits,
        }
        answer = _answer(_run(msgspec.json.encode(task), self._seconds))
        if answer is None:
            return Finding("failed", evidence.now, Phrase("lesson-expert-silent"))
        if answer.error:
            error = answer.error[:_LONGEST_REASON]
            return Finding("failed", evidence.now, Phrase("lesson-expert-error", error=error))
        if answer.met:
            return Finding("met", evidence.now)
        return Finding("failed", evidence.now, _reason(answer.reason))


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


def _run(task: bytes, seconds: float) -> bytes:
    """What the contained process writes; "" if it had to be ended."""
    scratch = Scratch()
    try:
        # In a file, whose size is limited: a pipe could be written to without end.
        with TemporaryFile() as task_file, TemporaryFile() as written:
            task_file.write(task)
            task_file.seek(0)
            status = _wait(_start(task_file, written, environment(scratch.path)), seconds)
            written.seek(0)
            return written.read(_LARGEST_ANSWER) if status == 0 else b""
    finally:
        scratch.remove()


def _start(
    task_file: BinaryIO, written: BinaryIO, variables: Mapping[str, str]
) -> "subprocess.Popen[bytes]":
    return subprocess.Popen(  # noqa: S603 - our own interpreter and module
        # -P: as for programs.
        [sys.executable, "-P", "-m", expert_child.__name__],
        env=variables,
        stdin=task_file,
        stdout=written,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )


def _wait(process: "subprocess.Popen[bytes]", seconds: float) -> int | None:
    try:
        return process.wait(seconds)
    except subprocess.TimeoutExpired:
        return None
    finally:
        process_group.kill(process)


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
    }


def _pairs(noted: Sequence[Noted]) -> list[tuple[float, str]]:
    return [(note.moment.time, note.text) for note in noted]
