"""No answer names a cause that is later than its effect, nor anything later than its question."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.why.answers import Answers
from learnblock.why.history import EventHistory
from learnblock.why.questions import Question, QuestionKind, questions, questions_about_moment
from logged_runs import logged_example

RUNS = (
    ("avoid.bt", "sim-ebo", "obstacles"),
    ("labyrinth.bt", "sim-ebo", "labyrinth"),
    ("line-thymio.bt", "sim-thymio", "line"),
    ("polygons.bt", "sim-ev3", "polygons"),
    ("tags.bt", "sim-ebo", "tags"),
    ("watch-out.bt", "sim-thymio", "table"),
    ("first/square.bt", "sim-ev3", "square"),
    ("imitate.bt", "sim-cozmo", "faces"),
    ("patrol.bt", "sim-cozmo", "patrol"),
    ("first/turn-away.bt", "sim-thymio", "arena"),
)
#: What is explained: a sentence behind one of these tells its causes.
EFFECTS = frozenset(
    {
        "why-moved",
        "why-moved-alone",
        "why-ran",
        "why-when-ran",
        "why-it-did",
        "why-overridden-soon",
        "why-overridden-later",
        "why-needs",
        "why-waiting",
        "why-bumped",
        "why-meanwhile",
        "why-when-never",
    }
)
CAUSES = frozenset(
    {
        "why-condition-was",
        "why-loop-over",
        "why-when-was",
        "why-switched",
        "why-called",
        "why-given",
        "why-set",
        "why-returned",
        "why-turn",
        "why-turns-over",
        "why-after",
        "why-left-loop",
        "why-camera",
    }
)
#: The time of a question is rounded.
ROUNDED = 0.07


@pytest.fixture(scope="module")
def histories():
    """The runs so far, by their program."""
    found = {}

    def find(name, robot, world):
        if name not in found:
            run = logged_example(name, robot, world=world, seconds=6, seed=0)
            found[name] = run.history, Answers(run.history)
        return found[name]

    return find


def assert_causes_come_first(history: EventHistory, answers: Answers, question: Question):
    given = answers.answer(question)
    told = (*given.sentences, *given.more)
    asked = history.end if question.time is None else question.time
    effect = asked
    # The heads of several parts are told together; what did not happen has no moment of its own.
    is_one = question.time is not None and question.since is None
    is_one = is_one and not question.ask.startswith("not-")
    for one in told:
        if one.event < 0:
            continue
        assert one.time <= asked + ROUNDED, (str(question.phrase), str(one.phrase))
        if one.phrase.code in EFFECTS:
            effect = history.time(one.event)
        elif one.phrase.code in CAUSES and is_one:
            assert history.time(one.event) <= effect + ROUNDED, (
                str(question.phrase),
                str(one.phrase),
            )


@pytest.mark.sample(3)
@pytest.mark.parametrize(("name", "robot", "world"), RUNS, ids=[one[0] for one in RUNS])
def test_no_cause_of_a_listed_question_is_later_than_its_effect(name, robot, world, histories):
    history, answers = histories(name, robot, world)
    for question in questions(history):
        assert_causes_come_first(history, answers, question)


@pytest.mark.sample(3)
@pytest.mark.parametrize(("name", "robot", "world"), RUNS, ids=[one[0] for one in RUNS])
def test_no_cause_at_any_moment_is_later_than_its_effect(name, robot, world, histories):
    history, answers = histories(name, robot, world)

    @settings(max_examples=6, deadline=None)
    @given(st.floats(0, history.end))
    def check(time):
        asked = questions_about_moment(history, time)
        others = (
            Question(ask, "", round(time, 2))
            for ask in (QuestionKind.NOTHING, QuestionKind.NOT_END, QuestionKind.LOST)
        )
        for question in (*asked, *others):
            assert_causes_come_first(history, answers, question)

    check()


@pytest.mark.sample(2)
@pytest.mark.parametrize(("name", "robot", "world"), RUNS[:4], ids=[one[0] for one in RUNS[:4]])
def test_what_is_told_of_a_span_happened_in_it_or_led_to_it(name, robot, world, histories):
    history, answers = histories(name, robot, world)
    for start, end in ((0.5, 2.0), (3.0, 5.0)):
        for question in questions(history):
            of_span = Question(question.ask, question.subject, end, start)
            if question.ask in (QuestionKind.END, QuestionKind.NOT_END):
                continue
            assert_causes_come_first(history, answers, of_span)
