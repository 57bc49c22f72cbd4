"""Round trips between the notations: golden, example and random programs in every direction."""

import ast
import re
import subprocess
import sys

import lark
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.lark import from_lark

from gate import examples
from learnblock.language import (
    check,
    from_python,
    from_workspace,
    parse,
    recover,
    to_python,
    to_workspace,
)
from learnblock.language import format as format_program
from learnblock.language.tree.nodes import Raw
from places import ROOT, TESTS
from python_scores import meaning
from trees import NUMBERS, Trees, has_distinct_whens

CASES = sorted((TESTS / "cases").glob("*/program.bt"))
EXAMPLES = sorted((ROOT / "examples").glob("*.bt"))
PROGRAMS = [*CASES, *EXAMPLES]
GRAMMAR = lark.Lark((TESTS / "blocktext.lark").read_text("utf-8"), start="program", parser="lalr")
ROBOT = "learnblock.robots.ebo"
# Raw Python and lines that a formatter would change.
NOT_IN_BLACK = {"raw_python", "library"}


def name_of(path):
    return path.parent.name if path.name == "program.bt" else path.stem


every_program = pytest.mark.parametrize("path", PROGRAMS, ids=name_of)
every_case = pytest.mark.parametrize("path", CASES, ids=name_of)


def assert_ladder(program):
    """Check that the Block-Text and the Python of a tree lead back to the same tree and text."""
    text = format_program(program)
    assert program == parse(text)
    assert text == format_program(parse(text))
    python = to_python(program)
    again = from_python(python.text)
    assert program == again
    assert text == format_program(again)
    assert again.python is None
    assert python.text == to_python(again).text


@every_case
def test_a_golden_program_becomes_its_golden_python(path):
    expected = path.with_suffix(".py").read_text("utf-8")
    assert expected == to_python(parse(path.read_text("utf-8")), ROBOT).text


@every_program
def test_a_program_survives_every_round_trip(path):
    assert_ladder(parse(path.read_text("utf-8")))


@every_program
def test_the_grammar_reads_every_program(path):
    text = path.read_text("utf-8")
    GRAMMAR.parse(text)
    GRAMMAR.parse(format_program(parse(text)))


@pytest.fixture(scope="module")
def formatted(tmp_path_factory):
    """A folder with the generated Python of every program, formatted at once."""
    folder = tmp_path_factory.mktemp("formatted")
    for path in PROGRAMS:
        python = to_python(parse(path.read_text("utf-8"))).text
        (folder / f"{name_of(path)}.py").write_text(python, "utf-8", newline="")
    command = [sys.executable, "-m", "ruff", "format", "--isolated", "--line-length=100", folder]
    subprocess.run(command, capture_output=True, check=True)
    return folder


@pytest.mark.parametrize(
    "path", [path for path in PROGRAMS if name_of(path) not in NOT_IN_BLACK], ids=name_of
)
def test_ruff_format_changes_nothing_in_generated_python(path, formatted):
    python = to_python(parse(path.read_text("utf-8"))).text
    assert python == (formatted / f"{name_of(path)}.py").read_bytes().decode()


seeds = st.integers(min_value=0, max_value=2**32).map(Trees)
many = settings(suppress_health_check=list(HealthCheck), database=None)


def is_all_raw(program):
    return program.main is None and len(program.items) == 1 and type(program.items[0]) is Raw


@pytest.mark.slow
@settings(many, max_examples=examples(1000, gate=100))
@given(seeds)
def test_a_random_program_survives_every_round_trip(trees):
    program = trees.program()
    # Raw Python alone is written unchanged, and Block-Text may have an equivalent for it.
    assume(not is_all_raw(program))
    assert_ladder(program)


@settings(many, max_examples=100)
@given(seeds)
def test_the_grammar_reads_formatted_programs(trees):
    text = format_program(trees.program())
    # Only the end of the line tells a loop from a call, which is too late for Lark.
    assume("repeat(" not in text and "repeat[" not in text)
    GRAMMAR.parse(text)


def spaced(*words):
    return st.sampled_from([f" {word} " for word in words])


KEYWORD_TERMINALS = {
    terminal.name: spaced(terminal.pattern.value)
    for terminal in GRAMMAR.terminals
    if terminal.pattern.type == "str" and terminal.pattern.value.isalpha()
}
TERMINALS = {
    **KEYWORD_TERMINALS,
    "NAME": spaced("x", "ñandú", "class", "append", "state_seen", "seen", "robot", "_"),
    "NUMBER": spaced(*NUMBERS),
    "STRING": spaced('"a"', "'b'", r'"\n"', "'\"'"),
    "FSTRING": spaced('f"a{x}"', "f'{x[0]} {y}'", 'f"{{}}"', "F'{state_seen}!'"),
    "RAW_HEADER": spaced("`for a, in b`"),
    "RAW_PART": spaced("`else`"),
    "RAW_MATCH": spaced("`match x, *[y]`"),
    "RAW_CASE": spaced("`case [a, *b] if c`", "`case _`"),
    "RAW": spaced("`{1, 2}`", "`lambda: 0`"),
    "PYTHON_BLOCK": spaced("\npython:\n    import os\n    end\n", "\npython:\n\\end\n  end\n"),
    "_NL": st.sampled_from(["\n", "\n\n", " # note\n", "\n# main\n\n  # end\n"]),
    "WHITE": st.just(" "),
    "INNER_COMMENT": st.just(""),
}


LOCAL_LINE = re.compile(r"\blocal\s+\w+\s*=")


@pytest.mark.slow
@settings(many, max_examples=examples(60, gate=15))
@given(from_lark(GRAMMAR, start="program", explicit=TERMINALS))
def test_a_program_of_the_grammar_survives_every_round_trip(text):
    # A grammar cannot forbid a second else of Python, nor one that shares its line.
    assume("`else`" not in text)
    program, diagnostics = recover(text)
    # A grammar cannot forbid duplicate names, nor bodies of comments in raw Python.
    beyond = {"duplicate-argument", "duplicate-parameter", "empty-block", "import-name"}
    beyond |= {"too-deep", "second-main", "argument-order"}
    codes = {diagnostic.code for diagnostic in diagnostics}
    assume(not codes & beyond and not is_all_raw(program) and has_distinct_whens(program))
    # Nor that `local` is for the first line of a function that sets a variable.
    assume(not LOCAL_LINE.search(text))
    # Nor that a program without a robot uses none, or has no statement.
    assume(not program.is_without_robot)
    assert not codes
    assert_ladder(program)


JUNK = ["if", "else", "elif", "end", "while", "x", "(", ")", "[", "]", ",", "=", "==", "+", "-"]
JUNK += ["**", ":", '"', "'", "`", "#", "function", ".", "def", "when", "main", "python:", "1", "é"]
JUNK += ["”", "import", "repeat", "for", "in", "from", "to", "not", "and", "\\", "robot(", "return"]
JUNK += ["\n", "\n\n", "\t", "\r", "\f", "\0", "\ud800"]


@settings(many, max_examples=examples(300, gate=100))
@given(st.text() | st.lists(st.sampled_from(JUNK)).map(" ".join))
def test_junk_never_crashes_the_language(text):
    program, _ = recover(text)
    check(program, {})
    format_program(program)
    to_python(program)


WITHOUT_ROBOT = [
    "x = 1\n",
    "import math  # why\n\nprint(math.tau)\n",
    "@cache\ndef f(a, b=2):  # f\n    c = a\n    return c\n",
    'class A(B):\n    """A.\n\n    B.\n    """\n\n    def f(self):\n        self.x += \'a\'[0:2]\n',
    "try:\n    f()\nexcept E as e:\n    raise\nelse:\n    pass\n# note\nfinally:\n    x.y(1)\n",
    "def f(n):\n    global a, b\n    a = b = [i for i in n if i]\n",
    "for a, (b, c) in d:\n    pass\nelse:\n    assert a < b < c, 'no'\n",
]


@pytest.mark.parametrize("python", WITHOUT_ROBOT)
def test_python_without_a_robot_survives_in_every_notation(python):
    program = from_python(python)
    assert_ladder(parse(format_program(program)))
    assert program == from_workspace(to_workspace(program, {}).workspace, {}).program
    again = to_python(parse(format_program(program))).text
    assert meaning(ast.parse(again)) == meaning(ast.parse(python))


@pytest.mark.parametrize(
    "statement", ["for i, a in enumerate([90]):\n    robot.turn(a)\n", "assert robot\n"]
)
def test_the_robot_of_a_program_that_is_otherwise_raw_python_survives(statement):
    python = f"from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n\n{statement}"
    tree = parse(format_program(from_python(python)))
    assert "robot = Robot()" in to_python(tree).text
    assert from_python(to_python(tree).text) == tree
    assert from_workspace(to_workspace(tree, {}).workspace, {}).program == tree
