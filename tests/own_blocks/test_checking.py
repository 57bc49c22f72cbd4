"""What is wrong with a block, told before it is accepted; nothing of it is run."""

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.blocks import load_configurations
from learnblock.own_blocks import check, save
from learnblock.own_blocks.own_block import Checked

PLAIN = "def waltz(robot, times: int = 3) -> None:\n    'Dance.'\n"


def told(checked: Checked):
    return [(one.diagnostic.code, one.diagnostic.line, one.part) for one in checked.problems]


def chosen(**more) -> str:
    return json.dumps(
        {"type": "motor", "category": "Dance", "name": "waltz", "shape": ["blockVertical"], **more}
    )


def test_nothing_is_wrong_with_a_function_that_takes_the_robot():
    checked = check(PLAIN, name="ball_room")

    assert () == checked.problems
    (block,) = checked.blocks
    assert ("waltz", "Ball room") == (block.name, block.category)


def test_without_a_name_the_tab_is_called_after_the_first_function():
    assert "Waltz" == check(PLAIN).blocks[0].category


def test_several_functions_and_helpers_are_fine():
    source = PLAIN + "def _half(x): return x / 2\ndef tango(robot): _half(3)\n"

    assert () == check(source).problems
    assert ["waltz", "tango"] == [block.name for block in check(source).blocks]


@pytest.mark.parametrize(
    ("source", "code", "line", "message"),
    [
        ("x = 1\ndef f(robot:\n", "syntax-error", 2, "'(' was never closed"),
        ("def f(robot, a, a): ...\n", "syntax-error", 1, "duplicate argument 'a'"),
        ("def f(robot): ...\nreturn 3\n", "syntax-error", 2, "'return' outside function"),
        ("x = '\0'\n", "syntax-error", 0, "null bytes"),
        ("", "no-function", 0, "write one, such as `def dance(robot"),
        ("def _f(robot): ...\n", "no-function", 0, "no function in it that takes the robot"),
        ("async def f(robot): ...\n", "async-function", 1, "write `def f`"),
        ("def f(robot): ...\ndef f(robot): ...\n", "duplicate-name", 2, "in line 1 already"),
        ("def square(side): ...\n", "no-robot", 1, "`side`, and it is given the robot"),
        ("x = 1\ndef turn(robot): ...\n", "name-taken", 2, "LearnBlock has a skill"),
        ("def f(robot,\n  class_=3): ...\n", "bad-name", 2, "`class_` means `class` in Block-Text"),
        ("def from_(robot): ...\n", "bad-name", 1, "choose another name"),
        ("def stop(robot): ...\n", "name-taken", 1, "every robot has something of this name"),
        ("def f(robot, *, key): ...\n", "unfit-parameter", 1, "no block can give `key`"),
        ("def f(robot,\n      x: Decimal = 3): ...\n", "bad-hint", 2, "`Decimal` names no field"),
        ("def f(robot, x: int = 'a'): ...\n", "bad-default", 1, "a number is expected"),
        ("def f(robot, x: str = 3): ...\n", "bad-default", 1, "a text is expected"),
        ("def f(robot, x: bool = 3): ...\n", "bad-default", 1, "True or False is expected"),
        ("def f(robot, x: list = 3): ...\n", "bad-default", 1, "a list is expected"),
        ("def f(robot, x: TagName = 1.5): ...\n", "bad-default", 1, "the name of a tag"),
        ("def f(robot, x: Colour = 'red'): ...\n", "bad-default", 1, "#ff8800"),
        ("def f(robot, x: Literal['a'] = 'b'): ...\n", "bad-default", 1, "the choices are 'a'"),
        (
            "def f(robot, x: Annotated[float, Range(0, 9)] = 10): ...\n",
            "bad-default",
            1,
            "it goes from 0 to 9",
        ),
        ("import no_such_package\ndef f(robot): ...\n", "unknown-import", 1, "no package `no_such"),
        ("from os import path\nfrom . import x\ndef f(robot): ...\n", "unknown-import", 2, "dots"),
        (
            "def f(robot):\n    from learnblock.devices import Bse\n",
            "unknown-import",
            2,
            "did you mean `Base`?",
        ),
        (
            "from learnblock.device import Base\ndef f(robot): ...\n",
            "unknown-import",
            1,
            "did you mean `devices`?",
        ),
        (
            "import learnblock.libraries.dance\ndef f(robot): ...\n",
            "unknown-import",
            1,
            "there is no library `dance`",
        ),
    ],
)  # fmt: skip
def test_what_keeps_a_block_from_being_accepted(source, code, line, message):
    checked = check(source)

    assert [(code, line)] == [(one.diagnostic.code, one.diagnostic.line) for one in checked.errors]
    assert message in checked.errors[0].diagnostic.message


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
def test_an_import_of_what_is_there_is_fine(source):
    assert () == check(source + PLAIN).problems


def test_a_function_without_a_robot_beside_others_is_only_doubtful():
    checked = check(PLAIN + "def helper(): ...\n")

    assert [("no-robot", 3, "source")] == told(checked)
    assert () == checked.errors


def test_two_blocks_cannot_share_a_name():
    save("dance", PLAIN)

    assert [("name-taken", 1, "source")] == told(check(PLAIN, name="other"))
    assert () == check(PLAIN, name="other", replaces="dance").problems


@pytest.mark.parametrize("name", ["../evil", "a/b", "a.b", "-a", "con", "x" * 61, "a\n"])
def test_a_name_that_no_file_can_have_is_told(name):
    assert [("wrong-name", 0, "name")] == told(check(PLAIN, name=name))


# What is chosen.


def test_what_is_chosen_is_joined_with_what_the_source_says():
    checked = check(PLAIN, chosen(languages={"ES": "bailar"}))
    (block,) = load_configurations(checked.complete)

    assert ("motor", "Dance") == (block.type, block.category)
    assert {"EN": "waltz", "ES": "bailar"} == block.languages
    assert {"EN": "Dance."} == block.tooltip


def test_what_is_saved_leaves_the_docstring_free_to_change():
    saved = check(PLAIN, check(PLAIN, chosen(languages={"ES": "bailar"})).complete).chosen
    (block,) = check(PLAIN.replace("Dance.", "Hop."), saved).blocks

    assert {"EN": "Hop."} == block.tooltip
    assert {"EN": "waltz", "ES": "bailar"} == block.languages


def test_whoever_renames_a_function_keeps_what_was_chosen():
    checked = check(PLAIN.replace("waltz", "hop"), chosen(languages={"EN": "waltz", "ES": "baile"}))

    assert () == checked.problems
    assert {"EN": "hop", "ES": "baile"} == checked.blocks[0].languages
    assert "Dance" == checked.blocks[0].category


@pytest.mark.parametrize(
    ("configuration", "code", "message"),
    [
        ("{", "not-json", ""),
        (chosen(type="motors"), "unknown-value", "did you mean `motor`?"),
        (f"[{chosen()}, {chosen(name='gone')}]", "stale-configuration", "no such function"),
        (
            chosen(variables=[{"type": "int", "name": "gone", "default": 3}]),
            "stale-configuration",
            "`waltz` has no parameter `gone`",
        ),
        (
            chosen(variables=[{"type": "string", "name": "times", "default": "a"}]),
            "stale-configuration",
            "`times` of `waltz` is int in the function and string in the configuration",
        ),
        (chosen(shape=["blockLeft"]), "stale-configuration", "is a statement by its function"),
        (
            chosen(variables=[{"type": "int", "name": "times", "default": 1, "range": [0, 2]}]),
            "bad-default",
            "the default is 3, but it goes from 0 to 2",
        ),
    ],
)
def test_a_configuration_that_does_not_fit_is_told(configuration, code, message):
    (problem,) = check(PLAIN, configuration).problems

    assert ("configuration", code) == (problem.part, problem.diagnostic.code)
    assert message in problem.diagnostic.message


def test_nothing_is_run():
    assert () == check("raise SystemExit\n" + PLAIN).problems


@settings(deadline=None, max_examples=50)
@given(st.text(max_size=60), st.text(max_size=30))
def test_whatever_is_written_is_told_or_fine(source, configuration):
    checked = check(source, configuration)

    assert checked.errors or checked.blocks


# What was checked once is the same when it is checked again.


@settings(deadline=None, max_examples=50)
@given(
    st.sampled_from(["motor", "express"]),
    st.dictionaries(st.sampled_from(["EN", "ES"]), st.just("hop")),
)
def test_what_is_saved_says_what_was_complete(kind, words):
    first = check(PLAIN, chosen(type=kind, languages=words))
    again = check(PLAIN, first.chosen)

    assert (first.blocks, first.chosen) == (again.blocks, again.chosen)
