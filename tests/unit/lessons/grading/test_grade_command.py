"""`learnblock grade` grades what was handed in, survives kill -9, and goes on where it was."""

import csv
import hashlib
import signal
import subprocess
import sys
from contextlib import contextmanager

import pytest
from click.testing import CliRunner

from gradings import GOOD, LESSON, SHORT, START
from learnblock.cli import main
from learnblock.lessons.grading.journal import NAME
from waiting import wait_for

pytestmark = [pytest.mark.realtime, pytest.mark.slow]


def written(folder):
    """A folder with a lesson and a class."""
    (folder / "drive" / "programs").mkdir(parents=True)
    (folder / "drive" / "lesson.toml").write_text(LESSON)
    (folder / "drive" / "programs" / "start.bt").write_text(START)
    handed_in = folder / "class"
    (handed_in / "cleo" / "inner").mkdir(parents=True)
    (handed_in / "ana.bt").write_text(GOOD)
    (handed_in / "bo.bt").write_text(SHORT)
    (handed_in / "cleo" / "inner" / "mine.bt").write_text(GOOD)
    (handed_in / "dan").mkdir()
    (handed_in / "eva.bt").write_bytes(b"\xff\xfe")
    (handed_in / "flo.bt").write_text("main: what")
    (handed_in / "gil.learnblock").write_text("no project")
    (handed_in / "notes.txt").write_text("no program")
    return folder


@pytest.fixture
def folder(tmp_path):
    return written(tmp_path)


@pytest.fixture(scope="module")
def graded(tmp_path_factory):
    """A folder with a class that was graded without a break, two pieces at once."""
    folder = written(tmp_path_factory.mktemp("graded"))
    assert "results.html" in grade(folder, "--jobs", "2")
    return folder


def command(folder):
    """A grading with 14 pieces: Ana's and Cleo's program is the same."""
    there = ("--lesson", str(folder / "drive"), "--out", str(folder / "out"))
    return ("grade", str(folder / "class"), *there, "--jobs", "1", "--variants", "6")


def grade(folder, *more):
    """Grade in this process; return what was said."""
    made = CliRunner().invoke(main, [*command(folder), *more])
    assert made.exit_code == 0, made.output
    return made.output


@contextmanager
def begun(folder, *more):
    """A grading in a process of its own that has some results."""
    journal = folder / "out" / NAME
    with subprocess.Popen(
        [sys.executable, "-m", "learnblock", *command(folder), *more],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ) as process:
        wait_for(lambda: journal.exists() and journal.read_bytes().count(b"\n") > 2, "results", 120)
        yield process


def digest(folder):
    return hashlib.sha256((folder / "out" / "results.csv").read_bytes()).hexdigest()


def test_every_pupil_has_a_row_also_if_the_program_cannot_be_read(graded):
    with (graded / "out" / "results.csv").open(encoding="utf-8-sig") as file:
        every = [*csv.DictReader(file)]
    rows = {row["pupil"]: row for row in every if row["variant"] == row["seed"] == "0"}
    assert [*rows] == ["ana", "bo", "cleo", "dan", "eva", "flo", "gil"]
    assert [rows[name]["stars"] for name in rows] == ["1", "0", "1", "", "0", "0", "0"]
    assert rows["dan"]["ended"] == "nothing handed in"
    assert {rows[name]["ended"] for name in ("eva", "flo", "gil")} == {"unreadable"}
    page = (graded / "out" / "results.html").read_text()
    assert "There is no program (.bt, .py or .learnblock) in the folder." in page


@pytest.mark.certain
def test_a_grading_that_was_killed_goes_on_to_the_same_table(folder, graded):
    with begun(folder) as process:
        process.kill()
    journal = folder / "out" / NAME
    before = journal.read_bytes().count(b"\n")
    assert not (folder / "out" / "results.csv").exists()
    grade(folder)
    assert before < journal.read_bytes().count(b"\n") == 14
    assert digest(folder) == digest(graded)


def test_ctrl_c_leaves_a_table_of_what_is_finished(folder):
    with begun(folder, "--variants", "12") as process:
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=120)
    assert (process.returncode, "Stopped." in output) == (130, True)
    text = (folder / "out" / "results.csv").read_text()
    assert "not finished" in text
    assert "finished" in text.replace("not finished", "")
