"""A grading makes each piece once, keeps it, and goes on where it was stopped."""

import sys
from concurrent.futures import BrokenExecutor, Executor, Future
from contextlib import contextmanager
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path

import pytest

from gradings import GOOD, LESSON, SHORT, handed_in, lesson, plan
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons.expert import NoVerdictError
from learnblock.lessons.grading import executing
from learnblock.lessons.grading.executing import (
    ABOUT_OTHERS,
    MOST_HINTS,
    NotRunError,
    end_idle,
    run_piece,
)
from learnblock.lessons.grading.executors import Workers
from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.journal import opened_journal
from learnblock.lessons.grading.output import PAGE, TABLE, write_results
from learnblock.lessons.grading.plan import Plan, planned
from learnblock.lessons.grading.values import (
    DIFFERS,
    CheckResult,
    HandedIn,
    HintResult,
    Result,
    packed,
)
from learnblock.lessons.reading import find_lesson
from learnblock.lessons.trying import Attempt

CLASS = handed_in(ana=GOOD, bo=SHORT)


class Fake(Executor):
    """Makes pieces at once, as `piece` says."""

    def __init__(self, make):
        self.make = make
        self.pieces = []

    def submit(self, function, piece, /):
        self.pieces.append(piece)
        future = Future()
        try:
            future.set_result(self.make(piece))
        except (BrokenExecutor, NotRunError, NoVerdictError, ZeroDivisionError) as error:
            future.set_exception(error)
        return future

    @contextmanager
    def opened(self):
        yield Workers(self, 4)


def finished(piece):
    return packed(Result(ended="finished", seconds=piece.attempt.seed, checked="shared"))


@pytest.fixture
def journal(tmp_path):
    with opened_journal(tmp_path) as journal:
        yield journal


def test_what_is_finished_is_not_made_again(journal):
    wanted = plan(CLASS, seeds=3)
    first, second = Fake(finished), Fake(finished)
    assert [one.done for one in Grading(wanted, journal).run(first.opened)] == [1, 2, 3, 4, 5, 6]
    assert [*Grading(wanted, journal).run(second.opened)] == []
    assert len(first.pieces) == 6
    rows = [(one.handed_in.pupil, one.attempt.seed) for one in Grading(wanted, journal).rows()]
    assert rows == [(name, seed) for name in ("ana", "bo") for seed in range(3)]


def test_a_stopped_grading_goes_on_where_it_was(journal):
    wanted = plan(CLASS, seeds=10)
    first, second = Fake(finished), Fake(finished)
    grading = Grading(wanted, journal)
    for progress in grading.run(first.opened):
        if progress.done == 5:
            grading.stop()
    assert grading.is_stopped
    missing = [one for one in grading.rows() if one.result is None]
    assert 0 < len(missing) < 20
    list(Grading(wanted, journal).run(second.opened))
    assert len(first.pieces) + len(second.pieces) == 20


def test_of_each_program_at_least_one_piece_is_compared(journal):
    fake = Fake(finished)
    list(Grading(plan(CLASS, seeds=40), journal).run(fake.opened))
    compared = [one.text for one in fake.pieces if one.manner == "compared"]
    assert sorted(compared) == sorted([GOOD] * 2 + [SHORT] * 2)


def test_the_pieces_of_a_program_that_are_compared_come_after_its_others(journal):
    fake = Fake(finished)
    list(Grading(plan(CLASS, seeds=40), journal).run(fake.opened))
    assert [one.manner for one in fake.pieces] == (["shared"] * 38 + ["compared"] * 2) * 2


def test_a_program_whose_runs_differ_is_isolated_in_all_of_them(journal):
    def make(piece):
        if piece.text == SHORT and piece.manner == "compared":
            return packed(Result(ended="finished", checked=DIFFERS))
        checked = "isolated" if piece.manner == "isolated" else "shared"
        return packed(Result(ended="finished", checked=checked))

    fake = Fake(make)
    grading = Grading(plan(CLASS, seeds=3), journal)
    list(grading.run(fake.opened))
    by_pupil = {"ana": [], "bo": []}
    for row in grading.rows():
        by_pupil[row.handed_in.pupil].append(row.result.checked)
    assert by_pupil["ana"] == ["shared"] * 3
    assert sorted(by_pupil["bo"]) == ["isolated", "isolated", DIFFERS]


def test_lost_workers_are_replaced(journal):
    lost = [BrokenExecutor("gone")]

    def make(piece):
        if lost:
            raise lost.pop()
        return finished(piece)

    grading = Grading(plan(CLASS, seeds=2), journal)
    list(grading.run(Fake(make).opened))
    assert all(row.result for row in grading.rows())


def test_workers_that_are_lost_again_and_again_end_the_grading(journal):
    def make(piece):
        raise BrokenExecutor("gone")

    with pytest.raises(LearnBlockError, match="lost again and again"):
        list(Grading(plan(CLASS), journal).run(Fake(make).opened))


def test_a_mistake_of_ours_is_reported_at_its_program_and_ends_no_other(journal):
    def make(piece):
        if piece.text == SHORT:
            raise ZeroDivisionError("oh")
        return finished(piece)

    grading = Grading(plan(CLASS), journal)
    list(grading.run(Fake(make).opened))
    assert [bool(row.result) for row in grading.rows()] == [True, False]
    assert [str(row.failure) for row in grading.rows()] == ["None", "ZeroDivisionError: oh"]


@pytest.mark.parametrize(
    "lost",
    [
        NotRunError("run-lost", reason="Killed"),
        NoVerdictError("lesson-expert-no-verdict", seconds=300),
    ],
)
def test_a_run_that_cannot_be_made_is_told_from_one_that_fails_and_made_again_later(
    journal, tmp_path, lost
):
    def make(piece):
        if piece.text == SHORT:
            raise lost
        return finished(piece)

    grading = Grading(plan(CLASS), journal)
    list(grading.run(Fake(make).opened))
    write_results(grading, tmp_path, "en", lesson="drive")
    row = (tmp_path / TABLE).read_text().splitlines()[2]
    assert row == "bo,1,sim-ebo,0,0,,,,,not run,,,"
    assert "not the fault of the program" in (tmp_path / PAGE).read_text()

    again = Grading(plan(CLASS), journal)
    assert [one.total for one in again.run(Fake(finished).opened)] == [1]
    assert all(row.result for row in again.rows())


def test_what_cannot_be_read_is_a_row_with_the_reason(journal):
    broken = HandedIn("eva", "eva.bt", reason=Phrase("run-not-utf-8", byte="0xff"))
    grading = Grading(plan((broken, *CLASS)), journal)
    list(grading.run(Fake(finished).opened))
    first = next(grading.rows()).result
    assert (first.ended, "0xff" in first.reason["en"]) == ("unreadable", True)


@pytest.mark.parametrize("absence", ["nothing handed in", "not begun"])
def test_a_pupil_without_a_program_is_a_row_that_says_so(journal, absence):
    absent = HandedIn("eva", "eva", reason=Phrase("grade-not-begun"), absence=absence)
    grading = Grading(plan((absent, *CLASS)), journal)
    list(grading.run(Fake(finished).opened))
    assert next(grading.rows()).result.ended == absence


#: A place that only a robot at the usual start reaches by a fixed distance.
PLACE = """
[[step.check]]
kind = "ends_at"
x = -300
y = 0
radius = 4
"""
EXACT = "main:\n    function.drive_distance(100)\nend\n"
ONLY_HERE = "hint-only-here"


def hints_in(journal, program, *attempts):
    """The rules of the hints for a program, by attempt."""
    text = LESSON.replace('"square"', '"parking"').partition("[[step.check]]")[0] + PLACE
    opened = lesson(text.replace('["sim-ebo"]', '["sim-ebo", "sim-thymio"]'))
    tried = tuple(Attempt(*attempt) for attempt in attempts)
    wanted = Plan(opened, 1, handed_in(ana=program), tried, version("learnblock-studio"))
    grading = Grading(wanted, journal)
    list(grading.run(Fake(run_piece).opened))
    return [[hint.rule for hint in row.result.hints] for row in grading.rows()]


@pytest.fixture
def processes():
    yield
    end_idle()


@pytest.mark.usefixtures("processes")
def test_a_program_that_works_only_in_the_world_as_it_is_gets_the_hint_that_says_so(journal):
    usual, variant = hints_in(journal, EXACT, ("sim-ebo", 0), ("sim-ebo", 1))
    assert usual == []
    assert ONLY_HERE in variant
    assert len(variant) <= MOST_HINTS


@pytest.mark.usefixtures("processes")
def test_a_program_that_works_nowhere_does_not_get_that_hint(journal):
    wrong = EXACT.replace("100", "150")
    usual, variant = hints_in(journal, wrong, ("sim-ebo", 0), ("sim-ebo", 1))
    assert usual
    assert variant
    assert ONLY_HERE not in {*usual, *variant}


def hinted(rules, *, passes):
    """A piece whose usual attempt passes or not, and whose other one gets these hints."""

    def make(piece):
        states = (
            ("met", "met", "failed") if passes and not piece.attempt.variant else ("failed",) * 3
        )
        found = tuple(HintResult(rule, ()) for rule in rules) if piece.attempt.variant else ()
        checks = tuple(map(CheckResult, states))
        return packed(Result(ended="finished", checks=checks, hints=found))

    return make


@pytest.mark.parametrize("about_others", sorted(ABOUT_OTHERS))
def test_a_hint_about_other_attempts_needs_one_that_meets_all_that_is_not_optional(
    tmp_path, about_others
):
    rules = ["hint-a", about_others, "hint-b", "hint-c"]
    attempts = (Attempt("sim-ebo", 0), Attempt("sim-ebo", 1))
    wanted = replace(plan(CLASS[:1]), attempts=attempts)
    found = []
    for passes in (True, False):
        with opened_journal(tmp_path / str(passes)) as journal:
            grading = Grading(wanted, journal)
            list(grading.run(Fake(hinted(rules, passes=passes)).opened))
            [_, row] = grading.rows()
            found.append([hint.rule for hint in row.result.hints])
    assert found == [["hint-a", about_others, "hint-b"], ["hint-a", "hint-b", "hint-c"]]


def test_a_hint_about_other_attempts_is_left_out_while_the_usual_one_is_not_finished(journal):
    def make(piece):
        if piece.attempt.variant == 0:
            raise NotRunError("run-lost", reason="Killed")
        return hinted([ONLY_HERE], passes=True)(piece)

    attempts = (Attempt("sim-ebo", 0), Attempt("sim-ebo", 1))
    grading = Grading(replace(plan(CLASS[:1]), attempts=attempts), journal)
    list(grading.run(Fake(make).opened))
    [usual, variant] = grading.rows()
    assert usual.result is None
    assert variant.result.hints == ()


def test_the_name_of_a_pupil_changes_no_result():
    one, other = handed_in(ana=GOOD, zoe=GOOD)
    wanted = plan((one, other))
    assert [*wanted.pieces(one)] == [*wanted.pieces(other)]


def test_another_lesson_program_or_version_is_another_piece():
    wanted = plan(CLASS)
    keys = {key for one in CLASS for key, _ in wanted.pieces(one)}
    other_lesson = plan(CLASS, opened=lesson(LESSON.replace("at_least = 100", "at_least = 99")))
    other_version = replace(wanted, version="0")
    for plan_ in (other_lesson, other_version):
        keys |= {key for one in CLASS for key, _ in plan_.pieces(one)}
    assert len(keys) == 6


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux forks")
def test_all_runs_of_a_step_share_one_file_of_the_lesson_s_own_world(monkeypatch):
    worlds = []

    def forked(job):
        worlds.append(Path(job.options.world))
        raise NotRunError("run-lost", reason="not wanted")

    monkeypatch.setattr(executing, "_forked", forked)
    wanted = planned(find_lesson("1-03-square"), 5, CLASS, robots=["sim-ebo"], variants=1)
    for one in CLASS:
        for _, piece in wanted.pieces(one):
            with pytest.raises(NotRunError):
                run_piece(piece)
    assert len(worlds) == 4
    assert len(set(worlds)) == 1
    assert worlds[0].is_file()

    end_idle()
    assert not worlds[0].exists()


def test_the_file_of_the_world_that_was_needed_longest_ago_is_deleted_when_there_are_too_many(
    monkeypatch,
):
    monkeypatch.setattr(executing, "MOST_WORLDS", 2)
    opened = find_lesson("1-03-square")
    first, second, third = (executing.packed_lesson(opened, 5) + bytes(n) for n in range(3))
    monkeypatch.setattr(executing, "_lesson", lambda _: opened)
    worlds = executing.WorldFiles()

    files = [Path(worlds.of(one, 5)) for one in (first, second, first, third)]
    assert [file.is_file() for file in files] == [True, False, True, True]
    assert files[0] == files[2]
    worlds.close()
    assert not any(file.is_file() for file in files)
