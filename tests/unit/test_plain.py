"""Which programs can reach nothing but their robot."""

import pytest

from learnblock import robots, running
from learnblock.running.plain import dead_ends, is_plain
from learnblock.runtime.program import Program
from runs import EXAMPLES

HEAD = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n"
#: Each is a way to something else, or may become one.
WAYS_OUT = [
    "import os", "import math as m", "from os import path", "from learnblock.robots import sim_ebo",
    "from learnblock.robots.sim_ebo import Robot as R", "eval('1')", "getattr(3, 'a')", "x = open",
    "x = robot", "x = [robot]", "print(robot)", "f'{robot}'", "max(1, key=robot)", "robot = 5",
    "for robot in [1]: pass", "def f(robot): pass", "lambda robot: 3", "global robot", "Robot()",
    "Robot = 3", "robot = Robot(world='line')", "(robot := 3)", "robot.clock.sleep(1)",
    "robot._wire", "robot.device", "robot.learn(3)", "robot.senses", "robot.send.__globals__",
    "robot.time.__self__", "robot.move_straight = 3", "().__class__", "print.__self__",
    "[].append.__self__", "x = __builtins__", "def __f(): pass", "x = math", "random._inst",
    "random.seed(1)", "import math\nmath = 3", "print('a', file=3)", "'{0.a}'.format(1)",
    "f'{3!r}'", "f'{3:>{4}}'", "x = [a for a in [1]]", "class A: pass", "x: int = 3", "del x",
    "try:\n    pass\nfinally:\n    pass", "with open('x') as f: pass", "@eval\ndef f(): pass",
    "async def f(): pass", "yield 3", "b'a'", "f(*[1])", "dict(**{})", "match 1:\n    case _: pass",
    "def f(x=robot): pass", "raise 3", "assert robot", "nonlocal x", "x = 3j", "x = ...",
]  # fmt: skip


def in_python(python):
    return Program("program.py", HEAD + python + "\n", python)


@pytest.mark.parametrize("python", WAYS_OUT)
def test_a_way_out_is_not_plain(python):
    assert not is_plain(in_python(python))


def test_a_program_without_any_way_out_is_plain():
    python = "import math\nx = [1]\nx.append(math.sqrt(4))\nprint(f'{x}', end='')"

    assert is_plain(in_python(python))


@pytest.mark.parametrize(
    "python", ["while True: pass", "if x:\n    while 1:\n        pass\n        pass"]
)
def test_a_loop_that_never_ends_with_nothing_in_it_hangs(python):
    assert dead_ends(in_python(python))


@pytest.mark.parametrize(
    "python",
    ["while True: break", "while False: pass", "while x: pass", "for x in y: pass", "while"],
)
def test_any_other_loop_may_have_an_end(python):
    assert not dead_ends(in_python(python))


@pytest.mark.parametrize("path", sorted(EXAMPLES.rglob("*.bt")), ids=lambda path: path.stem)
def test_an_example_is_plain_unless_it_has_raw_python_or_imports(path):
    source = running.read(path)
    text = path.read_text("utf-8")
    has_more = any(part in text for part in ("`", "python:", "import "))
    program = running.program(source, robots.find("sim-ebo"))
    assert is_plain(program) is not has_more
