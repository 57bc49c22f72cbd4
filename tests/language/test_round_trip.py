"""The ladder: same tree, same text, every golden program, random programs in every direction."""

import random
import subprocess
import sys
from pathlib import Path

import lark
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.lark import from_lark

from learnblock.language import check, from_python, parse, recover, to_python
from learnblock.language import format as format_program
from learnblock.language.nodes import (
    Activate,
    Assign,
    Binary,
    Blank,
    Branch,
    Break,
    Call,
    Comment,
    Compare,
    Constant,
    Continue,
    Deactivate,
    Def,
    Else,
    ForEach,
    ForRange,
    If,
    Import,
    Index,
    Keyword,
    List,
    Main,
    Name,
    Number,
    Pass,
    Perform,
    Program,
    Raw,
    RawExpression,
    Repeat,
    Return,
    Setup,
    SkillCall,
    String,
    Unary,
    When,
    While,
)

TESTS = Path(__file__).parent.parent
CASES = sorted((TESTS / "cases").glob("*/program.bt"))
EXAMPLES = sorted((TESTS.parent / "examples").glob("*.bt"))
PROGRAMS = [*CASES, *EXAMPLES]
GRAMMAR = lark.Lark((TESTS / "blocktext.lark").read_text("utf-8"), start="program", parser="lalr")
ROBOT = "learnblock.robots.ebo"
# Raw Python and lines that no formatter would leave alone.
NOT_IN_BLACK = {"raw_python", "library"}


def name_of(path):
    return path.parent.name if path.name == "program.bt" else path.stem


every_program = pytest.mark.parametrize("path", PROGRAMS, ids=name_of)
every_case = pytest.mark.parametrize("path", CASES, ids=name_of)


def assert_ladder(program):
    """Block-Text and Python of a tree both lead back to it, and to themselves."""
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
def test_a_program_climbs_the_ladder(path):
    assert_ladder(parse(path.read_text("utf-8")))


@every_program
def test_lark_reads_what_we_read(path):
    text = path.read_text("utf-8")
    GRAMMAR.parse(text)
    GRAMMAR.parse(format_program(parse(text)))


@pytest.mark.parametrize(
    "path", [path for path in PROGRAMS if name_of(path) not in NOT_IN_BLACK], ids=name_of
)
def test_ruff_format_changes_nothing_in_generated_python(path):
    python = to_python(parse(path.read_text("utf-8"))).text
    command = [sys.executable, "-m", "ruff", "format", "--isolated", "--line-length=100", "-"]
    done = subprocess.run(command, input=python.encode(), capture_output=True, check=True)
    assert python == done.stdout.decode()


# Random trees. They come from one random number, since drawing every node from Hypothesis would be
# fifty times slower; a failing seed is as good as a small tree, for `Trees(seed).program()`.

NAMES = ["append", "class", "class_", "elapsedTime", "from", "len", "math", "print", "python"]
NAMES += ["random", "range", "repeat", "robot", "seen", "seen_when", "seen_when_when", "sqrt"]
NAMES += ["start", "state_seen", "step", "time_seen", "to", "values", "x", "y", "ñ", "_"]
SKILLS = ("is_tag", "turn", "class", "end")
KEYWORDS = ("a", "end", "import", "advSpeed", "class", "x")
LIBRARY = (
    ("append", 2),
    ("sqrt", 1),
    ("sin", 1),
    ("sublist", 3),
    ("join", 2),
    ("constrain", 3),
    ("random", 2),
    ("len", 1),
    ("pop", 1),
    ("pop", 2),
    ("pi", 0),
    ("elapsedTime", 1),
)
NUMBERS = ("0", "1", "2", "10", "2.5", "1e3", "0xFF", ".5", "5.")
TEXTS = ("", "hi", '"', "'", "\\", "\n", "# end", "é", "\ud800", "a'b\"c", "\x00")
RAW_EXPRESSIONS = ("{1: 2}", "lambda: 0", "x.y", "a if b else c", "b'`'")
RAW_STATEMENTS = (
    "import os\n",
    "import math\n",
    "x = 1\n",
    "with a as b:\n    pass\n\n\n",
    "end\n",
    "  \nx\n",
    "# end\nx\n",
    "#end\n# # end\n'''\n# end\n'''\n",
    "x # end\n",
)
COMMENTS = ("", "note", "main", "# main", "end", "!x", "# # end", "python")
OPERATORS = ("or", "and", "+", "-", "*", "/", "//", "%", "**")
COMPARISONS = ("==", "!=", "<", ">", "<=", ">=", "in", "not in")
ASSIGNMENTS = ("=", "=", "+=", "-=", "*=", "/=", "//=", "%=", "**=")


class Trees:
    """Random trees, of which many are no sensible programs."""

    def __init__(self, seed):
        self.random = random.Random(seed)  # noqa: S311 - no secret
        self.choice = self.random.choice

    def some(self, most, make, *arguments):
        return tuple(make(*arguments) for _ in range(self.random.randrange(most)))

    def perhaps(self, value):
        return self.choice((None, value))

    def expression(self, depth=3):
        leaves = (self.number, self.string, self.constant, self.name, self.name, self.raw)
        inner = (self.call, self.skill_call, self.list, self.index, self.unary, self.library_call)
        twice = (self.binary, self.binary, self.binary, self.compare)
        make = self.choice(leaves if depth <= 0 else leaves + inner + twice)
        return make(depth - 1)

    def number(self, _):
        return Number(self.choice(NUMBERS))

    def string(self, _):
        return String(self.choice(TEXTS))

    def constant(self, _):
        return Constant(self.choice((True, False, None)))

    def name(self, _=0):
        return Name(self.choice(NAMES))

    def raw(self, _):
        return RawExpression(self.choice(RAW_EXPRESSIONS))

    def arguments(self, depth):
        keywords = self.random.sample(KEYWORDS, self.choice((0, 0, 0, 1, 2)))
        given = tuple(Keyword(keyword, self.expression(depth)) for keyword in keywords)
        return self.some(3, self.expression, depth), given

    def call(self, depth=2):
        return Call(self.choice(NAMES), *self.arguments(depth))

    def skill_call(self, depth=2):
        return SkillCall(self.choice(SKILLS), *self.arguments(depth))

    def library_call(self, depth):
        name, count = self.choice(LIBRARY)
        return Call(name, tuple(self.expression(depth) for _ in range(count)))

    def list(self, depth):
        return List(self.some(4, self.expression, depth))

    def index(self, depth):
        return Index(self.expression(depth), self.expression(depth))

    def unary(self, depth):
        return Unary(self.choice(("not", "-", "+")), self.expression(depth))

    def binary(self, depth):
        return Binary(self.choice(OPERATORS), self.expression(depth), self.expression(depth))

    def compare(self, depth):
        operators = (self.choice(COMPARISONS), *self.some(3, self.choice, COMPARISONS))
        operands = tuple(self.expression(depth) for _ in range(len(operators) + 1))
        return Compare(operators, operands)

    def comment(self):
        return self.choice(COMMENTS) if self.random.random() < 0.3 else None

    def target(self):
        target = self.name()
        while self.random.random() < 0.2:
            target = Index(target, self.expression(1))
        return target

    def statement(self, depth):
        simple = (
            lambda _: Perform(self.choice((self.call, self.skill_call))(), self.comment()),
            lambda _: Assign(
                self.target(), self.choice(ASSIGNMENTS), self.expression(), self.comment()
            ),
            lambda _: self.choice((Break, Continue, Pass))(self.comment()),
            lambda _: Return(self.perhaps(self.expression(2)), self.comment()),
            lambda _: self.choice((Activate, Deactivate))(self.choice(NAMES), self.comment()),
            lambda _: Comment(self.comment() or "text"),
            lambda _: Raw(self.choice(RAW_STATEMENTS)),
            lambda _: Blank(),
        )
        blocks = (self.while_loop, self.repeat, self.for_each, self.for_range, self.if_chain)
        return self.choice(simple if depth <= 0 else simple + blocks)(depth - 1)

    def body(self, depth):
        body = [self.statement(depth) for _ in range(self.random.randrange(1, 4))]
        idle = all(isinstance(statement, Comment | Blank) for statement in body)
        return (*body, Pass()) if idle else tuple(body)

    def while_loop(self, depth):
        return While(self.expression(2), self.body(depth), self.comment())

    def repeat(self, depth):
        return Repeat(self.expression(2), self.body(depth), self.comment())

    def for_each(self, depth):
        return ForEach(self.name(), self.expression(2), self.body(depth), self.comment())

    def for_range(self, depth):
        step = self.choice((None, self.expression(1), Unary("-", Number("1"))))
        bounds = self.expression(2), self.expression(2)
        return ForRange(self.name(), *bounds, step, self.body(depth), self.comment())

    def if_chain(self, depth):
        branches = tuple(
            Branch(self.expression(2), self.body(depth), self.comment())
            for _ in range(self.choice((1, 1, 2, 3)))
        )
        return If(branches, self.perhaps(Else(self.body(depth), self.comment())))

    def item(self):
        kind = self.random.randrange(8)
        if kind == 0:
            parameters = tuple(self.random.sample(NAMES, self.random.randrange(3)))
            return Def(self.choice(NAMES), parameters, self.body(2), self.comment())
        if kind == 1:
            condition = self.perhaps(self.expression(2))
            return When(self.choice(NAMES), condition, self.body(2), self.comment())
        return self.statement(2)

    def program(self):
        world = (Keyword("world", String("x")),)
        head = (Comment("top"), Import("dance", self.comment()), Setup((), world, self.comment()))
        items = [item for item in head if self.random.random() < 0.2]
        items += self.some(6, self.item)
        main = self.perhaps(Main(self.body(2)))
        ending = (Comment("bye"),) if main and self.random.random() < 0.2 else ()
        # Through the parser, since a tree made by hand may have blank lines where none can be.
        return parse(format_program(Program(tuple(items), main, ending)))


seeds = st.integers(min_value=0, max_value=2**32).map(Trees)
many = settings(deadline=None, suppress_health_check=list(HealthCheck), database=None)


def is_all_raw(program):
    return program.main is None and len(program.items) == 1 and type(program.items[0]) is Raw


@settings(many, max_examples=1800)
@given(seeds)
def test_a_random_program_climbs_the_ladder(trees):
    program = trees.program()
    # Raw Python alone is printed as it is, and it may be Python that we have words for.
    assume(not is_all_raw(program))
    assert_ladder(program)


@settings(many, max_examples=100)
@given(seeds)
def test_lark_reads_what_we_write(trees):
    text = format_program(trees.program())
    # Whether this is a loop or a call shows only at the end of the line: too late for Lark.
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
    "RAW": spaced("`{1: 2}`", "`lambda: 0`"),
    "PYTHON_BLOCK": spaced("\npython:\n    import os\n    end\n", "\npython:\n\\end\n  end\n"),
    "_NL": st.sampled_from(["\n", "\n\n", " # note\n", "\n# main\n\n  # end\n"]),
    "WHITE": st.just(" "),
    "INNER_COMMENT": st.just(""),
}


@settings(many, max_examples=120)
@given(from_lark(GRAMMAR, start="program", explicit=TERMINALS))
def test_a_program_of_the_grammar_climbs_the_ladder(text):
    program, diagnostics = recover(text)
    # A grammar cannot say that nothing may be named twice, nor that raw Python is no statement.
    beyond = {"duplicate-argument", "duplicate-parameter", "empty-block", "import-name"}
    beyond |= {"too-deep", "second-main", "argument-order"}
    codes = {diagnostic.code for diagnostic in diagnostics}
    assume(not codes & beyond and not is_all_raw(program))
    assert not codes
    assert_ladder(program)


JUNK = ["if", "else", "elif", "end", "while", "x", "(", ")", "[", "]", ",", "=", "==", "+", "-"]
JUNK += ["**", ":", '"', "'", "`", "#", "function", ".", "def", "when", "main", "python:", "1", "é"]
JUNK += ["”", "import", "repeat", "for", "in", "from", "to", "not", "and", "\\", "robot(", "return"]
JUNK += ["\n", "\n\n", "\t", "\r", "\f", "\0", "\ud800"]


@settings(many, max_examples=300)
@given(st.text() | st.lists(st.sampled_from(JUNK)).map(" ".join))
def test_junk_is_read_without_any_error_but_ours(text):
    program, _ = recover(text)
    check(program, {})
    format_program(program)
    to_python(program)
