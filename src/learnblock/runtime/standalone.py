"""A program run without a host, as ``python square.py``: it leaves the same trace."""

import sys
from collections.abc import Callable
from contextlib import redirect_stdout
from pathlib import Path
from types import FrameType
from typing import Any

from learnblock.client import Client
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase, translate
from learnblock.i18n.reader import system_language
from learnblock.runtime.ending import How
from learnblock.runtime.lines import LineBudget, start_line_events
from learnblock.runtime.output import LineStream
from learnblock.runtime.program import Program
from learnblock.runtime.recorder import Recorder, record
from learnblock.runtime.trace import Trace


# Why: docs/decisions.md, "python square.py needs no host"
def trace_main_program(client: Client, path: Path) -> Callable[[], None]:
    """Write the trace of the running program; return the function that ends it.

    Raises:
        LearnBlockError: no program file is running.
    """
    frame = _main_frame()
    source = Path(frame.f_code.co_filename).read_text(encoding="utf-8")
    program = Program(path.name, source, source)
    file = path.open("wb")
    recorder = record(client, program.identity, Trace(file))
    client.observer = recorder
    stop_lines = start_line_events(
        frame.f_code,
        source,
        LineBudget(client.clock, recorder.line),
        running=sys._getframe(),  # noqa: SLF001 - the robot may be made in a function
    )
    stop_prints = _record_prints(recorder)

    def end() -> None:
        stop_lines()
        stop_prints()
        # The interpreter keeps the error that ended a program; inside a `with` it is still raised.
        failed = hasattr(sys, "last_value") or sys.exc_info()[0] is not None
        recorder.end(How.ERROR if failed else How.FINISHED)
        file.close()

    return end


def main_program() -> str | None:
    """The name of the file that is run as ``python square.py``; None if no file is run so.

    Python forgets it before robots stop at the end of a program.
    """
    main = sys.modules["__main__"]
    file = getattr(main, "__file__", None)
    # What ``python -m`` runs, such as tests, has a spec.
    if not file or main.__spec__ is not None or _runs_in_marimo():
        return None
    return Path(file).name


def _runs_in_marimo() -> bool:
    """Whether a cell of marimo's notebooks runs: their main module has a file, too."""
    marimo: Any = sys.modules.get("marimo")
    return bool(getattr(marimo, "running_in_notebook", bool)())


def report_main_program(client: Client, name: str, seconds: float) -> None:
    """Report on the standard error what the program's robot did.

    Args:
        client: the robot.
        name: the name of the program.
        seconds: the time of its world: a program that is ended while it waits has an older one.
    """
    outcome = client.outcome()
    reached = tuple(goal.name for goal in outcome.goals if goal.state == "reached")
    report = Phrase(
        "run-alone-with-goals" if reached else "run-alone",
        program=name,
        time=round(seconds, 2),
        distance=round(outcome.distance or 0),
        world=str(client.conditions()["world"]),
        **({"goals": reached} if reached else {}),
    )
    sys.stderr.write(f"{translate(report, system_language())}\n")


def _main_frame() -> FrameType:
    frame: FrameType | None = sys._getframe(1)  # noqa: SLF001 - the documented way to walk the stack
    while frame is not None:
        if frame.f_code.co_name == "<module>" and frame.f_globals.get("__name__") == "__main__":
            return frame
        frame = frame.f_back
    raise LearnBlockError("run-no-program-file")


def _record_prints(recorder: Recorder) -> Callable[[], None]:
    terminal = sys.stdout

    def on_line(line: str) -> None:
        recorder.printed(line)
        terminal.write(line)

    lines = LineStream(on_line)
    redirection = redirect_stdout(lines)
    redirection.__enter__()

    def stop() -> None:
        lines.finish()
        redirection.__exit__(None, None, None)

    return stop
