"""Functions extracted from a program and written as skills."""

import pytest

from learnblock.errors import LibraryError, UnknownNameError
from learnblock.language import parse
from learnblock.language.edit.extraction import extracted, with_needed
from learnblock.language.python.generation import to_skills

PROGRAM = """# About the program.

# How many steps were made.
steps = 0
unused = 1

# Dance a waltz.
def waltz(times, speed):
    repeat times:
        step(speed)
    end
    return steps
end

def step(speed):
    steps += 1
    function.move_straight(speed)
    print(sqrt(steps))
end

def rest():
    function.stop_bot()
end

main:
    waltz(3, speed=20)
end
"""
EXTRACTED = """# How many steps were made.
steps = 0

# Dance a waltz.
def waltz(times, speed):
    repeat times:
        step(speed)
    end
    return steps
end

def step(speed):
    steps += 1
    function.move_straight(speed)
    print(sqrt(steps))
end
"""
SKILLS = '''"""Made from functions.bt: change that, and not this file."""

import math

# How many steps were made.
steps = 0


# Dance a waltz.
def waltz(robot, times, speed):
    for _ in range(times):
        step(robot, speed)
    return steps


def step(robot, speed):
    global steps
    steps += 1
    robot.move_straight(speed)
    print(math.sqrt(steps))
'''


def test_a_function_comes_with_those_it_calls_and_the_variables_they_share():
    assert extracted(parse(PROGRAM), ["waltz"], "program.bt") == EXTRACTED


def test_the_needed_functions_are_in_the_order_of_the_program():
    assert with_needed(parse(PROGRAM), ["rest", "waltz"]) == ("waltz", "step", "rest")


def test_skills_take_the_robot_first_and_pass_it_along():
    assert to_skills(parse(EXTRACTED), "functions.bt") == SKILLS


@pytest.mark.parametrize(
    ("text", "python"),
    [
        ("def f(): g() end\ndef g(): return 1 end", "    g(robot)\n"),
        ("def f(robot): return f(robot + 1) end", "return f(robot, robot_ + 1)"),
        ("def f(x): return f(x=f(1)) end", "return f(robot, x=f(robot, 1))"),
        ("def f(): return elapsedTime(3) end", "return robot.elapsedTime(3)"),
        ("def f(): return `robot.time()` end", "return robot.time()"),
    ],
)  # fmt: skip
def test_each_call_passes_the_robot_along(text, python):
    assert python in to_skills(parse(text), "functions.bt")


def problems(text):
    with pytest.raises(LibraryError) as caught:
        extracted(parse(text), ["f"], "program.bt")
    return [(one.line, one.code) for one in caught.value.diagnostics]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("when found: pass end\ndef f(): activate found end", [(2, "event-in-library")]),
        ("when found: pass end\ndef f(): return time_found end", [(2, "event-in-library")]),
        ("def f(): greet() end", [(1, "unknown-function")]),
        ("def f(): return `g(1)` end\ndef g(x): return x end", [(1, "python-in-library")]),
        ("def f(): return g end\ndef g(x): return x end", [(1, "python-in-library")]),
        ("python:\n    import os\nend\ndef f(): return `os.sep` end", [(4, "python-in-library")]),
        ("speed = 1\ndef f(): return speed end\nmain: speed = 2 end", [(2, "shared-variable")]),
        ("def f(): return speed end\nmain: speed = 2 end", [(1, "shared-variable")]),
        ("speed = function.get_light()\ndef f(): return speed end", [(1, "shared-variable")]),
        ("speed = f()\ndef f(): return speed end", [(1, "shared-variable")]),
    ],
)
def test_functions_that_need_the_rest_of_the_program_are_refused_with_the_line(text, expected):
    assert problems(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "def f(): count = 1 end",
        "a = [1]\nb = a\ndef f(): return b end",
        "def f(): for i from 1 to 3: print(i) end end\nmain: i = 2 end",
        "def f(x): return x end\nx = 2\nx = 3",
        "def f(): return `[n for n in range(3)]` end",
    ],
)
def test_a_function_keeps_its_local_names(text):
    assert "def f(" in extracted(parse(text), ["f"], "program.bt")


def test_a_missing_function_is_named():
    with pytest.raises(UnknownNameError, match=r"There is no function 'waltzz'. Did you mean"):
        extracted(parse(PROGRAM), ["waltzz"], "program.bt")
