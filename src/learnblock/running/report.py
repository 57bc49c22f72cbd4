"""The report of a run, for its callers."""

from collections.abc import Mapping
from dataclasses import dataclass

from learnblock.client import Goal, Outcome
from learnblock.devices import Pose
from learnblock.i18n import Phrase
from learnblock.runtime.ending import Ending, How
from learnblock.runtime.own_files import quoted
from learnblock.runtime.program import Program
from learnblock.runtime.recorder import Collision, Recorder
from learnblock.runtime.run import Run


@dataclass(frozen=True, slots=True)
class Report:
    """The events and results of a run.

    Args:
        ended: how it ended, in one or two words; ``refused`` if the program was not started.
        time: seconds of the robot's time.
        distance: mm driven; None if unknown.
        pose: (x mm, y mm, heading in degrees) at the end, or None.
        goals: the world's goals.
        emotions: the emotions shown, in order.
        no_effect: skills that had no effect: skill, missing device, number of calls.
        collisions: what it bumped into, at most 1,000 times.
        trace_sha256: the hash of the trace; empty if the run did not begin.
        output: the printed text, if it was not shown while the program ran.
        error: what went wrong, or None: `message` (a `Phrase`), `file`, `line` and the `text` of
            that line; `within` has the same for the file in the user's folder where it happened.
    """

    ended: str
    time: float = 0.0
    distance: float | None = None
    pose: Pose | None = None
    goals: tuple[Goal, ...] = ()
    emotions: tuple[str, ...] = ()
    no_effect: tuple[Mapping[str, object], ...] = ()
    collisions: tuple[Collision, ...] = ()
    trace_sha256: str = ""
    output: str = ""
    error: Mapping[str, object] | None = None

    @property
    def message(self) -> Phrase | None:
        """What went wrong, or None."""
        return self.error["message"] if self.error else None  # type: ignore[return-value]


def report(program: Program, run: Run, trace_sha256: str) -> Report:
    """Report a run that has ended.

    Args:
        program: the program.
        run: its run.
        trace_sha256: the hash of its trace.
    """
    recorder, client = run.recorder, run.client
    ending = run.ending or Ending(How.STOPPED, Phrase("run-stopped"))
    outcome = client.outcome() if client else Outcome()
    return Report(
        time=_time(recorder) if recorder else 0.0,
        distance=outcome.distance,
        pose=outcome.pose,
        goals=outcome.goals,
        emotions=tuple(recorder.emotions) if recorder else (),
        no_effect=_no_effect(recorder) if recorder else (),
        collisions=tuple(recorder.collisions) if recorder else (),
        trace_sha256=trace_sha256,
        ended=ending.how,
        error=None if ending.well else _error(program, ending),
    )


def _time(recorder: Recorder) -> float:
    """When the program ended: other programs may continue in its world."""
    return recorder.time() if recorder.ended_at is None else recorder.ended_at


def _error(program: Program, ending: Ending) -> Mapping[str, object]:
    line = program.written_line(ending.line) if ending.line else 0
    return {
        "message": ending.phrase,
        "file": program.name,
        "line": line,
        "text": program.quote(line),
        **({"within": _within(ending)} if ending.file else {}),
    }


def _within(ending: Ending) -> Mapping[str, object]:
    """The position of an error in a file of the user's folder."""
    text = quoted(ending.file, ending.file_line)
    return {"file": ending.file, "line": ending.file_line, "text": text}


def _no_effect(recorder: Recorder) -> tuple[Mapping[str, object], ...]:
    return tuple(
        {"skill": skill, "device": device, "times": times}
        for (skill, device), times in recorder.missed.items()
    )
