"""Correct programs: whatever is asked about them, no answer blames what is right."""

import pytest

from learnblock.lessons.reading import find_lesson, shipped
from learnblock.why.answers import Answers
from learnblock.why.questions import questions, questions_about_moment
from learnblock.why.sentences import FIRST
from logged_runs import logged_example, logged_text

#: Examples, each with its robot and world.
EXAMPLES = (
    ("avoid.bt", "sim-ebo", "obstacles"),
    ("dance.bt", "sim-cozmo", "stage"),
    ("first/bump.bt", "sim-ebo", "bumper"),
    ("first/corner.bt", "sim-ebo", "heading"),
    ("first/distance.bt", "sim-thymio", "distance"),
    ("first/edge.bt", "sim-thymio", "edge"),
    ("first/park.bt", "sim-ebo", "parking"),
    ("first/square.bt", "sim-ev3", "square"),
    ("first/there-and-back.bt", "sim-cozmo", "patrol"),
    ("first/timer.bt", "sim-ebo", "distance"),
    ("flower.bt", "sim-ebo", "flower"),
    ("line-states.bt", "sim-ebo", "line"),
    ("square.bt", "sim-ebo", "square"),
    ("tags.bt", "sim-ebo", "tags"),
    ("watch-out.bt", "sim-thymio", "table"),
)
#: The moments that are asked about, in s.
MOMENTS = (2.0, 7.5)
#: What is said of programs that have a mistake.
BLAME = frozenset(
    {
        "why-failed",
        "why-never-called",
        "why-never-activated",
        "why-activates-other",
        "why-no-return",
        "why-nothing-to-repeat",
        "why-set-through",
        "why-own-name",
        "why-never-read",
        "why-unknown",
    }
)


@pytest.mark.sample(8)
@pytest.mark.parametrize(("name", "robot", "world"), EXAMPLES, ids=[one[0] for one in EXAMPLES])
def test_nothing_is_blamed_that_is_right(name, robot, world):
    run = logged_example(name, robot, world=world, seconds=6, seed=1)
    history, missing = run.history, {one["skill"] for one in run.report.no_effect}
    for question, sentence in told(history, questions(history)):
        assert sentence.phrase.code not in BLAME, (question, str(sentence.phrase))
        assert sentence.phrase.code != "why-no-effect" or missing, question
        assert 0 <= sentence.line <= len(history.program.written.splitlines())
        assert 0 <= sentence.time <= history.end


@pytest.mark.sample(8)
@pytest.mark.parametrize("name", shipped())
def test_nothing_is_blamed_in_the_solutions_of_lessons(name, tmp_path):
    lesson = find_lesson(name)
    step = max(map(int, lesson.teacher.solutions))
    solution = lesson.solution(step)
    with lesson.world_file(step) as world:
        robot = lesson.robots(step)[0]
        run = logged_text(tmp_path, solution, robot, world=world, seconds=10, seed=0)
    history = run.history
    asked = [one for time in MOMENTS for one in questions_about_moment(history, time)]
    for question, sentence in told(history, dict.fromkeys([*questions(history), *asked])):
        assert sentence.phrase.code not in BLAME, (question, str(sentence.phrase))
        # No line is told to come after itself.
        assert str(sentence.line) != sentence.phrase.values.get("inner"), str(sentence.phrase)


def told(history, asked):
    """Each question with each sentence of its answer."""
    answers = Answers(history)
    for question in asked:
        given = answers.answer(question)
        assert 0 < len(given.sentences) <= FIRST, question
        yield from ((question, sentence) for sentence in (*given.sentences, *given.more))
