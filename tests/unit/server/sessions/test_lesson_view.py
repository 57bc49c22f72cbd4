"""What a page shows of a lesson."""

import pytest

import small_lesson
from learnblock.i18n import Phrase
from learnblock.lessons.checks import (
    Collided,
    Drives,
    Ends,
    GoalReached,
    Happens,
    Never,
    Reaches,
    Size,
    Uses,
)
from learnblock.lessons.judging import Verdict
from learnblock.lessons.misses import Miss
from learnblock.lessons.reading import read_files
from learnblock.project.files.lesson_folder import StepProgress
from learnblock.server.sessions import lesson_view as view

RIGHT = ["function.expressJoy()", "function.sleep(1)", "function.stop_bot()"]
ALSO = """
also = ['''
main:
    function.sleep(1)
    function.expressJoy()
    function.stop_bot()
end
''']
"""


@pytest.fixture
def opened():
    """The small lesson, with a second right order of its puzzle."""
    files = dict(small_lesson.FILES)
    files["lesson.toml"] = files["lesson.toml"].replace("[step.puzzle]", f"[step.puzzle]{ALSO}")
    return read_files("small", {path: text.encode() for path, text in files.items()})


def judged(opened, *order):
    return view.judged_puzzle(opened, opened.step(3), [RIGHT[index] for index in order])


def test_every_right_order_of_a_puzzle_solves_it(opened):
    assert judged(opened, 0, 1, 2).right
    assert judged(opened, 1, 0, 2).right
    assert not judged(opened, 2, 1, 0).right


def test_a_wrong_order_is_compared_with_the_one_that_begins_most_alike(opened):
    assert judged(opened, 1, 2, 0).good == 1
    assert judged(opened, 1, 0).good == 2


@pytest.mark.parametrize(
    ("piece", "kind"),
    [
        ("repeat 4:", "controls_repeat_ext"),
        ("elif function.is_tag(3):", "controls_if"),
        ("main:", "lb_main"),
        ("def go(side):", "procedures_defnoreturn"),
    ],
)
def test_a_line_that_begins_a_block_is_drawn(piece, kind):
    [[[first, *_]]] = [drawn.stacks for drawn in view.drawings_in((), [piece]).values()]
    assert first.type == kind


def test_a_line_that_is_no_block_is_not_drawn():
    assert view.drawings_in((), ["else:", "end"]) == {}


@pytest.mark.parametrize(
    ("check", "question"),
    [
        (Never(what=Collided()), ("bump", "")),
        (Reaches(goals=("tag 8",)), ("goal", "tag 8")),
        (Reaches(), ("goal", "")),
        (Reaches(goals=("tag 8", "tag 9")), ("goal", "")),
        (Happens(what=GoalReached(name="tag 8")), ("goal", "tag 8")),
        (Drives(at_least=100), ("now", "")),
        (Ends(), ("now", "")),
        (Uses(skill="turn"), ("", "")),
        (Size(blocks=3), ("", "")),
    ],
)
def test_a_check_that_failed_leads_to_a_question_about_the_run(check, question):
    [failed] = view.goals([Verdict(check, 0, "failed")], StepProgress())
    assert (failed.ask, failed.subject) == question


@pytest.mark.parametrize("state", ["met", "open"])
def test_a_check_that_has_not_failed_leads_to_none(state):
    [shown] = view.goals([Verdict(Never(what=Collided()), 0, state)], StepProgress())
    assert (shown.ask, shown.subject) == ("", "")


def test_before_the_first_run_nothing_is_missed():
    verdicts = [Verdict(Uses(construct="loop"), 0, "failed"), Verdict(Size(blocks=9), 1, "met")]
    shown = view.goals(view.untried(verdicts), StepProgress())
    assert [goal.state for goal in shown] == ["open", "met"]


def test_a_missed_goal_has_its_place_and_says_by_how_much():
    miss = Miss(Phrase("miss-stopped", gap="80 mm short"), (300.0, 0.0), (220.0, 0.0))
    (goal,) = view.goals([Verdict(Ends(), 0, "failed", miss=miss)], StepProgress())
    assert goal.reason == miss.words
    assert (goal.place, goal.nearest) == ((300.0, 0.0), (220.0, 0.0))
