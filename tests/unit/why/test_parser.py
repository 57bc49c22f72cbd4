"""Questions as people write them."""

from contextlib import suppress
from dataclasses import replace

import pytest
from hypothesis import assume, given
from hypothesis.strategies import data, integers, sampled_from, text

from learnblock.errors import LearnBlockError
from learnblock.i18n import languages, translate
from learnblock.why.near import nearest
from learnblock.why.parser import parse
from learnblock.why.questions import (
    Question,
    QuestionKind,
    questions,
    questions_about_lines,
    questions_about_moment,
)
from logged_runs import logged_text

PROGRAM = """\
count = 0
when near = function.is_front_obstacle(100):
    function.expressSurprise()
    function.turn_left()
end
when start:
    count = 2
    print("hello")
    function.turn(90)
    function.move_straight(60)
end
"""


@pytest.fixture(scope="module")
def history(tmp_path_factory):
    return logged_text(
        tmp_path_factory.mktemp("run"), PROGRAM, world="arena", seconds=5, seed=0
    ).history


@pytest.mark.parametrize(
    ("text", "question"),
    [
        ("turn left at 8.9", Question(QuestionKind.MOVEMENT, "spin-left", 8.9)),
        ("why did the robot turn left at 8.9?", Question(QuestionKind.MOVEMENT, "spin-left", 8.9)),
        ("why did it show joy?", Question(QuestionKind.EMOTION, "joy")),
        ("¿Por qué mostró sorpresa en 3?", Question(QuestionKind.EMOTION, "surprise", 3.0)),
        ("Why didn't it turn right?", Question(QuestionKind.NOT_MOVEMENT, "spin-right")),
        ("why didn’t the robot stop at 3 s", Question(QuestionKind.NOT_MOVEMENT, "stand", 3.0)),
        (
            "¿Por qué no giró a la izquierda en 8,9?",
            Question(QuestionKind.NOT_MOVEMENT, "spin-left", 8.9),
        ),
        ("¿por qué avanzó a los 2 s?", Question(QuestionKind.MOVEMENT, "forward", 2.0)),
        ("not expressSurprise", Question(QuestionKind.NOT_SKILL, "expressSurprise")),
        ("function.turn(90) at 1", Question(QuestionKind.SKILL, "turn", 1.0)),
        ("not look surprised at 4", Question(QuestionKind.NOT_SKILL, "expressSurprise", 4.0)),
        ("no poner cara de sorpresa", Question(QuestionKind.NOT_SKILL, "expressSurprise")),
        ("not line 4", Question(QuestionKind.NOT_LINE, "4")),
        ("¿por qué se ejecutó la línea 9?", Question(QuestionKind.LINE, "9")),
        ("count at 3", Question(QuestionKind.VALUE, "count", 3.0)),
        ("why is count 2?", Question(QuestionKind.VALUE, "count")),
        ("valor de count en 3", Question(QuestionKind.VALUE, "count", 3.0)),
        ("when near", Question(QuestionKind.WHEN, "near")),
        ("why was near not active at 2?", Question(QuestionKind.NOT_WHEN, "near", 2.0)),
        ('print "hello"', Question(QuestionKind.PRINTED, "hello")),
        ("print hello", Question(QuestionKind.PRINT, "hello")),
        ("why did the program end?", Question(QuestionKind.END)),
        ("¿por qué terminó el programa?", Question(QuestionKind.END)),
        ("why did it bump at 4?", Question(QuestionKind.BUMP, "", 4.0)),
        ("goal", Question(QuestionKind.GOAL)),
        ("¿por qué no llegó a la meta?", Question(QuestionKind.GOAL)),
        ("objetivo", Question(QuestionKind.GOAL)),
        ("why did it not reach the goal", Question(QuestionKind.GOAL)),
        ("at 2.5", Question(QuestionKind.NOW, "", 2.5)),
        ("what was it doing at 3", Question(QuestionKind.NOW, "", 3.0)),
        ("what happened at 3 s?", Question(QuestionKind.NOW, "", 3.0)),
        ("¿Qué hacía el robot en 3?", Question(QuestionKind.NOW, "", 3.0)),
        ("ahora", Question(QuestionKind.NOW)),
        ("turn", Question(QuestionKind.MOVEMENT, "")),
        ("why did the robot not turn?", Question(QuestionKind.NOT_MOVEMENT, "")),
        ("why did it turn only 3 times?", Question(QuestionKind.MOVEMENT, "")),
        ("why does it keep turning at 5", Question(QuestionKind.MOVEMENT, "", 5.0)),
        ("¿por qué no gira?", Question(QuestionKind.NOT_MOVEMENT, "")),
        ("why did it drive in a curve", Question(QuestionKind.MOVEMENT, "")),
        ("why is the robot so slow?", Question(QuestionKind.SPEED, "slow")),
        ("¿por qué va tan despacio?", Question(QuestionKind.SPEED, "slow")),
        ("why did the program stop?", Question(QuestionKind.END)),
        ("¿por qué cambió count?", Question(QuestionKind.VALUE, "count")),
        ("why is it surprised", Question(QuestionKind.SKILL, "expressSurprise")),
        ("look suprised", Question(QuestionKind.SKILL, "expressSurprise")),
    ],
)
def test_a_question_is_understood(text, question, history):
    assert parse(text, history) == question


@pytest.mark.parametrize(
    "text",
    [
        "",
        "why is the sky blue",
        "xyzzy",
        "why did the light turn red",
        "¿por qué se encendió la luz?",
        "¿por qué es azul el cielo?",
        "_",
    ],
)
def test_what_is_not_understood_gets_three_questions_that_are(text, history):
    with pytest.raises(LearnBlockError) as caught:
        parse(text, history)
    phrase = caught.value.phrase
    assert phrase.code == "why-not-understood"
    for language in languages():
        offered = [translate(phrase.values[one], language) for one in ("first", "second", "third")]
        assert len(set(offered)) == 3
        for question in offered:
            assert "…" not in question
            parse(question, history)


@pytest.mark.parametrize(
    ("text", "question"),
    [
        ("turn xyzzy right or what", Question(QuestionKind.MOVEMENT, "spin-right")),
        ("frobnicate count", Question(QuestionKind.VALUE, "count")),
    ],
)
def test_the_nearest_questions_are_about_the_same_thing(text, question, history):
    found = nearest(text, history)
    assert question.subject in [one.subject for one in found]


#: What children ask, each with what it means.
PLAIN = (
    ("why did it crash", Question(QuestionKind.BUMP)),
    ("why did it crsh into the wal", Question(QuestionKind.BUMP)),
    ("why did it drive into the box", Question(QuestionKind.BUMP)),
    ("it hits the thing why", Question(QuestionKind.BUMP)),
    ("porque se choco", Question(QuestionKind.BUMP)),
    ("se da contra la pared por que", Question(QuestionKind.BUMP)),
    ("why does it not stop", Question(QuestionKind.NOT_MOVEMENT, "stand")),
    ("why doesnt it stop", Question(QuestionKind.NOT_MOVEMENT, "stand")),
    ("WHY DOSNT IT STOP", Question(QuestionKind.NOT_MOVEMENT, "stand")),
    ("por que no para", Question(QuestionKind.NOT_MOVEMENT, "stand")),
    ("por que no se detiene", Question(QuestionKind.NOT_MOVEMENT, "stand")),
    ("por que no frena", Question(QuestionKind.NOT_MOVEMENT, "stand")),
    ("why did it not show joy", Question(QuestionKind.NOT_SKILL, "expressJoy")),
    ("why no smile", Question(QuestionKind.NOT_SKILL, "expressJoy")),
    ("why dosent it smile when it sees the box", Question(QuestionKind.NOT_SKILL, "expressJoy")),
    ("por que no sonrie", Question(QuestionKind.NOT_SKILL, "expressJoy")),
    ("por que no pone cara de alegria", Question(QuestionKind.NOT_SKILL, "expressJoy")),
    ("why is it scared all the time", Question(QuestionKind.EMOTION, "fear")),
    ("por que tiene miedo", Question(QuestionKind.EMOTION, "fear")),
    ("why is it so slow", Question(QuestionKind.SPEED, "slow")),
    ("por que va tan rapido", Question(QuestionKind.SPEED, "fast")),
    ("why did nothing happen", Question(QuestionKind.NOTHING)),
    ("por que no pasa nada", Question(QuestionKind.NOTHING)),
    ("por que no hace nada", Question(QuestionKind.NOTHING)),
    ("what made it turn", Question(QuestionKind.MOVEMENT, "")),
    ("what made it go right", Question(QuestionKind.MOVEMENT, "spin-right")),
    ("why is it spinnig", Question(QuestionKind.MOVEMENT, "")),
    ("why does it go round and round", Question(QuestionKind.MOVEMENT, "")),
    ("por que no para de dar vueltas", Question(QuestionKind.MOVEMENT, "")),
    ("why did it turn between 0 and 2 s", Question(QuestionKind.MOVEMENT, "", 2.0, 0.0)),
    ("por que giro entre 0 y 2", Question(QuestionKind.MOVEMENT, "", 2.0, 0.0)),
    ("why did it not come back", Question(QuestionKind.NOT_MOVEMENT, "back")),
    ("por que no vuelve", Question(QuestionKind.NOT_MOVEMENT, "back")),
    ("por que no da marcha atras", Question(QuestionKind.NOT_MOVEMENT, "back")),
    ("why does it go straight for so long", Question(QuestionKind.LONG, "forward")),
    ("why does it not end", Question(QuestionKind.NOT_END)),
    ("why doesnt my program stop", Question(QuestionKind.NOT_END)),
    ("por que no termina el programa", Question(QuestionKind.NOT_END)),
    ("why did my program break", Question(QuestionKind.END)),
    ("por que me sale un error", Question(QuestionKind.END)),
    ("why did it leave the line", Question(QuestionKind.LOST)),
    ("por que se sale de la linea", Question(QuestionKind.LOST)),
    ("por que no sigue la linea", Question(QuestionKind.LOST)),
    ("why did it fall off the table", Question(QuestionKind.FALL)),
    ("por que se cayo", Question(QuestionKind.FALL)),
    ("why does it say hello", Question(QuestionKind.PRINT, "hello")),
    ("por que escribe hello", Question(QuestionKind.PRINTED, "hello")),
    ("what did it do between 1 and 3 s", Question(QuestionKind.NOW, "", 3.0, 1.0)),
    ("is it stuck", Question(QuestionKind.MOVEMENT, "stand")),
)


@pytest.mark.parametrize(("text", "question"), PLAIN, ids=[one[0] for one in PLAIN])
def test_a_plain_sentence_is_understood(text, question, history):
    assert parse(text, history) == question


@given(data())
def test_a_slip_of_a_key_changes_no_meaning(history, draw):
    text, question = draw.draw(sampled_from([one for one in PLAIN if len(one[0]) > 20]))
    longest = max(text.split(), key=len)
    assume(len(longest) > 6 and text.count(longest) == 1)
    place = draw.draw(integers(1, len(longest) - 2))
    twice = longest[:place] + longest[place] + longest[place:]
    assert parse(text.replace(longest, twice), history) == question


@given(text())
def test_any_text_is_a_question_or_is_answered_with_three(history, written):
    with suppress(LearnBlockError):
        assert isinstance(parse(written, history), Question)


def test_only_what_the_program_makes_possible_is_listed(history):
    listed = questions(history)
    asked = {(one.ask, one.subject) for one in listed}
    assert (QuestionKind.NOT_SKILL, "expressSurprise") in asked
    assert (QuestionKind.NOT_WHEN, "near") in asked
    assert (QuestionKind.VALUE, "count") in asked
    assert (QuestionKind.NOT_SKILL, "expressJoy") not in asked
    assert (QuestionKind.VALUE, "robot") not in asked


def test_each_question_has_words_in_both_languages(history):
    for one in questions(history):
        assert str(one.phrase).endswith("?")
        assert translate(one.phrase, "es").startswith("¿")


#: Programs with all that questions are about, each with its robot and world.
PROGRAMS = (
    (PROGRAM, "sim-ebo", "arena"),
    (
        "turn = 0\nrepeat 2:\n    function.turn(90)\n    function.move_straight(60)\n"
        "    function.sleep(1)\n    turn += 1\nend\n"
        'function.expressJoy()\nfunction.say_Text("done")\nprint(turn)\nprint("at 5")\n',
        "sim-ebo",
        "square",
    ),
    (
        "way = [1, 2]\ndef go(x):\n    function.drive_distance(x)\n    function.turn_back()\nend\n"
        "when line = function.is_there_black_line():\n    function.stop_bot()\nend\n"
        "when start:\n    for x in way: go(x * 100) end\n    print(way)\nend\n",
        "sim-thymio",
        "line",
    ),
    (
        "def f(n):\n    function.show_text(n)\n    return n\nend\nif_ = f(3)\n"
        "function.look_floor()\n"
        "function.move_straight(200)\nfunction.sleep(9)\nfunction.expressNeutral()\n",
        "sim-cozmo",
        "tag-ahead",
    ),
)
#: Questions whose words have no time.
TIMELESS = {QuestionKind.END, QuestionKind.GOAL, QuestionKind.REACHED}


def listed(history):
    moments = (0, 1.5, 4, history.end)
    lines = {str(number) for number in range(20)}
    return {
        *questions(history),
        *(one for time in moments for one in questions_about_moment(history, time)),
        *(one for time in moments for one in questions_about_lines(history, lines, time)),
        *(Question(QuestionKind.PRINTED, text, 3.0) for text in ("at 5", "hello", "2")),
    }


@pytest.mark.parametrize(("program", "robot", "world"), PROGRAMS)
def test_each_listed_question_is_understood_in_each_language(program, robot, world, tmp_path):
    options = {"world": world, "seconds": 5, "seed": 0}
    history = logged_text(tmp_path, program, robot, **options).history
    printed = {str(line["print"]) for line in history.recorded.lines if "print" in line}
    for one in listed(history):
        if one.ask is QuestionKind.PRINTED and one.subject not in printed:
            continue
        wanted = replace(one, time=None) if one.ask in TIMELESS else one
        for language in languages():
            words = translate(one.phrase, language)
            assert parse(words, history) == wanted, words
            assert parse(words.strip("¿?").lower(), history) == wanted, words


def test_a_question_about_no_subject_is_whole():
    words = {
        str(Question(ask).phrase)
        for ask in (
            QuestionKind.BUMP,
            QuestionKind.GOAL,
            QuestionKind.PRINT,
            QuestionKind.NOT_PRINT,
        )
    }
    assert words == {
        "Why did the robot bump into something?",
        "Why was the goal not reached?",
        "Why was a text printed?",
        "Why was no text printed?",
    }
    assert str(Question(QuestionKind.NOT_PRINT, "late").phrase) == 'Why was "late" not printed?'
    assert str(Question(QuestionKind.VALUE, "x").phrase) == "Why does x have this value?"
