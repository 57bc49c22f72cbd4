"""The check predicts what becomes of any program on any robot."""

import random
from collections.abc import Iterable

import pytest

from learnblock import language, robots, running
from learnblock.blocks import builtin
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.process import ThreadWorker
from learnblock.senses import is_decoration
from runs import TWINS, run_file

pytestmark = pytest.mark.spread

#: Values for parameters without a default, by their type.
VALUES = {"angle": "20", "float": "40", "int": "3", "string": '"CAMERA"', "apriltext": "1"}
VALUES["boolean"] = "True"
#: Skills that only work together with other robots, a function of the language, and those that end
#: the program.
LEFT_OUT = frozenset(("received", "message_value", "elapsedTime", "win_game", "game_over"))
ALL = frozenset(builtin().keys() - LEFT_OUT)
QUESTIONS = frozenset(one.name for one in builtin().values() if one.returns == "boolean") & ALL


def call(rng: random.Random, names: Iterable[str]) -> str:
    """A call of a random skill, with values where it needs some."""
    skill = builtin()[rng.choice(sorted(names))]
    given = ", ".join(VALUES[one.type] for one in skill.parameters if one.required)
    called = f"function.{skill.name}({given})"
    return f"x = {called}" if skill.returns_value else called


def pair(seed: int) -> tuple[str, str]:
    """A random program of one to four skills, and a twin."""
    rng = random.Random(seed)  # noqa: S311 - not a secret
    lines = [call(rng, ALL) for _ in range(rng.randint(1, 4))]
    body = "\n".join(f"    {line}" for line in lines)
    return f"main:\n{body}\n    function.sleep(0.1)\nend\n", rng.choice(TWINS)


@pytest.mark.parametrize("seed", range(30))
def test_a_run_has_no_effect_where_the_check_said_so_and_nowhere_else(seed, tmp_path):
    text, robot = pair(seed)
    source = running.source_of(tmp_path / "program.bt", text, is_python=False)
    entry = robots.find(robot)
    verdict = running.runs_on(source)[robot]
    options = Options(world="empty", seconds=60, anyway=True)
    job = Job(running.program(source, entry), entry, options)
    report = ProgramRun(job, worker=ThreadWorker).run()

    assert report.error is None, (text, report.error)
    foretold = {lack.skill.name for lack in (*verdict.missed, *verdict.refused)}
    assert {one["skill"] for one in report.no_effect} == foretold, text


FROM_COZMO = "from learnblock.robots.sim_cozmo import Robot\n\nrobot = Robot()\n"
DRIVES_ON = "    robot.move_straight(50)\n"
#: What only the run can tell, and what it says of a robot that lacks it.
UNKNOWN = {
    'side = "front"\nwhile robot.senses.distance(side) > 300:\n': (
        "This robot has no distance sensor or bumper at the front, which this part of the program "
        "needs."
    ),
    'ask = "is_front" + "_obstacle"\nwhile not getattr(robot, ask)():\n': (
        "This robot has no distance sensor or bumper at the front: it can't do 'is_front_obstacle'."
    ),
    'key = "ARMS"\nrobot.setAngleMotor(key, 20)\nwhile True:\n': (
        "This robot has no motor 'ARMS': 'setAngleMotor' does nothing. "
        "Use one of these: CAMERA, ARM."
    ),
    'axis = "X_AXIS"\nrobot.reset_orientation(axis)\nwhile True:\n': (
        "This robot has no gyroscope 'X_AXIS': 'reset_orientation' does nothing. "
        "Use one of these: Z_AXIS."
    ),
}


@pytest.mark.parametrize("text", UNKNOWN)
def test_a_run_ends_where_it_asks_for_what_the_robot_lacks(text, tmp_path):
    path = tmp_path / "program.py"
    path.write_text(FROM_COZMO + text + DRIVES_ON)
    found = running.check(running.read(path), robots.find("sim-cozmo"))
    assert "missing-device" not in {one.code for one in found}

    report = run_file(path, "sim-cozmo", worker=ThreadWorker, world="empty", seconds=5).report
    assert report.error is not None
    assert str(report.error["message"]) == UNKNOWN[text]
    assert report.distance == 0


@pytest.mark.parametrize("text", UNKNOWN)
def test_a_run_goes_on_anyway_if_a_person_wants_it_to(text, tmp_path):
    path = tmp_path / "program.py"
    path.write_text(FROM_COZMO + text.replace(" > 300", " is None") + DRIVES_ON)
    options = {"world": "empty", "seconds": 1, "anyway": True}
    report = run_file(path, "sim-cozmo", worker=ThreadWorker, **options).report
    assert report.ended == "time limit"
    assert report.distance > 0


def test_a_lamp_in_a_variable_that_the_robot_lacks_is_only_reported(tmp_path):
    path = tmp_path / "program.py"
    path.write_text(FROM_COZMO + 'slot = "Middle"\nrobot.led(1, slot)\n')
    report = run_file(path, "sim-cozmo", worker=ThreadWorker, world="empty").report
    assert report.error is None
    assert [one["skill"] for one in report.no_effect] == ["led"]


def question(rng: random.Random, names: frozenset[str]) -> str:
    return call(rng, names & QUESTIONS).removeprefix("x = ")


def statements(rng: random.Random, names: frozenset[str], depth: int) -> list[str]:
    """Some calls of skills, in loops and branches on what the robot senses."""
    lines: list[str] = []
    for _ in range(rng.randint(1, 2)):
        head = rng.choice(
            [
                "",
                "repeat 2:",
                "for i from 1 to 2:",
                f"if {question(rng, names)}:",
                f"if not {question(rng, names)}:",
                f"while {question(rng, names)}:",
                f"while {question(rng, names)} or False:",
                f"while not {question(rng, names)}:",
            ]
        )
        if not head or depth == 0:
            lines.append(call(rng, names))
            continue
        inner = [*statements(rng, names, depth - 1), "function.sleep(0.1)"]
        lines += [head, *(f"    {line}" for line in inner), "end"]
    return lines


def may_run(name: str, have: frozenset[str]) -> bool:
    """Whether a call of a skill leaves a program running, perhaps without decoration."""
    skill = builtin()[name]
    return all(is_decoration(one) for one in skill.lacks(have)) and not (
        skill.returns_value and skill.lacks(have)
    )


def looping(seed: int) -> tuple[str, str]:
    """A random program with loops, a function and an event, and a twin."""
    rng = random.Random(seed)  # noqa: S311 - as above
    robot = rng.choice(TWINS)
    have = robots.find(robot).load().known_equipment()
    # Most programs of skills of all robots are refused.
    names = ALL if seed % 4 == 0 else frozenset(one for one in ALL if may_run(one, have))
    parts = {
        "def helper():": statements(rng, names, 1),
        f"when seen = {question(rng, names)}:": [call(rng, names)],
    }
    body = [*statements(rng, names, 2), *rng.choice([(), ("helper()",)]), "function.sleep(0.3)"]
    kept = [item for item in parts.items() if rng.random() < 0.5 or "helper()" in body]
    texts = [
        "\n".join([head, *(f"    {line}" for line in lines), "end\n\n"])
        for head, lines in [*kept, ("main:", body)]
    ]
    return "".join(texts).rstrip() + "\n", robot


def notated(text: str, notation: str, robot: str) -> str:
    """A program as its author wrote it: in Block-Text, in Python, or all of it without blocks."""
    if notation == "Block-Text":
        return text
    python = language.to_python(language.parse(text), robots.module_of(robot)).text
    if notation == "Python":
        return python
    return python.replace("robot = Robot()", "bot = Robot()").replace("robot.", "bot.")


NOTATIONS = ("Block-Text", "Python", "Python without blocks")


@pytest.mark.parametrize("seed", range(30))
def test_a_program_with_loops_runs_or_is_refused_and_never_loops_blindly(seed, tmp_path):
    text, robot = looping(seed)
    notation = NOTATIONS[seed % 3]
    path = tmp_path / ("program.bt" if notation == "Block-Text" else "program.py")
    path.write_text(notated(text, notation, robot))
    source = running.read(path)
    verdict = running.runs_on(source)[robot]
    errors = [one for one in running.check(source, robots.find(robot)) if one.severity == "error"]
    assert {one.code for one in errors} == (set() if verdict.runs else {"missing-device"}), text
    if verdict.runs:
        report = run_file(path, robot, worker=ThreadWorker, world="empty", seconds=5).report
        assert report.error is None, (text, report.error)
        announced = {lack.skill.name for lack in verdict.missed}
        assert {one["skill"] for one in report.no_effect} <= announced, text
