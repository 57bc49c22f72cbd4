"""Random programs, many of them not sensible.

Each comes from one random number, because drawing every node from Hypothesis would be fifty times
slower. A failing seed is enough to reproduce a failure: `Trees(seed).program()`.
"""

import random
from dataclasses import replace

from learnblock.language import format as format_program
from learnblock.language import parse
from learnblock.language.tree import texts
from learnblock.language.tree.nodes import (
    NOWHERE,
    Activate,
    Assign,
    Binary,
    Blank,
    Branch,
    Break,
    Call,
    Comment,
    Compare,
    Conditional,
    Constant,
    Continue,
    Deactivate,
    Def,
    Dictionary,
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
    PythonBlock,
    PythonLine,
    PythonPart,
    Raw,
    RawExpression,
    Repeat,
    Return,
    Setup,
    SkillCall,
    String,
    Unary,
    WaitUntil,
    When,
    While,
)

NAMES = ["append", "class", "class_", "elapsedTime", "from", "len", "math", "print", "python"]
NAMES += ["forever", "random", "range", "repeat", "robot", "seen", "seen_when", "sqrt"]
NAMES += ["seen_when_when", "start", "state_seen", "step", "time_seen", "to", "until", "values"]
NAMES += ["wait", "x", "y", "ñ", "_"]
LOCALS = ("local", "mine", "list")
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
    ("keys", 1),
    ("items", 1),
    ("enumerate", 1),
    ("pop", 1),
    ("pop", 2),
    ("pi", 0),
    ("elapsedTime", 1),
    ("input", 1),
    ("print", 1),
    ("atan2", 2),
    ("sum", 1),
    ("random_fraction", 0),
    ("round", 1),
    ("upper", 1),
    ("find", 2),
    ("replace", 3),
    ("strip", 1),
)
NUMBERS = ("0", "1", "2", "10", "2.5", "1e3", "0xFF", ".5", "5.")
TEXTS = ("", "hi", '"', "'", "\\", "\n", "# end", "é", "\ud800", "a'b\"c", "\x00")
RAW_EXPRESSIONS = ("{1, 2}", "lambda: 0", "x.y", "a @ b", "b'`'", "x.y(1, z='a')", "a[::n]")
#: Lines of Python, and the first lines of blocks of it.
LINES = ("import os", "a, b = b, a", "x.y(1, '`')", "raise E('no')", "x: int", "f(*a)(b)")
HEADERS = (
    ("try", "except (A, B) as e", "else", "finally"),
    ("with open('a', b) as c",),
    ("class Dog(Pet, n=2)",),
    ("def f(a, b=[1, 'c'], *rest, **more)",),
    ("for a, (b, c) in d.e", "else"),
    ("match f(x), *a", "case {'a': Dog(b, n=-1), **c} | None as d if not e[0]", "case [x, *_]"),
)
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


def has_distinct_whens(program):
    """Whether no two events have one name, which the check refuses and Python knows as one."""
    names = [item.name for item in program.items if isinstance(item, When)]
    return len(names) == len(set(names))


class Trees:
    """Random trees, many of them not sensible programs."""

    skills = SKILLS

    def __init__(self, seed):
        self.random = random.Random(seed)  # noqa: S311 - no secret
        self.choice = self.random.choice
        self.whens = set()
        self.unset_locals = None

    def some(self, most, make, *arguments):
        return tuple(make(*arguments) for _ in range(self.random.randrange(most)))

    def perhaps(self, value):
        return self.choice((None, value))

    def expression(self, depth=3):
        leaves = (self.number, self.string, self.constant, self.name, self.name, self.raw)
        inner = (self.call, self.skill_call, self.list, self.index, self.unary, self.library_call)
        inner += (self.f_string, self.dictionary)
        twice = (self.binary, self.binary, self.binary, self.compare, self.conditional)
        make = self.choice(leaves if depth <= 0 else leaves + inner + twice)
        return make(depth - 1)

    def number(self, _):
        return Number(self.choice(NUMBERS))

    def string(self, _):
        return String(self.choice(TEXTS))

    def f_string(self, depth):
        parts = self.some(4, self.choice((self.string, self.expression)), depth)
        plain = [part for part in parts if isinstance(part, String) or texts.is_plain(part)]
        return texts.f_string(plain, NOWHERE)

    def constant(self, _):
        return Constant(self.choice((True, False, None)))

    def name(self, _=0):
        return Name(self.choice(NAMES))

    def raw(self, _):
        return RawExpression(self.choice(RAW_EXPRESSIONS))

    def arguments(self, depth):
        keywords = self.random.sample(KEYWORDS, self.choice((0, 0, 0, 1, 2)))
        values = tuple(Keyword(keyword, self.expression(depth)) for keyword in keywords)
        return self.some(3, self.expression, depth), values

    def call(self, depth=2):
        return Call(self.choice(NAMES), *self.arguments(depth))

    def skill_call(self, depth=2):
        return SkillCall(self.choice(self.skills), *self.arguments(depth))

    def library_call(self, depth):
        name, count = self.choice(LIBRARY)
        return Call(name, tuple(self.expression(depth) for _ in range(count)))

    def list(self, depth):
        return List(self.some(4, self.expression, depth))

    def dictionary(self, depth):
        keys = self.some(3, self.expression, depth)
        return Dictionary(keys, tuple(self.expression(depth) for _ in keys))

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

    def conditional(self, depth):
        return Conditional(*(self.expression(depth) for _ in range(3)))

    def comment(self):
        return self.choice(COMMENTS) if self.random.random() < 0.3 else None

    def short_call(self):
        """A call that has a block of its own as a statement."""
        removed = Call("pop", (self.name(), self.string(0)))
        return self.choice((removed, Call("print", (self.expression(1),))))

    def target(self):
        target = self.name()
        while self.random.random() < 0.2:
            target = Index(target, self.expression(1))
        return target

    def assignment(self):
        if self.unset_locals is None or self.random.random() < 0.5:
            return Assign(
                self.target(), self.choice(ASSIGNMENTS), self.expression(), self.comment()
            )
        # The first to set a local variable says so.
        name = self.choice(LOCALS)
        is_local = name in self.unset_locals
        self.unset_locals.discard(name)
        operator = "=" if is_local else self.choice(ASSIGNMENTS)
        return Assign(Name(name), operator, self.expression(), self.comment(), is_local=is_local)

    def function_body(self):
        self.unset_locals = set(LOCALS)
        body = self.body(2)
        self.unset_locals = None
        return body

    def statement(self, depth):
        simple = (
            lambda _: Perform(
                self.choice((self.call, self.skill_call, self.short_call))(), self.comment()
            ),
            lambda _: self.assignment(),
            lambda _: self.choice((Break, Continue, Pass))(self.comment()),
            lambda _: Return(self.perhaps(self.expression(2)), self.comment()),
            lambda _: WaitUntil(self.expression(2), self.comment()),
            lambda _: self.choice((Activate, Deactivate))(self.choice(NAMES), self.comment()),
            lambda _: Comment(self.comment() or "text"),
            lambda _: Raw(self.choice(RAW_STATEMENTS)),
            lambda _: PythonLine(self.choice(LINES), self.comment()),
            lambda _: Blank(),
        )
        blocks = (self.while_loop, self.repeat, self.for_each, self.for_range, self.if_chain)
        blocks += (self.python_block,)
        return self.choice(simple if depth <= 0 else simple + blocks)(depth - 1)

    def body(self, depth):
        body = [self.statement(depth) for _ in range(self.random.randrange(1, 4))]
        idle = all(isinstance(statement, Comment | Blank) for statement in body)
        return (*body, Pass()) if idle else tuple(body)

    def while_loop(self, depth):
        condition = self.choice((self.expression(2), Constant(value=True)))
        return While(condition, self.body(depth), self.comment())

    def repeat(self, depth):
        return Repeat(self.expression(2), self.body(depth), self.comment())

    def for_each(self, depth):
        return ForEach(self.targets(), self.expression(2), self.body(depth), self.comment())

    def targets(self):
        return (self.name(), *self.some(3, self.name))

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

    def python_block(self, depth):
        headers = self.choice(HEADERS)
        outer, self.unset_locals = self.unset_locals, None
        parts = tuple(self.python_part(header, depth) for header in headers)
        self.unset_locals = outer
        return PythonBlock(parts)

    def python_part(self, header, depth):
        part = PythonPart(header, (), self.comment())
        return part if part.has_cases else replace(part, body=self.body(depth))

    def item(self):
        kind = self.random.randrange(8)
        if kind == 0:
            parameters = tuple(self.random.sample(NAMES, self.random.randrange(3)))
            return Def(self.choice(NAMES), parameters, self.function_body(), self.comment())
        if kind == 1:
            condition = self.perhaps(self.expression(2))
            # In Block-Text, two of one name are a mistake.
            name = self.random.choice([name for name in NAMES if name not in self.whens])
            self.whens.add(name)
            return When(name, condition, self.function_body(), self.comment())
        return self.statement(2)

    def program(self):
        self.whens.clear()
        world = (Keyword("world", String("x")),)
        head = (Comment("top"), Import("dance", self.comment()), Setup((), world, self.comment()))
        items = [item for item in head if self.random.random() < 0.2]
        items += self.some(6, self.item)
        main = self.perhaps(Main(self.body(2)))
        ending = (Comment("bye"),) if main and self.random.random() < 0.2 else ()
        # Parsed, because a tree built by hand may have blank lines where none are possible.
        return parse(format_program(Program(tuple(items), main, ending)))
