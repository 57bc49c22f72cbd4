"""Questions about a place: "at the wall"."""

import pytest

from asked import run_of
from learnblock.errors import LearnBlockError
from learnblock.why.parser import parse
from learnblock.why.questions import QuestionKind

AHEAD = "function.move_straight(100)\nfunction.sleep(20)\n"
SHORT = "function.move_straight(100)\nfunction.sleep(1)\n"


@pytest.mark.parametrize("text", ["at the wall", "what did it do at the wall", "en la pared"])
def test_a_place_alone_asks_what_the_robot_did_there(tmp_path, text):
    history = run_of(tmp_path, AHEAD, world="parking")
    (bump,) = (line["t"] for line in history.recorded.lines if "bump" in line)
    question = parse(text, history)
    assert (question.ask, question.time) == (QuestionKind.NOW, round(bump, 2))


def test_a_place_where_the_robot_never_was_gets_questions_that_can_be_answered(tmp_path):
    with pytest.raises(LearnBlockError) as refused:
        parse("at the wall", run_of(tmp_path, SHORT, world="parking"))
    assert refused.value.phrase.code == "why-not-understood"
