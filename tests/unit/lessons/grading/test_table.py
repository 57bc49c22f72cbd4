"""The table is the same bytes for the same results, and harmless to a spreadsheet."""

from io import StringIO

import pytest

from gradings import handed_in, lesson
from learnblock.lessons.grading.grading import Row
from learnblock.lessons.grading.table import stars, write_table
from learnblock.lessons.grading.values import CheckResult, HandedIn, Result, packed, unpacked
from learnblock.lessons.trying import Attempt

CHECKS = lesson().step(1).check
DONE = Result(
    checks=tuple(CheckResult("met", 1.0) for _ in CHECKS),
    ended="finished",
    seconds=3.0,
    trace_sha256="ab",
    checked="shared",
)


def table(*rows):
    file = StringIO()
    write_table(file, 1, CHECKS, rows)
    return file.getvalue().splitlines()


def test_a_row_says_what_each_check_says_and_how_it_was_checked():
    [ana] = handed_in(ana="")
    head, row = table(Row(ana, Attempt("sim-ebo", 2, 0), DONE))
    assert head == (
        "pupil,step,robot,variant,seed,1 drives,2 ends,3 prints,"
        "stars,ended,seconds,trace_sha256,checked"
    )
    assert row == "ana,1,sim-ebo,2,0,met,met,met,2,finished,3.000,ab,shared"


def test_what_is_not_finished_is_no_failure():
    [ana] = handed_in(ana="")
    assert (
        table(Row(ana, Attempt("sim-ebo", 0), None))[1] == "ana,1,sim-ebo,0,0,,,,,not finished,,,"
    )


def test_a_pupil_without_a_program_has_failed_nothing():
    eva = HandedIn("eva", "eva", absence="not begun")
    [_, row] = table(Row(eva, Attempt("sim-ebo", 0), Result(ended="not begun")))
    assert row == "eva,1,sim-ebo,0,0,,,,,not begun,,,"


@pytest.mark.parametrize("name", ["=1+1", "+1", "-1", "@SUM(A1)", "\t=1"])
def test_no_name_is_a_formula(name):
    pupil = HandedIn(name, "x.bt")
    assert table(Row(pupil, Attempt("sim-ebo", 0), DONE))[1].startswith(f"'{name}")


@pytest.mark.parametrize(
    ("states", "count"),
    [("met met met", 2), ("met met failed", 1), ("met failed met", 0), ("met met open", 1)],
)
def test_a_star_for_a_step_that_is_done_and_one_for_each_optional_check(states, count):
    result = Result(ended="finished", checks=tuple(map(CheckResult, states.split())))
    assert stars(CHECKS, result) == count


def test_a_result_is_the_same_after_a_journey():
    assert unpacked(packed(DONE)) == DONE
