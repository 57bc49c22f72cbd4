"""What answers say, rule by rule."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.i18n import languages, translate
from learnblock.why import EventHistory, Recorded
from learnblock.why.answers import Answers, answer
from learnblock.why.parser import parse
from learnblock.why.questions import Question, QuestionKind, questions
from logged_runs import logged_text


def asked(folder, program, question, robot="sim-ebo", seen=None, **options):
    """The codes and lines of an answer to a question about a program."""
    options = {"world": "empty", "seconds": 5, "seed": 0, **options}
    history = logged_text(folder, program, robot, **options).history
    given = answer(history, parse(question, history), seen)
    return [(one.phrase.code, one.line) for one in given.sentences], given.words("en")


def test_a_reading_comes_with_its_limit_and_the_thing_it_hit(tmp_path):
    program = (
        "if function.is_front_obstacle(900):\n    function.stop_bot()\nend\nfunction.sleep(1)\n"
    )
    told, words = asked(
        tmp_path, program, "stop", world="arena", seen=lambda side, time: f"box {side}"
    )
    assert told == [("why-moved", 2), ("why-condition-was", 1)]
    assert "the front sensor measured 5" in words[1]
    assert "mm (box front), less than 900 mm" in words[1]


def test_a_goal_that_was_missed_is_answered_with_the_distance(tmp_path):
    program = "repeat(4):\n    function.drive_distance(300)\n    function.turn(90)\nend\n"
    told, words = asked(
        tmp_path, program, "goal four corners", "sim-ev3", world="square", seconds=60
    )
    assert told[:2] == [("why-goal", 0), ("miss-corner", 0)]
    assert words[1] == "The second corner: 100 mm too far left."


def test_a_missing_device_is_named(tmp_path):
    told, words = asked(tmp_path, "function.look_floor()\n", "not look down", "sim-thymio")
    assert told == [("why-no-effect", 1)]
    assert "has no" in words[0]


def test_a_command_that_is_replaced_says_by_which(tmp_path):
    program = "function.turn_left()\nfunction.move_straight(50)\nfunction.sleep(1)\n"
    told, _ = asked(tmp_path, program, "not turn left")
    assert told == [("why-it-did", 1), ("why-overridden-soon", 2)]


def test_a_condition_that_is_never_right_tells_the_closest_value(tmp_path):
    program = (
        "function.move_straight(50)\nforever:\n    if function.is_front_obstacle(50):\n"
        "        function.stop_bot()\n    end\n    function.sleep(0.1)\nend\n"
    )
    told, words = asked(tmp_path, program, "not stop", world="arena")
    assert told[0] == ("why-needs", 3)
    assert "not less than 50 mm. The closest was" in words[0]


def test_a_skill_that_is_not_in_the_program_says_what_was_done_instead(tmp_path):
    program = "function.move_straight(50)\nfunction.sleep(1)\n"
    told, _ = asked(tmp_path, program, "not look happy")
    assert told[:2] == [("why-no-such-skill", 0), ("why-moved", 1)]


def test_a_long_statement_is_named(tmp_path):
    program = "function.move_straight(50)\nfunction.sleep(60)\nfunction.stop_bot()\n"
    told, words = asked(tmp_path, program, "not stop")
    assert told == [("why-busy", 2)]
    assert words[0].startswith("From 0 to 5 s the program was busy with line 2, sleep(60)")


def test_a_list_of_two_names_is_followed(tmp_path):
    program = "a = [1]\nb = a\nappend(b, 2)\nfunction.sleep(1)\n"
    told, _ = asked(tmp_path, program, "value of a")
    assert told[0] == ("why-set-through", 3)
    assert ("why-set", 2) in told


def test_a_returned_value_leads_to_its_return(tmp_path):
    program = "def f(x):\n    return x + 1\nend\ny = f(2)\nfunction.sleep(1)\n"
    told, _ = asked(tmp_path, program, "y")
    assert told[:2] == [("why-set", 4), ("why-returned", 2)]


def test_an_error_is_told_with_its_values(tmp_path):
    told, words = asked(tmp_path, "n = 0\nfunction.sleep(1)\nprint(3 / n)\n", "not line 3")
    assert told == [("why-failed", 3), ("why-set", 1)]
    assert words[1].startswith("n was 0")


def test_a_goal_that_was_missed_is_asked_about(tmp_path):
    program = "function.move_straight(20)\nfunction.sleep(2)\n"
    told, _ = asked(tmp_path, program, "goal", world="square")
    assert told[0] == ("why-goal", 0)


def test_a_collision_leads_to_the_command(tmp_path):
    program = "function.move_straight(150)\nfunction.sleep(20)\n"
    told, _ = asked(tmp_path, program, "why did it bump?", world="arena", seconds=20)
    assert told[:2] == [("why-bumped", 0), ("why-moved", 1)]


def test_a_collision_leads_to_what_would_have_prevented_it(tmp_path):
    program = (
        "function.move_straight(100)\nforever:\n    if function.is_front_obstacle(10):\n"
        "        function.turn(90)\n    end\n    function.sleep(0.1)\nend\n"
    )
    told, _ = asked(tmp_path, program, "bump", world="arena", seconds=15)
    assert told[1:3] == [("why-moved", 1), ("why-needs", 3)]


def test_a_thing_that_never_happened_is_said_not_to_have(tmp_path):
    told, _ = asked(tmp_path, "function.move_straight(20)\nfunction.sleep(2)\n", "turn left at 1")
    assert told[0] == ("why-not-happened", 0)


PROGRAMS = (
    "x = 0\nwhen a = function.is_front_obstacle(700):\n    x += 1\n"
    "    if x > 3: activate b end\nend\n"
    "when b:\n    function.turn_left()\n    if time_b > 1: deactivate b end\nend\n",
    "def f(n):\n    if n < 1: return 0 end\n    return n + f(n - 1)\nend\n"
    "l = [1, 2]\nm = l\nfor i in l:\n    append(m, f(i))\n    function.turn(20)\n"
    "    if len(m) > 4: break end\nend\nwait until function.is_front_obstacle(10)\n",
    'd = {"a": 1}\nd["b"] = 2\nrepeat 3:\n    print(d["c"] if "c" in d else 0)\n'
    '    function.move_straight(40)\n    function.sleep(0.3)\nend\nprint(d["z"])\n',
)


@pytest.fixture(scope="module", params=PROGRAMS, ids=["whens", "functions", "error"])
def run(request, tmp_path_factory):
    return logged_text(
        tmp_path_factory.mktemp("run"), request.param, world="arena", seconds=5, seed=0
    ).recorded


def test_each_listed_question_is_answered_in_each_language(run):
    history = EventHistory(run)
    answers = Answers(history)
    for question in questions(history):
        given = answers.answer(question)
        assert given.sentences
        for sentence in (*given.sentences, *given.more):
            for language in languages():
                assert translate(sentence.phrase, language)


SUBJECTS = ("a", "b", "x", "l", "m", "d", "4", "7", "turn", "print", "spin-left", "stand", "")


@settings(max_examples=80, deadline=None)
@given(
    share=st.floats(0, 1),
    ask=st.sampled_from(list(QuestionKind)),
    subject=st.sampled_from(SUBJECTS),
    time=st.none() | st.floats(0, 10),
)
def test_any_question_about_a_log_that_was_cut_off_is_answered(run, share, ask, subject, time):
    events = [event for batch in run.batches for event in batch]
    kept = tuple(events[: round(share * len(events))])
    history = EventHistory(Recorded(run.program, run.nodes, (kept,), run.lines, {}))
    assert answer(history, Question(ask, subject, time)).sentences
