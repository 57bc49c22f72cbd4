"""Running a program from its file to its report, for the command line and the page."""

from learnblock.running.examples import example
from learnblock.running.network import may_use_network
from learnblock.running.preparing import DEFAULT_ROBOT, check, choose_robot, program
from learnblock.running.program_run import Options, ProgramRun
from learnblock.running.report import Report
from learnblock.running.source import Source, read, read_text, source_of

__all__ = [
    "DEFAULT_ROBOT",
    "Options",
    "ProgramRun",
    "Report",
    "Source",
    "check",
    "choose_robot",
    "example",
    "may_use_network",
    "program",
    "read",
    "read_text",
    "source_of",
]
