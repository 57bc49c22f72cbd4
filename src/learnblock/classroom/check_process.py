"""The process that runs a lesson's checks on all hand-ins of a step, as `learnblock grade` does.

It is apart from the classroom, which goes on if a check takes all memory, and gives way to pupils.
On its standard output, it says how far it is, a line of JSON each.
"""

import os
import signal
import sys
from functools import partial
from pathlib import Path
from types import FrameType

import msgspec

from learnblock.classroom.collecting import plan_of
from learnblock.classroom.roster import Roster
from learnblock.errors import LearnBlockError, phrase_of
from learnblock.i18n import Phrase
from learnblock.lessons.grading.executors import local
from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.journal import opened_journal
from learnblock.running.batch import processors
from learnblock.runtime.containment import kernel

#: Everything else goes first.
_NICENESS = 8


class CheckNews(msgspec.Struct, frozen=True, omit_defaults=True):
    """How far a check is.

    Args:
        done: the runs that are finished.
        total: all runs.
        failure: why it could not be finished.
    """

    done: int = 0
    total: int = 0
    failure: Phrase | None = None


def check(folder: Path, lesson: str, step: int, out: Path) -> None:
    """Make the runs that are missing.

    Raises:
        LearnBlockError: there is no such class or lesson, or another grading uses `out`.
        OSError: a file can't be read or written.
    """
    plan = plan_of(Roster(folder, ""), lesson, step)
    with opened_journal(out) as journal:
        grading = Grading(plan, journal)

        def stop(number: int, frame: FrameType | None) -> None:  # noqa: ARG001
            grading.stop()

        signal.signal(signal.SIGTERM, stop)
        # The processor that is left is for pupils' programs.
        for progress in grading.run(partial(local, max(1, processors() - 1))):
            _say(CheckNews(progress.done, progress.total))
        if failures := grading.failures:
            _say(CheckNews(failure=failures[0]))


def _say(news: CheckNews) -> None:
    sys.stdout.write(msgspec.json.encode(news).decode() + "\n")
    sys.stdout.flush()


def main(folder: str, lesson: str, step: str, out: str) -> None:
    """Check, and say how far it is and what went wrong."""
    # Ctrl-C is for the classroom.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if sys.platform == "linux":
        kernel.die_with_parent(signal.SIGKILL)
    os.nice(_NICENESS)
    try:
        check(Path(folder), lesson, int(step), Path(out))
    except (LearnBlockError, OSError) as error:
        _say(CheckNews(failure=phrase_of(error)))


if __name__ == "__main__":
    main(*sys.argv[1:])
