"""The check of a custom block before it is saved; none of its code is run."""

import json
import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.blocks import load_configurations
from learnblock.extensions.custom_blocks import check, save
from learnblock.extensions.custom_blocks.custom_block import Checked
from learnblock.i18n import Phrase
from phrases import codes

PLAIN = "def waltz(robot, times: int = 3) -> None:\n    'Dance.'\n"


def assert_about(message, expected):
    """Assert that a message has a code; Python's messages must contain some words."""
    if isinstance(message, Phrase) and re.fullmatch(r"[a-z]+(-[a-z]+)+", expected):
        assert expected in codes(message)
    else:
        assert expected in str(message)


def told(checked: Checked):
    return [(one.diagnostic.code, one.diagnostic.line, one.part) for one in checked.problems]


def chosen(**more) -> str:
    return json.dumps(
        {"type": "motor", "category": "Dance", "name": "waltz", "shape": ["blockVertical"], **more}
    )


def test_a_function_that_takes_the_robot_is_valid():
    checked = check(PLAIN, name="ball_room")

    assert () == checked.problems
    (block,) = checked.blocks
    assert ("waltz", "Ball room") == (block.name, block.category)


def test_without_a_name_the_tab_is_named_after_the_first_function():
    assert "Waltz" == check(PLAIN).blocks[0].category


def test_several_functions_and_helpers_are_valid():
    source = PLAIN + "def _half(x): return x / 2\ndef tango(robot): _half(3)\n"

    assert () == check(source).problems
    assert ["waltz", "tango"] == [block.name for block in check(source).blocks]


@pytest.mark.parametrize(
    ("source", "code", "line", "message"),
    [
        ("x = 1\ndef f(robot:\n", "syntax-error", 2, "'(' was never closed"),
        ("def f(robot, a, a): ...\n", "syntax-error", 1, "custom-not-python"),
        ("def f(robot): ...\nreturn 3\n", "syntax-error", 2, "custom-not-python"),
        ("x = '\0'\n", "syntax-error", 0, "null bytes"),
        ("", "no-function", 0, "custom-no-function"),
        ("def _f(robot): ...\n", "no-function", 0, "custom-no-function"),
        ("async def f(robot): ...\n", "async-function", 1, "custom-async"),
        (2 * "def f(robot): ...\n", "duplicate-name", 2, "custom-duplicate-function"),
        ("def square(side): ...\n", "no-robot", 1, "custom-first-parameter"),
        ("x = 1\ndef turn(robot): ...\n", "name-taken", 2, "custom-taken-by-skill"),
        ("def f(robot,\n  class_=3): ...\n", "bad-name", 2, "custom-python-word"),
        ("def from_(robot): ...\n", "bad-name", 1, "custom-python-word"),
        ("def stop(robot): ...\n", "name-taken", 1, "custom-taken-by-robot"),
        ("def f(robot, *, key): ...\n", "unfit-parameter", 1, "custom-unfit-parameter"),
        ("def f(robot,\n      x: Decimal = 3): ...\n", "bad-hint", 2, "block-unknown-hint"),
        ("def f(robot, x: int = 'a'): ...\n", "bad-default", 1, "block-expects-number"),
        ("def f(robot, x: str = 3): ...\n", "bad-default", 1, "block-expects-text"),
        ("def f(robot, x: bool = 3): ...\n", "bad-default", 1, "block-expects-truth"),
        ("def f(robot, x: list = 3): ...\n", "bad-default", 1, "block-expects-list"),
        ("def f(robot, x: TagName = 1.5): ...\n", "bad-default", 1, "block-expects-tag"),
        ("def f(robot, x: Colour = 'red'): ...\n", "bad-default", 1, "block-expects-colour"),
        ("def f(robot, x: Literal['a'] = 'b'): ...\n", "bad-default", 1, "block-expects-choice"),
        (
            "def f(robot, x: Annotated[float, Range(0, 9)] = 10): ...\n",
            "bad-default",
            1,
            "block-expects-range",
        ),
        ("import nothing\ndef f(robot): ...\n", "unknown-import", 1, "custom-import-package"),
        ("\nfrom . import x\ndef f(robot): ...\n", "unknown-import", 2, "custom-import-relative"),
        (
            "def f(robot):\n    from learnblock.devices import Bse\n",
            "unknown-import",
            2,
            "custom-import-name-like",
        ),
        (
            "from learnblock.device import Base\ndef f(robot): ...\n",
            "unknown-import",
            1,
            "custom-import-module-like",
        ),
        (
            "import learnblock.libraries.dance\ndef f(robot): ...\n",
            "unknown-import",
            1,
            "custom-import-library",
        ),
    ],
)  # fmt: skip
def test_a_mistake_in_the_source_is_an_error(source, code, line, message):
    checked = check(source)

    assert [(code, line)] == [(one.diagnostic.code, one.diagnostic.line) for one in checked.errors]
    assert_about(checked.errors[0].diagnostic.message, message)


@pytest.mark.parametrize(
    "source",
    [
        "from learnblock.devices import Base, DistanceSensors\n",
        "from learnblock.fields import Range, Colour\nfrom typing import Annotated\n",
        "from learnblock.skills.base import turn\nimport learnblock.skills\n",
        "from __future__ import annotations\nfrom learnblock import skills\nimport json.decoder\n",
        "try:\n    import no_such_package\nexcept ImportError:\n    no_such_package = None\n",
    ],
)
def test_an_import_that_works_is_valid(source):
    assert () == check(source + PLAIN).problems


NAMES = {
    "robot.move_straigt(50)": (
        3,
        "There is no skill 'move_straigt'. Did you mean 'move_straight'?",
    ),
    "x = robot.wlatz(2)": (3, "Did you mean 'waltz'?"),
    "time.sleep(1)": (3, "The module 'time' is not imported. Write 'import time' at the top."),
    "robot.device(Base)": (3, "Write 'from learnblock.devices import Base' at the top."),
    "[Literal for _ in [1]]": (3, "Write 'from typing import Literal' at the top."),
    "if times:\n        prnt(times)": (4, "There is no function 'prnt'. Did you mean 'print'?"),
    "print(tmes)": (3, "'tmes' has no value."),
    "x = 3\n    print(lambda: y)": (4, "'y' has no value."),
    "class A:\n        b = 1\n        def c(self): return b": (5, "'b' has no value."),
    "try: dance()\n    except ValueError: pass": (3, "There is no function 'dance'."),
}


@pytest.mark.parametrize("line", NAMES)
def test_a_name_that_nothing_sets_is_an_error(line):
    checked = check(PLAIN + f"    {line}\n")
    expected, words = NAMES[line]
    [error] = checked.errors
    assert error.diagnostic.line == expected
    assert words in str(error.diagnostic.message)


@pytest.mark.parametrize(
    "line",
    [
        "print(__name__, __file__, [n for n in range(times)], times := 3, times)",
        "global steps\n    steps = 1\ndef tango(robot): print(steps, LATER)\nLATER = 3",
        "class A:\n        b = 1\n        c = b\n        def d(self): return __class__, A",
        "try: fast\n    except NameError: fast = 1",
        "exec('fast = 1')\n    print(fast)",
        "from math import *\nprint(sqrt(4))",
        "import os.path as p, math\n    def f(*a, **b): return p, math, a, b\n    f()",
        "match times:\n        case [a, *b]: print(a, b)\n        case {'c': c, **d}: print(c, d)",
        "robot.tango(robot.clock.time())\ndef tango(robot, n): robot.count = robot.count + n",
        "with open('x') as f: print(f)\n    except_ = f\n    del except_",
    ],
)
def test_a_name_that_something_sets_is_valid(line):
    checked = check(
        (PLAIN + f"    {line}\n").replace("    from math import *", "from math import *")
    )
    assert () == checked.problems


@pytest.mark.parametrize("skill", ["qqq", "waltz2", "turn_twice"])
def test_a_skill_that_another_block_or_robot_may_have_is_a_warning(skill):
    [problem] = check(PLAIN + f"    robot.{skill}()\n").problems
    assert ("unknown-skill", "warning") == (problem.diagnostic.code, problem.diagnostic.severity)


def test_the_skills_of_other_blocks_are_known():
    save("dance", PLAIN)
    assert () == check("def two(robot):\n    robot.waltz(2)\n").problems


def test_a_function_without_a_robot_among_others_is_only_a_warning():
    checked = check(PLAIN + "def helper(): ...\n")

    assert [("no-robot", 3, "source")] == told(checked)
    assert () == checked.errors


def test_two_blocks_cannot_share_a_name():
    save("dance", PLAIN)

    assert [("name-taken", 1, "source")] == told(check(PLAIN, name="other"))
    assert () == check(PLAIN, name="other", replaces="dance").problems


@pytest.mark.parametrize("name", ["../evil", "a/b", "a.b", "-a", "con", "x" * 61, "a\n"])
def test_a_name_that_files_cannot_have_is_an_error(name):
    assert [("wrong-name", 0, "name")] == told(check(PLAIN, name=name))


# Configurations.


def test_the_configuration_is_joined_with_the_source():
    checked = check(PLAIN, chosen(languages={"ES": "bailar"}))
    (block,) = load_configurations(checked.complete)

    assert ("motor", "Dance") == (block.type, block.category)
    assert {"EN": "waltz", "ES": "bailar"} == block.languages
    assert {"EN": "Dance."} == block.tooltip


def test_a_saved_configuration_does_not_contain_the_docstring():
    saved = check(PLAIN, check(PLAIN, chosen(languages={"ES": "bailar"})).complete).chosen
    (block,) = check(PLAIN.replace("Dance.", "Hop."), saved).blocks

    assert {"EN": "Hop."} == block.tooltip
    assert {"EN": "waltz", "ES": "bailar"} == block.languages


def test_a_renamed_function_keeps_its_configuration():
    checked = check(PLAIN.replace("waltz", "hop"), chosen(languages={"EN": "waltz", "ES": "baile"}))

    assert () == checked.problems
    assert {"EN": "hop", "ES": "baile"} == checked.blocks[0].languages
    assert "Dance" == checked.blocks[0].category


@pytest.mark.parametrize(
    ("configuration", "code", "message"),
    [
        ("{", "not-json", ""),
        (chosen(type="motors"), "unknown-value", "block-unknown-value-like"),
        (f"[{chosen()}, {chosen(name='gone')}]", "stale-configuration", "custom-stale-function"),
        (
            chosen(variables=[{"type": "int", "name": "gone", "default": 3}]),
            "stale-configuration",
            "custom-stale-parameter",
        ),
        (
            chosen(variables=[{"type": "string", "name": "times", "default": "a"}]),
            "stale-configuration",
            "custom-stale-type",
        ),
        (chosen(shape=["blockLeft"]), "stale-configuration", "custom-stale-shape"),
        (
            chosen(variables=[{"type": "int", "name": "times", "default": 1, "range": [0, 2]}]),
            "bad-default",
            "block-expects-range",
        ),
    ],
)
def test_a_configuration_that_does_not_fit_is_reported(configuration, code, message):
    (problem,) = check(PLAIN, configuration).problems

    assert ("configuration", code) == (problem.part, problem.diagnostic.code)
    assert_about(problem.diagnostic.message, message)


def test_nothing_is_run():
    assert () == check("raise SystemExit\n" + PLAIN).problems


@settings(max_examples=50)
@given(st.text(max_size=60), st.text(max_size=30))
def test_any_text_is_accepted_or_reported(source, configuration):
    checked = check(source, configuration)

    assert checked.errors or checked.blocks


# A second check has the same result.


@settings(max_examples=50)
@given(
    st.sampled_from(["motor", "express"]),
    st.dictionaries(st.sampled_from(["EN", "ES"]), st.just("hop")),
)
def test_the_saved_configuration_is_complete(kind, words):
    first = check(PLAIN, chosen(type=kind, languages=words))
    again = check(PLAIN, first.chosen)

    assert (first.blocks, first.chosen) == (again.blocks, again.chosen)
