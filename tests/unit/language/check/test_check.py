import pytest

from learnblock import robots
from learnblock.blocks import builtin
from learnblock.blocks.schema.configuration import BlockConfiguration, Configurations, Parameter
from learnblock.fields import Range
from learnblock.i18n import Phrase
from learnblock.language import check, from_python, parse
from learnblock.senses import equipment
from places import TESTS

CASES = TESTS / "cases"
EBO = equipment(
    ("Base:ROBOT", "Camera:ROBOT", "Display:ROBOT", "JointMotor:CAMERA", "Gyroscope:Z_AXIS"), None
)


@pytest.fixture
def found(skills):
    """The line, severity and code of each diagnostic of a program."""

    def of(text, equipment=None):
        diagnostics = check(parse(text), skills, equipment)
        return [(one.line, one.severity, one.code) for one in diagnostics]

    return of


@pytest.mark.parametrize("case", ["square_trajectory", "reaction_to_tags", "line_follower_ebo"])
def test_the_programs_of_the_paper_have_no_problems_on_ebo(case, found):
    assert [] == found((CASES / case / "program.bt").read_text("utf-8"), EBO)


def test_a_device_that_only_an_effect_needs_is_a_warning(found, thymio):
    text = (CASES / "line_follower_thymio" / "program.bt").read_text("utf-8")
    assert [(2, "warning", "missing-device")] == found(text, thymio)


def test_a_question_that_can_never_be_answered_is_an_error(found, thymio):
    text = (CASES / "line_follower_ebo" / "program.bt").read_text("utf-8")
    severities = [(line, severity) for line, severity, _ in found(text, thymio)]
    assert [(2, "warning"), (4, "error"), (7, "error"), (10, "error")] == severities


def on(robot, text):
    """Return the severity and message of each diagnostic of a program with the real skills."""
    devices = robots.find(robot).load().known_equipment()
    return [(one.severity, str(one.message)) for one in check(parse(text), builtin(), devices)]


@pytest.mark.parametrize("robot", ["sim-cozmo", "sim-thymio"])
def test_a_skill_uses_the_first_led_of_any_robot(robot):
    assert [] == on(robot, "function.RGBled(255, 0, 0)")


@pytest.mark.parametrize(
    ("call", "severity", "message"),
    [
        (
            'RGBled(255, 0, 0, "Up")',
            "warning",
            "This robot has no coloured LED 'Up': 'function.RGBled' does nothing. Use one of "
            "these: Center, Front, Left, Rear, Right.",
        ),
        (
            'RGBled(255, 0, 0, slot="up")',
            "warning",
            "This robot has no coloured LED 'up': 'function.RGBled' does nothing. Use one of "
            "these: Center, Front, Left, Rear, Right.",
        ),
        (
            'setAngleMotor("HEAD", 10)',
            "error",
            "This robot has no motor 'HEAD': 'function.setAngleMotor' does nothing. Use one of "
            "these: ARM, CAMERA.",
        ),
    ],
)
def test_a_device_whose_name_the_robot_lacks_is_reported_with_those_it_has(call, severity, message):
    assert [(severity, message)] == on("sim-cozmo", f"function.{call}")


def test_a_name_that_only_the_run_will_tell_is_not_reported():
    text = 'main:\n    side = "Left"\n    function.RGBled(255, 0, 0, side)\nend'
    assert [] == on("sim-cozmo", text)


def test_a_robot_that_cannot_move_is_an_error(found):
    assert [(1, "error", "missing-device")] == found("function.stop_bot()", frozenset())


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("120", Phrase("check-outside-range", parameter="speed", value="120", least=0, most=100)),
        ("-1", Phrase("check-outside-range", parameter="speed", value="-1", least=0, most=100)),
        (
            '5, "wide"',
            Phrase(
                "check-unknown-choice",
                parameter="brush",
                value="'wide'",
                choices=("'thin'", "'thick'"),
            ),
        ),
        (
            '5, "thin", "red"',
            Phrase("check-not-a-colour", parameter="colour", value="'red'"),
        ),
    ],
)
def test_a_constant_that_a_field_does_not_offer_is_a_warning(arguments, message):
    parameters = (
        Parameter("speed", "float", range=Range(0, 100)),
        Parameter("brush", "choice", "thin", choices=("thin", "thick")),
        Parameter("colour", "colour", "#000000"),
    )
    paint = BlockConfiguration("others", "Paint", "paint", parameters)
    (problem,) = check(parse(f"function.paint({arguments})\n"), {"paint": paint})

    assert ("unusual-value", "warning") == (problem.code, problem.severity)
    assert problem.message == Phrase(message.code, call="function.paint", **message.values)


def test_a_value_that_a_field_offers_has_no_problem():
    parameters = (Parameter("speed", "float", range=Range(0, 100)), Parameter("way", "angle", 0))
    paint = BlockConfiguration("others", "Paint", "paint", parameters)

    assert [] == check(
        parse("x = 1\nfunction.paint(100, 720)\nfunction.paint(x)\n"), {"paint": paint}
    )


def test_a_skill_of_a_file_with_an_error_is_reported_with_that_error():
    reason = "dance.py, line 3: This is not valid Python."
    skills = Configurations({}, {"waltz": reason}, ())
    (problem,) = check(parse("function.waltz()\n"), skills)

    assert "unknown-skill" == problem.code
    assert problem.message == Phrase("check-skill-with-error", name="waltz", reason=reason)


def test_without_a_robot_no_device_is_missing(found):
    assert [] == found("function.look_floor()")


@pytest.mark.parametrize(
    ("text", "code", "message"),
    [
        (
            "total = 1\nprint(totl)\n",
            "unknown-name",
            Phrase("check-unknown-name-near", name="totl", near="total"),
        ),
        (
            "x = true\n",
            "unknown-name",
            Phrase("blocktext-write-instead", found="true", instead="True"),
        ),
        (
            "function.trun(90)\n",
            "unknown-skill",
            Phrase("check-unknown-skill-near", name="trun", near="turn"),
        ),
        (
            "function.mover_recto()\n",
            "unknown-skill",
            Phrase("check-unknown-skill-near", name="mover_recto", near="move_straight"),
        ),
        (
            "parar()\n",
            "unknown-function",
            Phrase("check-unknown-function-near", name="parar", near="function.stop_bot"),
        ),
        (
            "def go(): pass end\ngoo()\n",
            "unknown-function",
            Phrase("check-unknown-function-near", name="goo", near="go"),
        ),
        (
            "stop_bot()\n",
            "unknown-function",
            Phrase("check-skill-as-name", name="stop_bot", skill="function.stop_bot"),
        ),
        (
            "function.turn()\n",
            "missing-argument",
            Phrase("check-missing-argument", call="function.turn", count=1, names=("angle",)),
        ),
        (
            "function.turn(1, 2)\n",
            "argument-count",
            Phrase(
                "check-too-many-arguments",
                call="function.turn",
                most=1,
                parameters=("angle",),
                given=2,
                instead="function.turn(1)",
            ),
        ),
        (
            "function.move_straight(speed=9)\n",
            "unknown-argument",
            Phrase(
                "check-unknown-argument-near",
                call="function.move_straight",
                name="speed",
                near="advSpeed",
            ),
        ),
        (
            'function.turn("90")\n',
            "wrong-type",
            Phrase("check-number-in-quotes", call="function.turn", parameter="angle", number="90"),
        ),
        (
            "x = sqrt(1, 2)\n",
            "argument-count",
            Phrase("check-argument-count", call="sqrt", count=1, given=2),
        ),
        (
            "when follow: activate folow end\n",
            "unknown-when",
            Phrase("check-unknown-when-near", name="folow", near="follow"),
        ),
        (
            "when follow = True: print(state_folow) end\n",
            "unknown-when",
            Phrase("check-unknown-when-near", name="folow", near="follow"),
        ),
        ("print(x)\nx = 1\n", "unset-variable", Phrase("check-read-before-set", name="x")),
        (
            "while True: y = 1 end\nx = 1\n",
            "unreachable",
            Phrase("check-unreachable-after-loop", line="1"),
        ),
        (
            "repeat 3:\n    break\n    x = 1\nend\n",
            "unreachable",
            Phrase("check-unreachable-after-jump", word="break", line="2"),
        ),
        (
            "if function.is_tag(1): x = 1 end\n",
            "sensor-outside-loop",
            Phrase("check-sensor-outside-loop", skill="function.is_tag"),
        ),
    ],
)
def test_each_mistake_has_its_code_and_message(text, code, message, skills):
    (diagnostic,) = check(parse(text), skills)
    assert (code, message) == (diagnostic.code, diagnostic.message)


def test_python_sets_the_name_of_a_file(skills):
    skeleton = "from learnblock.robots.ebo import Robot\n\nrobot = Robot()\n\n"
    program = from_python(skeleton + "if __name__ == '__main__':\n    robot.turn(90)\n")
    assert [] == check(program, skills)


def test_diagnostics_are_in_source_order(found):
    text = "x = y\nwhile True:\n    function.foo(z)\n    activate a\nend\nfoo()\n"
    lines = [line for line, _, _ in found(text)]
    assert sorted(lines) == lines
    assert {1, 3, 4, 6} == set(lines)


@pytest.mark.parametrize(
    "text",
    [
        "def f(a): return a + b end\nb = 1\nprint(f(2))\n",
        "when start: activate run end\ntotal = 0\nwhen run: total += 1 end\n",
        "for i from 1 to 3: print(i) end\n",
        "for x in [1]: print(x) end\n",
        "python:\n    import os\n    n, m = 1, 2\n    def g(): pass\nend\nprint(n, m)\ng()\n",
        'import "dance"\nwaltz(tempo)\n',
        "while True:\n    if function.is_any_tag(): break end\nend\nfunction.stop_bot()\n",
        "def f(): return 1 end\nprint(f())\n",
        "x = `[i for i in range(3)]`\nprint(x)\n",
        "when seen = function.is_any_tag(): print(state_seen, time_seen) end\n",
        "state_of_mind = 1\nprint(state_of_mind)\n",
        "def f(state_x): return state_x end\nprint(f(1))\n",
        "x = 1\nif x == 1: x = 2 end\n",
        'robot(world="line")\nx = 1\n',
    ],
)
def test_a_correct_program_has_no_problems(text, found):
    assert [] == found(text)


def test_a_variable_must_be_set_before_it_is_read(found):
    assert [(1, "error", "unset-variable")] == found("x += 1\nx = 1\n")
    assert [(1, "error", "unset-variable")] == found("print(x)\nmain:\n    x = 1\nend\n")


def test_a_main_after_an_endless_loop_is_never_reached(found):
    text = "while True: y = 1 end\nmain:\n    pass\nend\n"
    assert [(3, "warning", "unreachable")] == found(text)


def test_a_program_may_be_too_deep_for_python_alone(found):
    ifs = "x = 1\n" + "if x:\n" * 100 + "x = 2\n" + "end\n" * 100
    assert ["too-deep"] == [code for _, _, code in found(ifs)]
    loops = "repeat 1:\n" * 21 + "pass\n" + "end\n" * 21
    assert ["too-deep"] == [code for _, _, code in found(loops)]


def test_raw_python_must_be_valid(found):
    assert [(3, "error", "invalid-python")] == found("x = 1\npython:\n    y = = 1\nend\n")
    assert [(2, "error", "invalid-python")] == found("python:\n    y = = 1\nend\n")


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("def show():\n    print(x)\nend\nshow()\nx = 1\n", 2),
        ("def show():\n    print(i)\nend\nfor i from 1 to 2:\n    pass\nend\nshow()\n", None),
        (
            "def count():\n    for i from 1 to 2:\n        pass\n    end\nend\ncount()\nprint(i)\n",
            7,
        ),
        ("when a = x > 1:\n    print(1)\nend\nwhen b = True:\n    x = 1\nend\n", 1),
        ("when a = x > 1:\n    print(1)\nend\nwhen start:\n    x = 1\nend\n", None),
        ("when a = True:\n    print(x)\nend\nwhen b = True:\n    x = 1\nend\n", None),
        ("def set_x():\n    x = 1\nend\nset_x()\nprint(x)\n", None),
        ("def set_x():\n    x = 1\nend\nprint(x)\nset_x()\n", 4),
        (
            "state = 0\ndef show():\n    print(x)\nend\nforever:\n    if state == 1:\n"
            "        show()\n    end\n    x = 2\n    state = 1\nend\n",
            None,
        ),
    ],
)
def test_a_variable_is_followed_into_functions_and_events(text, line, found):
    unset = [where for where, _, code in found(text) if code == "unset-variable"]
    assert unset == ([] if line is None else [line])


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("def show(time_go):\n    print(time_go)\nend\n", "time_go"),
        ("def show(state_go):\n    x = state_go\nend\n", "state_go"),
        ("time_go = 0\n", "time_go"),
        ("state_go = False\n", "state_go"),
        ("time_go += 1\n", "time_go"),
        ("for time_go in [1]:\n    print(1)\nend\n", "time_go"),
        ("for state_go from 1 to 2:\n    print(1)\nend\n", "state_go"),
    ],
)
def test_the_names_of_an_events_values_are_its_own(text, name):
    diagnostics = check(parse(f"{text}when go = True:\n    print(1)\nend\n"), builtin())
    assert [(1, "value-of-event", name)] == [
        (one.line, one.code, one.message.values["name"]) for one in diagnostics
    ]
    assert [] == check(parse(text.replace("_go", "_gone")), builtin()) or "+=" in text


def test_an_author_of_python_learns_how_to_restart_the_time_of_an_event():
    python = (
        "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n\n\n"
        "@robot.when(lambda: True)\ndef go():\n    go.time = 0\n\n\nrobot.run()\n"
    )
    [found] = check(from_python(python), builtin(), python=python)
    assert (8, "error") == (found.line, found.severity)
    assert "'go.deactivate()' and 'go.activate()'" in str(found.message)


@pytest.mark.parametrize("text", ["07", " 7 ", "-07", "+7", "1_000", "٣"])
def test_int_may_read_whatever_python_reads(text):
    assert [] == check(parse(f'x = int("{text}")\nprint(x)\n'), builtin())


@pytest.mark.parametrize("text", ["seven", "3.5", "0x10", "", "1__0"])
def test_int_of_other_text_is_a_mistake(text):
    codes = [one.code for one in check(parse(f'x = int("{text}")\nprint(x)\n'), builtin())]
    assert ["wrong-type"] == codes


@pytest.mark.parametrize("event", ["start", "go = True"])
def test_a_return_leaves_an_event(event):
    text = f"when {event}:\n    if 1 > 0:\n        return\n    end\n    print(1)\nend\n"
    assert [] == check(parse(text), builtin())


@pytest.mark.parametrize("word", ["activate", "deactivate"])
def test_a_change_of_an_event_with_a_condition_has_no_lasting_effect(word, found):
    text = f"when go = True:\n    print(1)\n    {word} go\nend\n"
    assert [(3, "warning", "follows-condition")] == found(text)


def test_an_event_with_a_condition_may_start_its_time_again(found):
    assert [] == found("when go = True:\n    print(1)\n    deactivate go\n    activate go\nend\n")


@pytest.mark.parametrize(
    ("body", "codes"),
    [
        ("    print(x)\n    local x = 2\n", ["unset-variable"]),
        ("    local x = 2\n    print(x)\n", []),
        ("    `x, y = 1, 2`\n    print(x)\n    local x = 2\n", []),
    ],
)
def test_a_local_variable_is_unset_until_its_function_sets_it(body, codes):
    program = parse(f"x = 1\n\ndef f():\n{body}end\n\nmain:\n    f()\n    print(x)\nend\n")
    assert codes == [found.code for found in check(program, {}) if found.code == "unset-variable"]
