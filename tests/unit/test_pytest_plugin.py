"""A teacher's own tests, as docs/editors.md shows them."""

import re
import subprocess
import sys

import pytest

from places import ROOT

PAGE = (ROOT / "docs" / "editors.md").read_text("utf-8")
FILES = dict(re.findall(r"```\w+ title=(\S+)\n(.*?)```", PAGE, re.DOTALL))
#: A program that drives on, and one with a mistake.
WRONG = {
    "main:\n    function.move_straight(100)\n    function.sleep(2)\nend\n": (1, 7),
    "main:\n    functoin.turn(90)\nend\n": (1, 7),
}


def pytest_in(folder, *options: str) -> str:
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *options]
    return subprocess.run(command, check=False, capture_output=True, text=True, cwd=folder).stdout


@pytest.fixture
def exercise(tmp_path):
    for name, text in FILES.items():
        (tmp_path / name).write_text(text)
    return tmp_path


@pytest.mark.slow
def test_the_exercise_of_the_docs_passes(exercise):
    assert "8 passed" in pytest_in(exercise)


@pytest.mark.exhaustive
@pytest.mark.parametrize(("program", "counts"), WRONG.items(), ids=["drives on", "mistake"])
def test_a_wrong_program_fails_it(exercise, program, counts):
    (exercise / "square.bt").write_text(program)
    passed, failed = counts
    assert f"{failed} failed, {passed} passed" in pytest_in(exercise)


@pytest.mark.exhaustive
def test_a_mistake_is_shown_with_its_line_and_without_a_traceback(exercise):
    (exercise / "square.bt").write_text("main:\n    functoin.turn(90)\nend\n")
    output = pytest_in(exercise, "-k", "every_goal")
    assert "square.bt:2:5: not-block-text" in output
    assert "Traceback" not in output
    assert "def run_program" not in output


def test_tests_that_do_not_ask_for_it_do_not_load_it(tmp_path):
    (tmp_path / "test_plain.py").write_text(
        "import sys\ndef test_plain():\n    assert 'learnblock' not in sys.modules\n"
    )
    assert "1 passed" in pytest_in(tmp_path)
