"""What a run of the tests says of a test that hangs, and of one that fails now and then."""

import re
import subprocess
import sys

import pytest

from places import ROOT

#: Uses the plugins of our own tests, and none of their folders.
CONFTEST = f"""
import sys
sys.path.insert(0, {str(ROOT / "tests" / "helpers")!r})
pytest_plugins = ("limits", "reruns", "spent")
"""
HANGS = """
import subprocess, threading, time
import pytest

@pytest.fixture
def stuck():
    yield
    threading.Event().wait()

@pytest.mark.timeout(1)
def test_hangs():
    waiting = threading.Event()
    threading.Thread(target=waiting.wait, name="the other thread", daemon=True).start()
    subprocess.Popen(["sleep", "1234"]).wait()

@pytest.mark.timeout(1)
def test_whose_clean_up_hangs_too(stuck):
    threading.Event().wait()

def test_comes_after_them():
    pass
"""
FAILS_TWICE = """
from pathlib import Path
import pytest

def tries():
    file = Path(__file__).with_name("tries")
    file.touch()
    file.write_text(file.read_text() + "x")
    return len(file.read_text())

@pytest.mark.realtime
def test_late():
    assert tries() == 3, "too late"

@pytest.mark.realtime
@pytest.mark.certain
def test_contained():
    raise AssertionError("it got out")
"""


@pytest.fixture
def run(tmp_path):
    """Run a file of tests as a run of its own; return what it said."""

    def run(text, *options):
        (tmp_path / "conftest.py").write_text(CONFTEST)
        (tmp_path / "pytest.ini").write_text(
            "[pytest]\nmarkers =\n    realtime\n    certain\ntimeout = 20\n"
        )
        (tmp_path / "test_it.py").write_text(text)
        command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *options]
        done = subprocess.run(
            command, check=False, cwd=tmp_path, stdout=subprocess.PIPE, text=True, timeout=50
        )
        return done.stdout

    return run


@pytest.mark.exhaustive
@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_a_test_that_hangs_leaves_its_stacks_and_processes_and_the_run_goes_on(run):
    said = run(HANGS)
    assert "Failed: Timeout (>1.0s) from pytest-timeout" in said
    assert "the other thread:" in said
    assert re.search(r"Processes that it had started, now ended -+\n\d+ sleep 1234\n", said)
    assert "2 failed, 1 passed, 1 error" in said


@pytest.mark.exhaustive
def test_a_test_of_real_time_runs_again_and_is_listed_and_one_of_containment_is_not(run):
    said = run(FAILS_TWICE)
    assert "FLAKY test_it.py::test_late (again: 2) - AssertionError: too late" in said
    assert "FLAKY test_it.py::test_contained" not in said
    assert "1 failed, 1 passed, 2 rerun" in said


@pytest.mark.exhaustive
def test_a_strict_run_runs_nothing_again(run):
    assert "2 failed" in run(FAILS_TWICE, "--force-reruns=0")


@pytest.mark.exhaustive
def test_a_run_ends_with_its_seconds_by_folder_and_its_longest_tests(run):
    said = run("def test_it():\n    pass\n")
    assert "all, set-up and clean-up too" in said
    assert "test_it.py::test_it" in said.partition("longest tests")[2]
