"""What came of a run, and how it is sent by the process that made it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import msgspec

from learnblock.i18n import Phrase
from learnblock.running.report import Report


@dataclass(frozen=True, slots=True)
class RunResult:
    """What came of a `Job`, or of a run of several robots.

    Args:
        report: its report, with what it printed.
        trace: its trace, if the job wants it, as another process has written it.
        lines: the lines of its trace, if it was made in this process for someone who looks at them.
        isolated: whether the program ran in a process of its own.
        lost: why the run could not be made, which is not its program's fault; "" if it was made.
        robot: among several, the name of the robot that is looked at.
        team: the reports of several robots, by their names.
    """

    report: Report
    trace: bytes = b""
    isolated: bool = True
    lost: str = ""
    robot: str = ""
    team: Mapping[str, Report] = field(default_factory=dict)
    lines: Sequence[Mapping[str, Any]] = ()


def packed(result: RunResult) -> bytes:
    """A result as bytes."""
    return msgspec.msgpack.encode(result)


def unpacked(data: bytes) -> RunResult:
    """The result from bytes.

    Raises:
        msgspec.MsgspecError: it is not one.
    """
    result = msgspec.msgpack.decode(data, type=RunResult)
    error = result.report.error
    if error is None:
        return result
    # The values of an error have no types: see `Report`.
    message = msgspec.convert(error.get("message"), Phrase)
    return replace(result, report=replace(result.report, error={**error, "message": message}))
