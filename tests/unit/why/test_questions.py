"""What can be asked about a run, as a whole, at a moment, and about lines."""

import pytest

from learnblock.i18n import translate
from learnblock.why.answers import answer
from learnblock.why.questions import (
    Question,
    QuestionKind,
    questions,
    questions_about_lines,
    questions_about_moment,
)
from logged_runs import logged_text

PROGRAM = (
    "function.expressJoy()\nfunction.move_straight(60)\nfunction.sleep(1)\nprint(3)\n"
    "repeat 2:\n    function.sleep(1)\n    print(3)\nend\n"
    "if function.is_front_obstacle(5):\n    function.turn_left()\n    function.expressFear()\nend\n"
    "function.stop_bot()\n"
)


@pytest.fixture(scope="module")
def history(tmp_path_factory):
    return logged_text(tmp_path_factory.mktemp("run"), PROGRAM, world="square", seed=0).history


def test_emotions_and_reached_goals_can_be_asked_about(history):
    found = questions(history)
    assert Question(QuestionKind.EMOTION, "joy", 0.0) in found
    assert Question(QuestionKind.GOAL, "four corners") in found


def test_a_moment_offers_what_the_program_could_have_done_instead(history):
    found = questions_about_moment(history, 1.5)
    assert found[:2] == (
        Question(QuestionKind.NOW, "", 1.5),
        Question(QuestionKind.MOVEMENT, "forward", 1.5),
    )
    others = {one.subject for one in found if one.ask is QuestionKind.NOT_MOVEMENT}
    assert others == {"spin-left", "stand"}
    assert Question(QuestionKind.NOT_SKILL, "expressFear", 1.5) in found


def test_a_robot_that_has_not_been_told_to_move_can_be_asked_why_it_stands_still(tmp_path):
    program = "function.sleep(2)\nfunction.move_straight(60)\nfunction.sleep(1)\n"
    history = logged_text(tmp_path, program, world="square", seed=0).history
    assert Question(QuestionKind.MOVEMENT, "stand", 1.0) in questions_about_moment(history, 1.0)


def test_a_line_that_ran_long_ago_can_be_asked_both_ways(history):
    assert questions_about_lines(history, {"2"}, 0.5) == (Question(QuestionKind.LINE, "2", 0.0),)
    assert questions_about_lines(history, {"2"}, 2.5) == (
        Question(QuestionKind.LINE, "2", 0.0),
        Question(QuestionKind.NOT_LINE, "2", 2.5),
    )
    assert questions_about_lines(history, {"10"}, None) == (
        Question(QuestionKind.NOT_LINE, "10", 3.0),
    )


@pytest.mark.parametrize(("time", "line"), [(None, 7), (3.0, 7), (2.0, 7), (1.0, 4)])
def test_a_printed_text_leads_to_the_line_that_printed_it_then(history, time, line):
    given = answer(history, Question(QuestionKind.PRINTED, "3", time))
    assert given.sentences[0].line == line


def test_an_emotion_leads_to_its_line(history):
    given = answer(history, Question(QuestionKind.EMOTION, "joy", 2.0))
    assert [(one.phrase.code, one.line) for one in given.sentences] == [("why-ran", 1)]


def test_a_reached_goal_is_answered_with_what_the_robot_did(tmp_path):
    program = "function.move_straight(100)\nfunction.sleep(30)\n"
    run = logged_text(tmp_path, program, world="tag-ahead", seconds=20, seed=0)
    for goal in run.history.recorded.ending["goals"]:
        ask = QuestionKind.REACHED if goal["state"] == "reached" else QuestionKind.GOAL
        codes = [
            one.phrase.code for one in answer(run.history, Question(ask, goal["name"])).sentences
        ]
        assert codes[0] == "why-goal"


def test_a_question_about_a_skill_has_the_values_of_its_call(history):
    asked = [one for one in questions(history) if one.subject == "move_straight"]
    assert {one.ask for one in asked} == {QuestionKind.SKILL, QuestionKind.NOT_SKILL}
    assert all("at 60 mm/s" in translate(one.phrase, "en") for one in asked)
