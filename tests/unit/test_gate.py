"""Which of the listed tests a run of the gate asks for, and what it says of one that is missing."""

import subprocess
import sys

import pytest

from places import ROOT

#: Uses the plugin of our own tests, and a list and folders of its own.
CONFTEST = f"""
import sys
from pathlib import Path
sys.path.insert(0, {str(ROOT / "tests" / "helpers")!r})
import gate
gate.TESTS = Path(__file__).parent
gate.LIST = gate.TESTS / "smoke.txt"
pytest_plugins = ("gate",)
"""
SETTINGS = """
[pytest]
testpaths = browser unit
markers =
    exhaustive
    sample(n)
"""


@pytest.fixture
def run(tmp_path):
    """Run the gate of a folder with a test of the browser, listed or not; return what it said."""

    def run(listed, *options):
        (tmp_path / "conftest.py").write_text(CONFTEST)
        (tmp_path / "pytest.ini").write_text(SETTINGS)
        (tmp_path / "smoke.txt").write_text(f"browser/test_page.py::{listed}\n")
        for folder, name in (("browser", "page"), ("unit", "word")):
            (tmp_path / folder).mkdir()
            file = tmp_path / folder / f"test_{name}.py"
            file.write_text(f"def test_{name}():\n    pass\n")
        command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *options]
        done = subprocess.run(
            command, check=False, cwd=tmp_path, stdout=subprocess.PIPE, text=True, timeout=50
        )
        return done.stdout

    return run


@pytest.mark.exhaustive
@pytest.mark.parametrize("workers", [0, 1])
def test_a_listed_test_that_does_not_exist_is_named(run, workers):
    said = run("test_gone", f"-n{workers}")
    assert "lists tests that do not exist: ['browser/test_page.py::test_gone']" in said


@pytest.mark.exhaustive
def test_a_run_of_other_folders_asks_for_no_test_of_the_list(run):
    said = run("test_page", "-n1", "-o", "testpaths=unit")
    assert "1 passed" in said
    assert "rror" not in said
