"""Sentences name the things that distance sensors looked at."""

import pytest

from learnblock.i18n import Phrase, translate
from learnblock.why.answers import Answers
from learnblock.why.questions import Question, QuestionKind
from learnblock.why.sentences import Explanation, Sentence
from learnblock.why.things import seen_in_run, thing_at, with_things
from logged_runs import logged_text

DRIVING = (
    "function.move_straight(100)\nforever:\n    if function.is_front_obstacle(150):\n"
    "        function.stop_bot()\n        function.sleep(9)\n    end\n"
    "    function.sleep(0.1)\nend\n"
)


@pytest.mark.parametrize(
    ("robot", "world", "thing"),
    [
        ("sim-ebo", "arena", "a block"),
        ("sim-ev3", "arena", "a block"),
        ("sim-thymio", "tags", "the world's edge"),
    ],
)
def test_a_reading_names_what_the_sensor_saw(tmp_path, robot, world, thing):
    run = logged_text(tmp_path, DRIVING, robot, world=world, seconds=15, seed=0)
    answers = Answers(run.history, seen_in_run(run.recorded))
    given = answers.answer(Question(QuestionKind.MOVEMENT, "stand"))
    assert f"({thing}" in " ".join(given.words("en"))


def test_things_are_named_in_the_readers_language():
    given = Explanation(
        (Sentence(Phrase("why-measured", side="x", mm=3, thing=thing_at("left", 1.0)), 1, 0, 1.0),)
    )
    [sentence] = with_things(given, lambda side, time: "light box").sentences
    assert translate(sentence.phrase, "es") == "el sensor x midió 3 mm (una caja ligera)"
    assert translate(given.sentences[0].phrase, "en") == "the x sensor measured 3 mm"


def test_moments_are_asked_for_in_their_order():
    asked = []
    phrases = [Phrase("why-facts", facts=(thing_at("left", time),)) for time in (3.0, 1.0, 2.0)]
    given = Explanation(tuple(Sentence(one, 1, 0, 0.0) for one in phrases))
    with_things(given, lambda side, time: asked.append(time))
    assert asked == [1.0, 2.0, 3.0]
