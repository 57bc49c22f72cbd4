"""Programs survive the conversion to blocks and back."""

from dataclasses import replace

import msgspec
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from gate import examples
from learnblock.blocks.palette import palette
from learnblock.blocks.schema.configuration import BlockConfiguration, Parameter
from learnblock.blocks.toolbox import SKILL
from learnblock.fields import Range
from learnblock.language import format as format_program
from learnblock.language import from_python, from_workspace, parse, to_python, to_workspace
from learnblock.language.tree.nodes import Blank, Comment
from learnblock.language.tree.traversal import expressions, statements, within
from places import ROOT, TESTS
from workspaces import CONFIGURATIONS, BlockTrees, as_json, blocks, through_json

GOLDEN = sorted((TESTS / "cases").glob("*/program.json"))
PROGRAMS = sorted([*(TESTS / "cases").glob("*/program.bt"), *(ROOT / "examples").glob("*.bt")])
every_program = pytest.mark.parametrize(
    "path", PROGRAMS, ids=lambda path: path.parent.name if path.stem == "program" else path.stem
)
seeds = st.integers(min_value=0, max_value=2**32).map(BlockTrees)
many = settings(suppress_health_check=list(HealthCheck))


def written(program, previous=None):
    return to_workspace(program, CONFIGURATIONS, previous).workspace


def read(workspace):
    found = from_workspace(workspace, CONFIGURATIONS)
    assert () == found.problems
    return found.program


def assert_survives(program):
    """Check that a program survives the conversion to blocks, and its blocks the way back."""
    workspace = through_json(written(program))
    back = read(workspace)
    assert program == back
    assert format_program(program) == format_program(back)
    assert to_python(program).text == to_python(back).text
    assert workspace == written(program, workspace)


@pytest.mark.parametrize("path", GOLDEN, ids=lambda path: path.parent.name)
def test_a_golden_program_becomes_its_golden_blocks(path):
    program = parse(path.with_suffix(".bt").read_text("utf-8"))
    golden = msgspec.json.format(as_json(written(program)), indent=1) + "\n"
    assert path.read_text("utf-8") == golden


@every_program
def test_a_program_survives_as_blocks(path):
    assert_survives(parse(path.read_text("utf-8")))


@every_program
def test_python_survives_as_blocks(path):
    python = to_python(parse(path.read_text("utf-8"))).text
    back = read(through_json(written(from_python(python))))
    assert python == to_python(back).text


@pytest.mark.slow
@settings(many, max_examples=examples(1000, gate=100))
@given(seeds)
def test_a_random_program_survives_as_blocks(trees):
    assert_survives(trees.program())


def test_the_random_programs_have_every_block_of_the_language_and_every_skill():
    tabs = palette(CONFIGURATIONS, "en")["toolbox"]["contents"]
    offered = {one["type"] for tab in tabs for one in tab.get("contents", ()) if "type" in one}
    of_language = {one for one in offered if not one.startswith(SKILL)}
    # Time has a block of the language.
    missing = of_language | {SKILL + skill for skill in CONFIGURATIONS if skill != "elapsedTime"}
    for seed in range(4000):
        if not missing:
            break
        missing -= {block.type for block in blocks(written(BlockTrees(seed).program()))}
    assert missing == set()


@settings(many, max_examples=examples(300, gate=50))
@given(seeds, seeds)
def test_a_random_program_survives_after_any_other(trees, others):
    program = trees.program()
    workspace = written(program, through_json(written(others.program())))
    assert program == read(through_json(workspace))
    ids = [block.id for block in blocks(workspace)]
    assert len(set(ids)) == len(ids)


@settings(many, max_examples=examples(100, gate=30))
@given(seeds)
def test_everything_in_a_program_has_a_block(trees):
    program = trees.program()
    fresh = to_workspace(program, CONFIGURATIONS)
    kept = to_workspace(program, CONFIGURATIONS, fresh.workspace)
    back = from_workspace(fresh.workspace, CONFIGURATIONS)
    for tree, ids in (
        (program, fresh.block_ids),
        (program, kept.block_ids),
        (back.program, back.block_ids),
    ):
        assert not [node for node in nodes_of(tree) if id(node) not in ids]


@settings(many, max_examples=examples(100, gate=30))
@given(seeds)
def test_both_directions_use_the_same_block_ids(trees):
    program = trees.program()
    text = to_workspace(program, CONFIGURATIONS)
    back = from_workspace(text.workspace, CONFIGURATIONS)
    there = [text.block_ids[id(node)] for node in nodes_of(program)]
    assert there == [back.block_ids[id(node)] for node in nodes_of(back.program)]


def nodes_of(program):
    """All nodes except blank lines, which the layout adds at the top level."""
    main = (program.main,) if program.main else ()
    found = [
        *(node for node in statements(program.items + main) if not isinstance(node, Blank)),
        *(note for note in program.ending if isinstance(note, Comment)),
    ]
    return found + [part for node in found for value in expressions(node) for part in within(value)]


def test_loops_may_be_as_deep_as_in_block_text():
    depth = 120
    text = "while True:\n" * depth + "x = 1\n" + "end\n" * depth
    program = parse(text)
    assert program == from_workspace(written(program), CONFIGURATIONS).program


def test_values_may_be_as_deep_as_in_block_text():
    program = parse("x = " + "-(" * 99 + "x" + ")" * 99 + "\n")
    assert program == from_workspace(written(program), CONFIGURATIONS).program


def test_a_hundred_loops_or_brackets_survive_as_json():
    loops = "while True:\n" * 100 + "pass\n" + "end\n" * 100
    for text in (loops, "x = " + "[" * 100 + "]" * 100 + "\n"):
        assert_survives(parse(text))


# The fields of parameters.

PAINT = BlockConfiguration(
    "others",
    "Paint",
    "paint",
    (
        Parameter("speed", "float", 50, range=Range(0, 100)),
        Parameter("turn", "angle", 90),
        Parameter("brush", "choice", "thin", choices=("thin", "thick")),
        Parameter("colour", "colour", "#ff8800"),
        Parameter("tag", "apriltext", "ball"),
        Parameter("way", "string", required=True),
    ),
)
PAINT = replace(PAINT, parameters=(PAINT.parameters[-1], *PAINT.parameters[:-1]))


@pytest.mark.parametrize(
    "arguments",
    [
        '"a"',
        '"a", 50, 90, "thin", "#ff8800", "ball"',
        '"a", 0, -720, "thick", "#000000", 8',
        '"a", 1000, 1e3, "purple", "red", "8"',
        '"a", -5, 0x10, "\\t", 3, 7.5',
        '"a", x + 1, turn, [], print, None',
        '"a", tag="b", speed=20',
        '"a", 20, colour="é", brush=7',
    ],
)
def test_any_argument_of_a_field_survives_as_a_block(arguments):
    program = parse(f"x = 1\nturn = 2\nfunction.paint({arguments})\n")
    made = to_workspace(program, {"paint": PAINT})
    workspace = through_json(made.workspace)
    back = from_workspace(workspace, {"paint": PAINT})

    assert [] == list(back.problems)
    assert format_program(program) == format_program(back.program)
    assert workspace == to_workspace(back.program, {"paint": PAINT}, workspace).workspace


def test_a_constant_is_shown_in_the_field_of_its_parameter():
    program = parse('function.paint("a", 20, -90, "thick", "#000000", 8)\n')
    (_, block, *shadows) = blocks(to_workspace(program, {"paint": PAINT}).workspace)

    assert "lb_skill_paint" == block.type
    assert [
        ("text", {"TEXT": "a"}),
        ("lb_slider", {"NUM": 20}),
        ("lb_angle", {"NUM": -90}),
        ("lb_choice", {"TEXT": "thick"}),
        ("lb_colour", {"TEXT": "#000000"}),
        ("lb_tag", {"TEXT": "8"}),
    ] == [(shadow.type, shadow.fields) for shadow in shadows]
