"""Answers about the score, the lives and the end of a game, and about goals that it missed."""

import pytest

from learnblock.why.answers import answer
from learnblock.why.missed import first_missed
from learnblock.why.questions import Question, QuestionKind, questions
from logged_runs import logged_text

WORLD = """
[game]
lives = 2
countdown = 4

[[collectable]]
kind = "star"
x = 250
y = 0
score = 1

[[collectable]]
kind = "star"
x = 250
y = 700

[[collectable]]
kind = "bug"
x = 500
y = 0
lives = -1

[[gate]]
x = 0
y = 500

[[goal.collect]]

[[goal.gates]]

[[goal.score]]
points = 9

[[goal.score]]
name = "unharmed"
points = 9
lose_nothing = true
"""
PROGRAM = """when star = function.collected("star"):
    function.change_score(2)
end

main:
    function.move_straight(150)
end
"""


@pytest.fixture
def history(tmp_path):
    (tmp_path / "game.toml").write_text(WORLD.replace("countdown", "goals_win = false\ncountdown"))
    world = str(tmp_path / "game.toml")
    return logged_text(tmp_path, PROGRAM, "sim-ebo", world=world, seconds=9).history


def codes(history, kind, subject="", time=None):
    sentences = answer(history, Question(kind, subject, time)).sentences
    return [sentence.phrase.code for sentence in sentences]


def test_a_game_can_be_asked_about(history):
    asked = {(question.ask, question.subject) for question in questions(history)}

    assert {
        (QuestionKind.SCORE, "3"),
        (QuestionKind.LIVES, ""),
        (QuestionKind.GAME, "lost"),
    } <= asked


def test_a_score_comes_from_things_and_from_lines(history):
    given = codes(history, QuestionKind.SCORE, "3")

    assert "why-score-changed-by" in given
    assert "why-score-changed" in given
    assert any(code.startswith("why-ran") for code in given)


def test_a_score_of_earlier_knows_nothing_of_what_came_later(history):
    assert "why-score-changed" not in codes(history, QuestionKind.SCORE, "1", 1.0)


def test_a_lost_life_has_the_thing_that_took_it(history):
    (sentence, *_) = answer(history, Question(QuestionKind.LIVES)).sentences

    assert sentence.phrase.code == "why-lives-changed-by"
    assert sentence.phrase.values["thing"] == "bug 3"


def test_a_game_that_is_over_has_its_reason(history):
    (sentence, *_) = answer(history, Question(QuestionKind.GAME, "lost")).sentences

    assert (sentence.phrase.code, sentence.phrase.values["reason"]) == ("why-game-ended", "time")


@pytest.mark.parametrize(
    ("goal", "code", "values"),
    [
        ("collect", "miss-collect", {"count": 2, "asked": 3}),
        ("gates", "miss-gates", {"count": 0, "asked": 1}),
        ("score", "miss-score", {"score": 3, "asked": 9}),
        ("unharmed", "miss-life-lost-by", {"thing": "bug 3"}),
    ],
)
def test_a_missed_goal_of_a_game_says_by_how_much(history, goal, code, values):
    sentences = answer(history, Question(QuestionKind.GOAL, goal)).sentences
    (miss,) = [one.phrase for one in sentences if one.phrase.code == code]

    assert values.items() <= miss.values.items()


WINNING = """
[[start]]
name = "west"
x = -400
y = 0

[[team]]
name = "Lions"
colour = "red"
robots = ["west"]

[[goal.reach]]
name = "middle"
x = 0
y = 0
wins = true

[[goal.reach]]
name = "far"
x = 900
y = 0
"""


@pytest.fixture(params=["team", "robot"])
def won(request, tmp_path):
    """A run that a goal has won for a team, or for a robot without one; who it says has won."""
    world = tmp_path / "won.toml"
    is_team = request.param == "team"
    world.write_text(WINNING if is_team else WINNING.replace('robots = ["west"]', ""))
    text = "main:\n    function.move_straight(150)\n    function.sleep(60)\nend\n"
    history = logged_text(tmp_path, text, "sim-ebo", world=str(world), seconds=20).history
    return history, f"why-{request.param}-won"


def test_a_game_that_a_goal_won_has_its_winner_and_the_goal(won):
    history, code = won
    (sentence, *_) = answer(history, Question(QuestionKind.GAME, "won")).sentences

    assert sentence.phrase.code == code
    assert sentence.phrase.values["goal"] == "middle"
    assert sentence.phrase.values.get("team", "Lions") == "Lions"


def test_a_goal_that_was_missed_and_the_end_of_the_program_have_who_won(won):
    history, code = won

    assert codes(history, QuestionKind.GOAL, "far")[:2] == ["why-goal", code]
    ended = codes(history, QuestionKind.END)
    assert code in ended
    assert "why-finished" not in ended


def test_a_game_that_a_goal_won_missed_nothing(won):
    history, _ = won

    assert first_missed(history.recorded) is None
