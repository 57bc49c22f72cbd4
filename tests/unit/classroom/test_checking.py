"""What a check has found is kept with each hand-in, and forgotten with the pupil."""

import pytest

from learnblock.classroom.checking import forget_runs, plan_of, runs_folder, summary
from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.marking import Marking
from learnblock.classroom.roster import Roster
from learnblock.errors import LearnBlockError
from learnblock.lessons.grading.grading import Row
from learnblock.lessons.grading.journal import opened_journal
from learnblock.lessons.grading.values import CheckResult, HintResult, Result
from learnblock.server.messages import GivenProgram, GivenWork

LESSON, STEP = "1-03-square", 4
MISSED = {"en": "100 mm short", "es": "faltan 100 mm"}


@pytest.fixture
def roster(tmp_path):
    roster = Roster(tmp_path, "7b")
    for name in ("Ana", "Bo", "Eva"):
        roster.add(name)
    return roster


@pytest.fixture
def shelf(roster, tmp_path):
    """Ana and Bo have handed in; Eva has not begun."""
    shelf = HandInShelf(tmp_path)
    for pupil, text in zip(roster.pupils, ("main:\nend\n", "main:\n    pass\nend\n"), strict=False):
        shelf.add(pupil.id, GivenWork(LESSON, STEP, GivenProgram(text)))
    return shelf


def result(plan, *states, **values):
    checks = plan.opened.step(STEP).check
    said = [CheckResult(state, reason=MISSED if state == "failed" else {}) for state in states]
    missing = [CheckResult("met")] * (len(checks) - len(said))
    return Result(checks=(*said, *missing), ended="finished", seconds=3.0, **values)


def rows(plan, *results):
    return [
        Row(plan.handed_in[0], attempt, found)
        for attempt, found in zip(plan.attempts, results, strict=False)
    ]


def test_a_summary_shows_the_run_that_failed_and_counts_all(roster, shelf):
    assert shelf
    plan = plan_of(roster, LESSON, STEP)
    hint = HintResult("hint", ({"en": "Look at the loop."},), {"en": "It ends early."})
    failed = result(plan, "failed", path=((1, 2), (3, 4)), hints=(hint,))
    found = summary(plan, rows(plan, result(plan), failed, result(plan), result(plan)))
    assert (found.runs, found.done, found.stars) == (4, 3, 2)
    assert found.way == (1.0, 2.0, 3.0, 4.0)
    assert found.missed[0].reason == MISSED
    assert found.hints[0].says == {"en": "Look at the loop."}


def test_there_is_no_summary_while_runs_are_missing(roster, shelf):
    assert shelf
    plan = plan_of(roster, LESSON, STEP)
    assert summary(plan, rows(plan, result(plan), None)) is None


def test_who_has_not_begun_counts_under_no_mistake(roster, shelf):
    plan, marking = plan_of(roster, LESSON, STEP), Marking(roster, shelf, lambda: None)
    found = summary(plan, rows(plan, *[result(plan, "failed")] * 4))
    for pupil in roster.pupils[:2]:
        shelf.keep_checked(pupil.id, shelf.read(pupil.id, LESSON, STEP).work, found)
    listed = marking.listed(LESSON, STEP)
    assert (listed.often.missed, listed.often.count) == (MISSED, 2)
    assert [(pupil.name, pupil.state) for pupil in listed.without] == [("Eva", "not begun")]


def test_a_mistake_of_one_pupil_is_not_common(roster, shelf):
    plan, marking = plan_of(roster, LESSON, STEP), Marking(roster, shelf, lambda: None)
    ana = roster.pupils[0]
    found = summary(plan, rows(plan, *[result(plan, "failed")] * 4))
    shelf.keep_checked(ana.id, shelf.read(ana.id, LESSON, STEP).work, found)
    assert marking.listed(LESSON, STEP).often is None


def test_the_finished_runs_of_a_removed_pupil_are_deleted_and_no_others(roster, shelf):
    plan = plan_of(roster, LESSON, STEP)
    folder = runs_folder(roster.folder, LESSON, STEP)
    keys = [[key for key, _ in plan.pieces(handed_in)] for handed_in in plan.handed_in[:2]]
    with opened_journal(folder) as journal:
        for key in keys[0] + keys[1]:
            journal.add(key, b"{}")
    ana = roster.pupils[0]
    shelf.remove(ana.id)
    roster.remove(ana)
    forget_runs(roster)
    with opened_journal(folder) as journal:
        assert not any(key in journal for key in keys[0])
        assert all(key in journal for key in keys[1])


def test_the_runs_of_a_lesson_that_is_gone_are_deleted(roster):
    folder = runs_folder(roster.folder, "no lesson", 1)
    with opened_journal(folder) as journal:
        journal.add("0" * 32, b"{}")
    forget_runs(roster)
    with opened_journal(folder) as journal:
        assert len(journal) == 0


def test_all_or_nothing_is_handed_back(roster, shelf):
    marking = Marking(roster, shelf, lambda: None)
    ids = [pupil.id for pupil in roster.pupils]
    with pytest.raises(LearnBlockError, match="has not handed in"):
        marking.hand_back(LESSON, STEP, ids)
    assert not any(file.back for pupil in ids for file in shelf.of_pupil(pupil).values())
