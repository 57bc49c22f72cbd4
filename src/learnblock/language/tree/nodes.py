"""The syntax tree that the three notations share: one class for each rule of the grammar.

A node has its position in the source (`span`), which is ignored when two trees are compared.
Comments and blank lines are part of the tree: `Comment` and `Blank` are statements, and a statement
has the comment at the end of its line. Blank lines that the layout adds to every program, such as
the one before a ``def``, are not in the tree.
"""

import re
from dataclasses import dataclass, field, replace
from typing import NamedTuple


class Span(NamedTuple):
    """The position of a node: lines and columns from 1; `end_column` is after the last one."""

    line: int = 0
    column: int = 0
    end_line: int = 0
    end_column: int = 0


NOWHERE = Span()
_WORDS = re.compile(r"\w+")
_FURTHER = re.compile(r"(?:except|finally|else|case)\b")


@dataclass(frozen=True, slots=True)
class Number:
    """A number, as the author spelled it: ``40``, ``0.5``, ``1e3``, ``0xFF``."""

    text: str
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class String:
    """A string; `value` is its content, without quotes and escapes."""

    value: str
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class FString:
    """``f"score: {score}"``: text with values in it.

    A `String` among the parts is text between the braces; two never follow each other, and none is
    empty. Every other part is a value that `texts.is_plain`.
    """

    parts: "tuple[Expression, ...]" = ()
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Constant:
    """``True``, ``False`` or ``None``."""

    value: bool | None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Name:
    """A variable; or, with a ``when X`` in the program, ``state_X`` or ``time_X``."""

    name: str
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Keyword:
    """``advSpeed=80`` among the arguments of a call."""

    name: str
    value: "Expression"
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Call:
    """A call of a user's function, a library function or a function of an imported file."""

    name: str
    arguments: "tuple[Expression, ...]" = ()
    keywords: tuple[Keyword, ...] = ()
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class SkillCall:
    """``function.NAME(...)``: a call of a skill of the robot."""

    name: str
    arguments: "tuple[Expression, ...]" = ()
    keywords: tuple[Keyword, ...] = ()
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class List:
    """``[1, 2, 3]``."""

    items: "tuple[Expression, ...]" = ()
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Dictionary:
    """``{"Ana": 1, "Luis": 2}``."""

    keys: "tuple[Expression, ...]" = ()
    values: "tuple[Expression, ...]" = ()
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Index:
    """``values[index]``, counted from 0, -1 is the last one; or a key of a dictionary."""

    value: "Expression"
    index: "Expression"
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Unary:
    """``not x``, ``-x`` or ``+x``."""

    operator: str
    operand: "Expression"
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Binary:
    """Two operands and one of ``or and + - * / // % **``."""

    operator: str
    left: "Expression"
    right: "Expression"
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Compare:
    """A comparison, chained as in Python: ``0 < x < 10`` has two operators and three operands."""

    operators: tuple[str, ...]
    operands: "tuple[Expression, ...]"
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Conditional:
    """``yes if condition else no``."""

    yes: "Expression"
    condition: "Expression"
    no: "Expression"
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class RawExpression:
    """A Python expression without an equivalent in Block-Text, between backticks."""

    text: str
    span: Span = field(default=NOWHERE, compare=False)


Expression = (
    Number
    | String
    | FString
    | Constant
    | Name
    | Call
    | SkillCall
    | List
    | Dictionary
    | Index
    | Unary
    | Binary
    | Compare
    | Conditional
    | RawExpression
)


@dataclass(frozen=True, slots=True)
class Comment:
    """A comment on its own line; `text` is the part after the ``#``."""

    text: str
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Blank:
    """One or more blank lines written by the author."""

    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Perform:
    """A call as a statement."""

    call: Call | SkillCall
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Assign:
    """``x = 1``, ``x += 1``, ``values[0] = 1``; ``local x = 1`` makes `x` the function's own."""

    target: Name | Index
    operator: str
    value: Expression
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)
    is_local: bool = False


@dataclass(frozen=True, slots=True)
class Branch:
    """One condition of an `If` and the statements that run if it is true."""

    condition: Expression
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Else:
    """The statements of an `If` that run if no condition is true."""

    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class If:
    """``if``, any number of ``elif``, and an optional ``else``, closed by one ``end``."""

    branches: tuple[Branch, ...]
    otherwise: Else | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class While:
    """``while condition:``; with the condition ``True``, Block-Text writes ``forever:``."""

    condition: Expression
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)

    @property
    def is_endless(self) -> bool:
        """Whether only a ``break`` or a ``return`` can leave it."""
        return isinstance(self.condition, Constant) and self.condition.value is True


@dataclass(frozen=True, slots=True)
class Repeat:
    """``repeat count:``."""

    count: Expression
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class ForEach:
    """``for target in values:``; several targets take the parts of each value."""

    targets: tuple[Name, ...]
    values: Expression
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class ForRange:
    """``for target from start to stop step step:``, including `stop`."""

    target: Name
    start: Expression
    stop: Expression
    step: Expression | None
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class WaitUntil:
    """``wait until condition``: do nothing else until it is true."""

    condition: Expression
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Break:
    """Leave the innermost loop."""

    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Continue:
    """Continue with the next round of the innermost loop."""

    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Return:
    """Leave the function, optionally with a result."""

    value: Expression | None = None
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Pass:
    """Do nothing; makes an empty body valid."""

    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Activate:
    """Make the ``when`` with this name active."""

    name: str
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Deactivate:
    """Make the ``when`` with this name inactive."""

    name: str
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Raw:
    """Python statements, kept byte for byte; every line of `text` ends with a line feed.

    Only a program that consists of one such block may lack the last line feed, like its file.
    """

    text: str
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class PythonLine:
    """One statement of Python on one line that Block-Text has no words of its own for.

    In Block-Text it is between backticks: ```import turtle```. It may be a decorator, too.
    """

    text: str
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


def is_further_part(header: str) -> bool:
    """Whether the first line of a part of a `PythonBlock` can't be that of the first part."""
    return _FURTHER.match(header) is not None


@dataclass(frozen=True, slots=True)
class PythonPart:
    """The first line of a part of a `PythonBlock`, without its colon, and the statements in it."""

    header: str
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)

    @property
    def word(self) -> str:
        """The word that it begins with, such as ``class``; ``def`` for ``async def``."""
        words = _WORDS.findall(self.header)
        return "" if not words else words[1] if words[0] == "async" and words[1:] else words[0]

    @property
    def has_cases(self) -> bool:
        """Whether it begins a ``match``: it has no statements, and its cases are further parts."""
        return self.word == "match"


@dataclass(frozen=True, slots=True)
class PythonBlock:
    """A statement of Python with statements in it: a ``class``, a ``try`` with its handlers.

    The first part of a ``match`` has no statements; its further parts are the cases.
    """

    parts: tuple[PythonPart, ...]
    span: Span = field(default=NOWHERE, compare=False)

    @property
    def text(self) -> str:
        """Its first lines as Python, without the statements in it."""
        if not self.has_cases:
            return "".join(f"{part.header}: pass\n" for part in self.parts)
        cases = "".join(f" {part.header}: pass\n" for part in self.parts[1:])
        return f"{self.parts[0].header}:\n{cases}"

    def with_text(self, text: str) -> "PythonBlock":
        """The block with other first lines, written like `text`."""
        lines = text.splitlines()
        headers = [line.strip().removesuffix("pass").rstrip().removesuffix(":") for line in lines]
        parts = zip(self.parts, headers, strict=True)
        return replace(self, parts=tuple(replace(part, header=header) for part, header in parts))

    @property
    def has_cases(self) -> bool:
        """Whether it is a ``match``, which chooses among the statements of its cases."""
        return self.parts[0].has_cases

    @property
    def defers(self) -> bool:
        """Whether its statements run later, when something calls it."""
        return self.parts[0].word == "def"

    @property
    def is_loop(self) -> bool:
        """Whether it repeats its statements."""
        return self.parts[0].word in {"for", "while"}

    @property
    def has_scope(self) -> bool:
        """Whether the variables that it sets are its own."""
        return self.parts[0].word in {"def", "class"}


Statement = (
    Comment
    | Blank
    | Perform
    | Assign
    | If
    | While
    | Repeat
    | ForEach
    | ForRange
    | WaitUntil
    | Break
    | Continue
    | Return
    | Pass
    | Activate
    | Deactivate
    | Raw
    | PythonLine
    | PythonBlock
)
Body = tuple[Statement, ...]
#: Statements of which a part is only Python, their `text`.
AnyPython = Raw | PythonLine | PythonBlock


@dataclass(frozen=True, slots=True)
class WithoutRobot:
    """``without robot``: the program creates no robot. It is the first item, if it is one."""

    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Import:
    """``import "dance"``: a library, or everything defined in the Python file ``dance.py``."""

    module: str
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Setup:
    """``robot(world="line")``: creates the robot with other settings than the defaults."""

    arguments: tuple[Expression, ...] = ()
    keywords: tuple[Keyword, ...] = ()
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Def:
    """The definition of a user's function."""

    name: str
    parameters: tuple[str, ...]
    body: Body
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class When:
    """Statements that run while a state is active; a condition determines whether it is active."""

    name: str
    condition: Expression | None
    body: Body
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Main:
    """The statements of ``main``, which run after all other top-level statements."""

    body: Body
    span: Span = field(default=NOWHERE, compare=False)


Item = Statement | WithoutRobot | Import | Setup | Def | When


@dataclass(frozen=True, slots=True)
class Program:
    """A whole program.

    Args:
        items: the top level, in order, without `main`.
        main: the statements of `main`, which is written last.
        ending: comments and blank lines after `main`.
        python: the Python it was read from, if `to_python` would write it differently.
    """

    items: tuple[Item, ...] = ()
    main: Main | None = None
    ending: tuple[Comment | Blank, ...] = ()
    python: str | None = field(default=None, compare=False)
    span: Span = field(default=NOWHERE, compare=False)

    @property
    def is_without_robot(self) -> bool:
        """Whether it creates no robot."""
        return bool(self.items) and type(self.items[0]) is WithoutRobot

    @property
    def functions(self) -> dict[str, Def]:
        """The user's functions by name; if several have the same name, the last."""
        return {item.name: item for item in self.items if type(item) is Def}

    @property
    def whens(self) -> dict[str, When]:
        """The ``when``s by name; if several have the same name, the last."""
        return {item.name: item for item in self.items if type(item) is When}


Node = Item | Main | Branch | Else | PythonPart | Expression | Keyword | Program


def is_only_raw(items: tuple[Item, ...]) -> bool:
    """Whether the items of a program without `main` are one block of raw Python: a whole file."""
    return len(items) == 1 and isinstance(items[0], Raw)
