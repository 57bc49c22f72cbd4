"""Events of Python programs: what converts is accepted, and stays what it was."""

import pytest

from learnblock.blocks import builtin
from learnblock.language import check, from_python, from_workspace, parse, to_python, to_workspace
from learnblock.language import format as format_program

HEAD = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n\n\n"
RUN = "\n\nrobot.run()\n"
BODY = "    print(1)\n"
EVENTS = {
    "two starts": f"@robot.when_start\ndef a():\n{BODY}\n\n@robot.when_start\ndef b():\n{BODY}",
    "two of one name": "\n\n".join([f"@robot.when_start\ndef a():\n{BODY}"] * 2),
    "a start with its own name": f"@robot.when_start\ndef begin():\n{BODY}",
    "an event called start": f"@robot.when\ndef start():\n{BODY}\n\nstart.activate()\n",
    "a named condition": f"def near():\n    return True\n\n\n@robot.when(near)\ndef go():\n{BODY}",
    "a local variable that another function has too": (
        "def f():\n    n = 1\n    print(n)\n\n\n"
        "@robot.when(lambda: True)\ndef go():\n    n = 2\n    print(n)\n    f()\n"
    ),
    "one that only Python has, and one that blocks have": (
        f"@robot.when_start\ndef begin():\n{BODY}\n\n@robot.when(lambda: True)\ndef go():\n{BODY}"
    ),
    "a return": "@robot.when(lambda: True)\ndef go():\n    if 2:\n        return\n    print(1)\n",
    "a return of a value": "@robot.when_start\ndef start():\n    return 1\n",
    "a parameter like the time of an event": (
        "def show(time_go):\n    print(time_go)\n\n\n"
        "@robot.when(lambda: True)\ndef go():\n    show(3)\n"
    ),
    "a parameter like the time of an event that is not used": (
        f"def show(time_go):\n{BODY}\n\n@robot.when(lambda: True)\ndef go():\n    show(3)\n"
    ),
    "a variable like the state of an event": (
        f"@robot.when(lambda: True)\ndef go():\n{BODY}\n\nstate_go = 1\nprint(state_go)\n"
    ),
}


@pytest.mark.parametrize("events", EVENTS.values(), ids=EVENTS)
def test_an_event_of_python_is_accepted_in_every_notation(events):
    python = HEAD + events + RUN
    program = from_python(python)
    blocktext = parse(format_program(program))
    blocks = from_workspace(to_workspace(program, builtin()).workspace, builtin())
    errors = [
        *check(program, builtin(), python=python),
        *check(blocktext, builtin()),
        *(problem for _, problem in blocks.problems),
    ]
    assert [] == [str(one.message) for one in errors if one.severity == "error"]
    assert blocktext == program == blocks.program
    assert 1 == to_python(blocktext).text.count("robot.run()")


def test_a_run_that_is_not_at_the_end_stays_python():
    python = f"{HEAD}@robot.when\ndef go():\n{BODY}\n\nrobot.run()\nprint(2)\n"
    assert "`robot.run()`\n" in format_program(from_python(python))
