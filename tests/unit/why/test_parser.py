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
    Ask,
    Question,
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
        ("turn left at 8.9", Question(Ask.MOVEMENT, "spin-left", 8.9)),
        ("why did the robot turn left at 8.9?", Question(Ask.MOVEMENT, "spin-left", 8.9)),
        ("why did it show joy?", Question(Ask.EMOTION, "joy")),
        ("¿Por qué mostró sorpresa en 3?", Question(Ask.EMOTION, "surprise", 3.0)),
        ("Why didn't it turn right?", Question(Ask.NOT_MOVEMENT, "spin-right")),
        ("why didn’t the robot stop at 3 s", Question(Ask.NOT_MOVEMENT, "stand", 3.0)),
        ("¿Por qué no giró a la izquierda en 8,9?", Question(Ask.NOT_MOVEMENT, "spin-left", 8.9)),
        ("¿por qué avanzó a los 2 s?", Question(Ask.MOVEMENT, "forward", 2.0)),
        ("not expressSurprise", Question(Ask.NOT_SKILL, "expressSurprise")),
        ("function.turn(90) at 1", Question(Ask.SKILL, "turn", 1.0)),
        ("not look surprised at 4", Question(Ask.NOT_SKILL, "expressSurprise", 4.0)),
        ("no poner cara de sorpresa", Question(Ask.NOT_SKILL, "expressSurprise")),
        ("not line 4", Question(Ask.NOT_LINE, "4")),
        ("¿por qué se ejecutó la línea 9?", Question(Ask.LINE, "9")),
        ("count at 3", Question(Ask.VALUE, "count", 3.0)),
        ("why is count 2?", Question(Ask.VALUE, "count")),
        ("valor de count en 3", Question(Ask.VALUE, "count", 3.0)),
        ("when near", Question(Ask.WHEN, "near")),
        ("why was near not active at 2?", Question(Ask.NOT_WHEN, "near", 2.0)),
        ('print "hello"', Question(Ask.PRINTED, "hello")),
        ("print hello", Question(Ask.PRINT, "hello")),
        ("why did the program end?", Question(Ask.END)),
        ("¿por qué terminó el programa?", Question(Ask.END)),
        ("why did it bump at 4?", Question(Ask.BUMP, "", 4.0)),
        ("goal", Question(Ask.GOAL)),
        ("¿por qué no llegó a la meta?", Question(Ask.GOAL)),
        ("objetivo", Question(Ask.GOAL)),
        ("why did it not reach the goal", Question(Ask.GOAL)),
        ("at 2.5", Question(Ask.NOW, "", 2.5)),
        ("what was it doing at 3", Question(Ask.NOW, "", 3.0)),
        ("what happened at 3 s?", Question(Ask.NOW, "", 3.0)),
        ("¿Qué hacía el robot en 3?", Question(Ask.NOW, "", 3.0)),
        ("ahora", Question(Ask.NOW)),
        ("turn", Question(Ask.MOVEMENT, "")),
        ("why did the robot not turn?", Question(Ask.NOT_MOVEMENT, "")),
        ("why did it turn only 3 times?", Question(Ask.MOVEMENT, "")),
        ("why does it keep turning at 5", Question(Ask.MOVEMENT, "", 5.0)),
        ("¿por qué no gira?", Question(Ask.NOT_MOVEMENT, "")),
        ("why did it drive in a curve", Question(Ask.MOVEMENT, "")),
        ("why is the robot so slow?", Question(Ask.SPEED, "slow")),
        ("¿por qué va tan despacio?", Question(Ask.SPEED, "slow")),
        ("why did the program stop?", Question(Ask.END)),
        ("¿por qué cambió count?", Question(Ask.VALUE, "count")),
        ("why is it surprised", Question(Ask.SKILL, "expressSurprise")),
        ("look suprised", Question(Ask.SKILL, "expressSurprise")),
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
        ("turn xyzzy right or what", Question(Ask.MOVEMENT, "spin-right")),
        ("frobnicate count", Question(Ask.VALUE, "count")),
    ],
)
def test_the_nearest_questions_are_about_the_same_thing(text, question, history):
    found = nearest(text, history)
    assert question.subject in [one.subject for one in found]


#: What children ask, each with what it means.
PLAIN = (
    ("why did it crash", Question(Ask.BUMP)),
    ("why did it crsh into the wal", Question(Ask.BUMP)),
    ("why did it drive into the box", Question(Ask.BUMP)),
    ("it hits the thing why", Question(Ask.BUMP)),
    ("porque se choco", Question(Ask.BUMP)),
    ("se da contra la pared por que", Question(Ask.BUMP)),
    ("why does it not stop", Question(Ask.NOT_MOVEMENT, "stand")),
    ("why doesnt it stop", Question(Ask.NOT_MOVEMENT, "stand")),
    ("WHY DOSNT IT STOP", Question(Ask.NOT_MOVEMENT, "stand")),
    ("por que no para", Question(Ask.NOT_MOVEMENT, "stand")),
    ("por que no se detiene", Question(Ask.NOT_MOVEMENT, "stand")),
    ("por que no frena", Question(Ask.NOT_MOVEMENT, "stand")),
    ("why did it not show joy", Question(Ask.NOT_SKILL, "expressJoy")),
    ("why no smile", Question(Ask.NOT_SKILL, "expressJoy")),
    ("why dosent it smile when it sees the box", Question(Ask.NOT_SKILL, "expressJoy")),
    ("por que no sonrie", Question(Ask.NOT_SKILL, "expressJoy")),
    ("por que no pone cara de alegria", Question(Ask.NOT_SKILL, "expressJoy")),
    ("why is it scared all the time", Question(Ask.EMOTION, "fear")),
    ("por que tiene miedo", Question(Ask.EMOTION, "fear")),
    ("why is it so slow", Question(Ask.SPEED, "slow")),
    ("por que va tan rapido", Question(Ask.SPEED, "fast")),
    ("why did nothing happen", Question(Ask.NOTHING)),
    ("por que no pasa nada", Question(Ask.NOTHING)),
    ("por que no hace nada", Question(Ask.NOTHING)),
    ("what made it turn", Question(Ask.MOVEMENT, "")),
    ("what made it go right", Question(Ask.MOVEMENT, "spin-right")),
    ("why is it spinnig", Question(Ask.MOVEMENT, "")),
    ("why does it go round and round", Question(Ask.MOVEMENT, "")),
    ("por que no para de dar vueltas", Question(Ask.MOVEMENT, "")),
    ("why did it turn between 0 and 2 s", Question(Ask.MOVEMENT, "", 2.0, 0.0)),
    ("por que giro entre 0 y 2", Question(Ask.MOVEMENT, "", 2.0, 0.0)),
    ("why did it not come back", Question(Ask.NOT_MOVEMENT, "back")),
    ("por que no vuelve", Question(Ask.NOT_MOVEMENT, "back")),
    ("por que no da marcha atras", Question(Ask.NOT_MOVEMENT, "back")),
    ("why does it go straight for so long", Question(Ask.LONG, "forward")),
    ("why does it not end", Question(Ask.NOT_END)),
    ("why doesnt my program stop", Question(Ask.NOT_END)),
    ("por que no termina el programa", Question(Ask.NOT_END)),
    ("why did my program break", Question(Ask.END)),
    ("por que me sale un error", Question(Ask.END)),
    ("why did it leave the line", Question(Ask.LOST)),
    ("por que se sale de la linea", Question(Ask.LOST)),
    ("por que no sigue la linea", Question(Ask.LOST)),
    ("why did it fall off the table", Question(Ask.FALL)),
    ("por que se cayo", Question(Ask.FALL)),
    ("why does it say hello", Question(Ask.PRINT, "hello")),
    ("por que escribe hello", Question(Ask.PRINTED, "hello")),
    ("what did it do between 1 and 3 s", Question(Ask.NOW, "", 3.0, 1.0)),
    ("is it stuck", Question(Ask.MOVEMENT, "stand")),
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
    assert (Ask.NOT_SKILL, "expressSurprise") in asked
    assert (Ask.NOT_WHEN, "near") in asked
    assert (Ask.VALUE, "count") in asked
    assert (Ask.NOT_SKILL, "expressJoy") not in asked
    assert (Ask.VALUE, "robot") not in asked


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
TIMELESS = {Ask.END, Ask.GOAL, Ask.REACHED}


def listed(history):
    moments = (0, 1.5, 4, history.end)
    lines = {str(number) for number in range(20)}
    return {
        *questions(history),
        *(one for time in moments for one in questions_about_moment(history, time)),
        *(one for time in moments for one in questions_about_lines(history, lines, time)),
        *(Question(Ask.PRINTED, text, 3.0) for text in ("at 5", "hello", "2")),
    }


@pytest.mark.parametrize(("program", "robot", "world"), PROGRAMS)
def test_each_listed_question_is_understood_in_each_language(program, robot, world, tmp_path):
    options = {"world": world, "seconds": 5, "seed": 0}
    history = logged_text(tmp_path, program, robot, **options).history
    printed = {str(line["print"]) for line in history.recorded.lines if "print" in line}
    for one in listed(history):
        if one.ask is Ask.PRINTED and one.subject not in printed:
            continue
        wanted = replace(one, time=None) if one.ask in TIMELESS else one
        for language in languages():
            words = translate(one.phrase, language)
            assert parse(words, history) == wanted, words
            assert parse(words.strip("¿?").lower(), history) == wanted, words


def test_a_question_about_no_subject_is_whole():
    words = {str(Question(ask).phrase) for ask in (Ask.BUMP, Ask.GOAL, Ask.PRINT, Ask.NOT_PRINT)}
    assert words == {
        "Why did the robot bump into something?",
        "Why was the goal not reached?",
        "Why was a text printed?",
        "Why was no text printed?",
    }
    assert str(Question(Ask.NOT_PRINT, "late").phrase) == 'Why was "late" not printed?'
    assert str(Question(Ask.VALUE, "x").phrase) == "Why does x have this value?"
