"""Running a program from its file to its report, for the command line and the page."""

from learnblock.running.examples import example, example_text
from learnblock.running.job import Job, Options
from learnblock.running.network import (
    allow_network,
    folder_on_network,
    forbid_network,
    may_use_network,
    move_network,
)
from learnblock.running.preparing import (
    DEFAULT_ROBOT,
    MOST_ROBOTS,
    check,
    choose_robot,
    lacking,
    program,
    runs_on,
    verdicts,
)
from learnblock.running.program_run import ProgramRun
from learnblock.running.report import Report
from learnblock.running.source import Source, read, read_text, source_of

__all__ = [
    "DEFAULT_ROBOT",
    "MOST_ROBOTS",
    "Job",
    "Options",
    "ProgramRun",
    "Report",
    "Source",
    "allow_network",
    "check",
    "choose_robot",
    "example",
    "example_text",
    "folder_on_network",
    "forbid_network",
    "lacking",
    "may_use_network",
    "move_network",
    "program",
    "read",
    "read_text",
    "runs_on",
    "source_of",
    "verdicts",
]
