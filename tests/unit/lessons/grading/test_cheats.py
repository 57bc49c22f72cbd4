"""Cheats: each is caught, or changes nothing but its own program's result for the worse."""

from dataclasses import replace

import pytest

from attacks import COMPLETE
from cheats import CHEATS
from gradings import GOOD, HEAD, LESSON, handed_in, lesson, plan
from learnblock import robots
from learnblock.lessons.grading.executing import end_idle, run_piece
from learnblock.lessons.grading.table import stars
from learnblock.lessons.grading.values import unpacked
from learnblock.running import Options
from learnblock.running.batch import Batch
from learnblock.running.job import Job
from learnblock.runtime.limits import Limits
from learnblock.runtime.program import Program

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.certain,
    pytest.mark.slow,
    pytest.mark.skipif(not COMPLETE, reason="needs Landlock and seccomp"),
]


@pytest.fixture(scope="module", autouse=True)
def processes():
    yield
    end_idle()


#: So much processor time a program has until its next call: a tenth of it is enough here.
LIMITS = Limits(silence=1.0)


def graded(text):
    [one] = handed_in(eve=text)
    [(_, piece)] = plan((one,), limits=LIMITS).pieces(one)
    return unpacked(run_piece(replace(piece, manner="shared")))


@pytest.fixture(scope="module")
def honest():
    """The result of an honest program before any cheat."""
    return graded(GOOD)


@pytest.mark.parametrize("name", CHEATS)
def test_a_cheat_gets_no_star_and_changes_nothing(honest, name, tmp_path, monkeypatch):
    files = {
        "solution.bt": GOOD,
        "lesson.toml": LESSON,
        "checks.py": "found = 1\n",
        "results.csv": "",
        "journal.jsonl": "",
    }
    for file, content in files.items():
        (tmp_path / file).write_text(content)
    monkeypatch.chdir(tmp_path)
    ended, source = CHEATS[name]
    result = graded(HEAD + f"OUT = {str(tmp_path)!r}\n{source}\n")
    assert stars(lesson().step(1).check, result) == 0
    assert ended in {"any", result.ended}, result
    assert {one.name: one.read_text() for one in tmp_path.iterdir()} == files
    assert graded(GOOD) == honest


def test_a_program_finds_nothing_that_tells_grading_from_a_run(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    python = HEAD + (
        "import os, sys, threading\n"
        "print(sorted(os.environ), sys.argv[:1], len(sys.argv), __file__)\n"
        "print(os.path.exists('lesson'))\n"
        "print([one.name for one in threading.enumerate()])\n"
    )
    result = graded(python)
    program = Program("program.py", python, python)
    options = Options(world="square", seed=0, variant=0, seconds=5, pace="free")
    [(_, alone)] = Batch([Job(program, robots.find("sim-ebo"), options)]).results()
    assert result.ended == "finished"
    # The trace has what it printed.
    assert result.trace_sha256 == alone.report.trace_sha256


def test_a_plain_program_that_never_ends_in_the_shared_process_ends_as_isolated():
    shared = graded("main:\n    x = 1\n    while x > 0:\n        x = x + 1\n    end\nend\n")
    assert (shared.ended, shared.checked) == ("no call", "isolated")
