"""`learnblock grade` grades what was handed in, survives kill -9, and goes on where it was."""

import csv
import hashlib
import signal
import subprocess
import sys

import pytest

from gradings import GOOD, LESSON, SHORT, START
from learnblock.lessons.grading.journal import NAME
from waiting import wait_for

pytestmark = [pytest.mark.realtime, pytest.mark.slow]


@pytest.fixture
def folder(tmp_path):
    """A folder with a lesson and a class."""
    (tmp_path / "drive" / "programs").mkdir(parents=True)
    (tmp_path / "drive" / "lesson.toml").write_text(LESSON)
    (tmp_path / "drive" / "programs" / "start.bt").write_text(START)
    handed_in = tmp_path / "class"
    (handed_in / "cleo" / "inner").mkdir(parents=True)
    (handed_in / "ana.bt").write_text(GOOD)
    (handed_in / "bo.bt").write_text(SHORT)
    (handed_in / "cleo" / "inner" / "mine.bt").write_text(GOOD)
    (handed_in / "dan").mkdir()
    (handed_in / "eva.bt").write_bytes(b"\xff\xfe")
    (handed_in / "flo.bt").write_text("main: what")
    (handed_in / "gil.learnblock").write_text("no project")
    (handed_in / "notes.txt").write_text("no program")
    return tmp_path


def start(folder, *more):
    arguments = ("grade", "class", "--lesson", "drive", "--jobs", "1", "--out", "out", *more)
    return subprocess.Popen(
        [sys.executable, "-m", "learnblock", *arguments],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def finished(process):
    output, _ = process.communicate(timeout=300)
    assert process.returncode == 0, output
    return output


def digest(folder):
    return hashlib.sha256((folder / "out" / "results.csv").read_bytes()).hexdigest()


def test_every_pupil_has_a_row_also_if_the_program_cannot_be_read(folder):
    assert "results.html" in finished(start(folder, "--variants", "0"))
    with (folder / "out" / "results.csv").open(encoding="utf-8-sig") as file:
        rows = {row["pupil"]: row for row in csv.DictReader(file)}
    assert [*rows] == ["ana", "bo", "cleo", "dan", "eva", "flo", "gil"]
    assert [rows[name]["stars"] for name in rows] == ["1", "0", "1", "", "0", "0", "0"]
    assert rows["dan"]["ended"] == "nothing handed in"
    assert {rows[name]["ended"] for name in ("eva", "flo", "gil")} == {"unreadable"}
    page = (folder / "out" / "results.html").read_text()
    assert "There is no program (.bt, .py or .learnblock) in the folder." in page


@pytest.mark.certain
def test_a_grading_that_was_killed_goes_on_to_the_same_table(folder):
    process = start(folder, "--variants", "6")
    journal = folder / "out" / NAME
    wait_for(lambda: journal.exists() and journal.read_bytes().count(b"\n") > 2, "results", 120)
    process.send_signal(signal.SIGKILL)
    process.communicate()
    before = journal.read_bytes().count(b"\n")
    assert not (folder / "out" / "results.csv").exists()
    finished(start(folder, "--variants", "6"))
    resumed = digest(folder)
    # Ana's and Cleo's programs are the same: their pieces are made once.
    assert before < journal.read_bytes().count(b"\n") == 14
    journal.unlink()
    finished(start(folder, "--variants", "6", "--jobs", "2"))
    assert digest(folder) == resumed


def test_ctrl_c_leaves_a_table_of_what_is_finished(folder):
    process = start(folder, "--variants", "12")
    journal = folder / "out" / NAME
    wait_for(lambda: journal.exists() and journal.read_bytes().count(b"\n") > 2, "results", 120)
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=120)
    assert (process.returncode, "Stopped." in output) == (130, True)
    text = (folder / "out" / "results.csv").read_text()
    assert "not finished" in text
    assert "finished" in text.replace("not finished", "")
