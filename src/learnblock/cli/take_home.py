"""Writes the page that shows a run without LearnBlock."""

from collections.abc import Sequence
from pathlib import Path

from learnblock import language
from learnblock.blocks.known import all_configurations
from learnblock.cli.language import language as words
from learnblock.cli.report import print_row
from learnblock.project.document.document import Document
from learnblock.robots import RobotEntry
from learnblock.running import Source
from learnblock.runtime.log.keeping import RunLog
from learnblock.server.runs.take_home import RobotRun, Titles, run_page
from learnblock.storage.files import save


def robot_run(source: Source, robot: RobotEntry, log: RunLog) -> RobotRun:
    """The run of a robot, for a page."""
    return RobotRun(log, _document(source, robot), robot.name)


def write_page(path: Path, robots: Sequence[RobotRun], program: str, pupil: str | None) -> None:
    """Write the page of a run that has ended.

    Args:
        path: its file.
        robots: the robots of the run.
        program: what the page is called.
        pupil: who made it, if the page is to say so.

    Raises:
        LearnBlockError: the run was not in a world that can be shown, or is too large.
        OSError: the file can't be written.
    """
    page = run_page(robots, Titles(program, words(), pupil or ""))
    save(path, page.encode())
    print_row("report-label-page", str(path))


def _document(source: Source, robot: RobotEntry) -> Document:
    text = language.format(source.tree) if source.is_python else source.text
    python = source.text if source.is_python else None
    return Document.from_text(text, robot.module, all_configurations(), python=python)
