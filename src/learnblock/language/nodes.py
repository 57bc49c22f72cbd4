"""The syntax tree in which the three notations meet: one value for each rule of the grammar.

A node knows where it was written (`span`), which does not count when two trees are compared.
Comments and blank lines count: `Comment` and `Blank` stand among the statements, and a statement
keeps the comment at the end of its line. The rules of layout are those of `layout`: a blank line
that every program has there, such as the one before a ``def``, is not in the tree.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple, cast


class Span(NamedTuple):
    """Where a node was written: lines and columns from 1; `end_column` is behind the last."""

    line: int = 0
    column: int = 0
    end_line: int = 0
    end_column: int = 0


NOWHERE = Span()


@dataclass(frozen=True, slots=True)
class Number:
    """A number, as its author spelled it: ``40``, ``0.5``, ``1e3``, ``0xFF``."""

    text: str
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class String:
    """A text; `value` is what it stands for, without quotes and escapes."""

    value: str
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
    """A function of the user's, of the language's library or of an imported file."""

    name: str
    arguments: "tuple[Expression, ...]" = ()
    keywords: tuple[Keyword, ...] = ()
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class SkillCall:
    """``function.NAME(...)``: something that the robot can do, say or ask."""

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
class Index:
    """``values[index]``, counted from 0; -1 is the last one."""

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
class RawExpression:
    """A Python expression that Block-Text has no words for, between backticks."""

    text: str
    span: Span = field(default=NOWHERE, compare=False)


Expression = (
    Number
    | String
    | Constant
    | Name
    | Call
    | SkillCall
    | List
    | Index
    | Unary
    | Binary
    | Compare
    | RawExpression
)


@dataclass(frozen=True, slots=True)
class Comment:
    """A comment on a line of its own; `text` is what follows the ``#``."""

    text: str
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Blank:
    """One or more blank lines that the author put there."""

    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Perform:
    """A call as a statement of its own."""

    call: Call | SkillCall
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Assign:
    """``x = 1``, ``x += 1``, ``values[0] = 1``."""

    target: Name | Index
    operator: str
    value: Expression
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Branch:
    """One condition of an `If` and what is done when it holds."""

    condition: Expression
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Else:
    """What an `If` does when no condition holds."""

    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class If:
    """``if``, any number of ``elif``, and perhaps ``else``, closed by one ``end``."""

    branches: tuple[Branch, ...]
    otherwise: Else | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class While:
    """``while condition:``."""

    condition: Expression
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Repeat:
    """``repeat count:``."""

    count: Expression
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class ForEach:
    """``for target in values:``."""

    target: Name
    values: Expression
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class ForRange:
    """``for target from start to stop step step:``; `stop` itself is counted too."""

    target: Name
    start: Expression
    stop: Expression
    step: Expression | None
    body: "Body"
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Break:
    """Leave the innermost loop."""

    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Continue:
    """Go on with the next round of the innermost loop."""

    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Return:
    """Leave the function, perhaps with a result."""

    value: Expression | None = None
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Pass:
    """Do nothing; what an otherwise empty body holds."""

    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Activate:
    """Make the ``when`` of this name active."""

    name: str
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Deactivate:
    """Make the ``when`` of this name inactive."""

    name: str
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Raw:
    """Python statements kept byte for byte; every line of `text` ends with a line feed.

    Only a program that is nothing but one such block may lack the last line feed, as its file did.
    """

    text: str
    span: Span = field(default=NOWHERE, compare=False)


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
    | Break
    | Continue
    | Return
    | Pass
    | Activate
    | Deactivate
    | Raw
)
Body = tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Import:
    """``import "dance"``: a library, or everything that the Python file ``dance.py`` defines."""

    module: str
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Setup:
    """``robot(world="line")``: how the robot is created, where its defaults will not do."""

    arguments: tuple[Expression, ...] = ()
    keywords: tuple[Keyword, ...] = ()
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Def:
    """A function of the user's."""

    name: str
    parameters: tuple[str, ...]
    body: Body
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class When:
    """What is done while a state is active; with a condition the state follows the condition."""

    name: str
    condition: Expression | None
    body: Body
    comment: str | None = None
    span: Span = field(default=NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Main:
    """The statements of ``main``, which run after all others of the top level."""

    body: Body
    span: Span = field(default=NOWHERE, compare=False)


Item = Statement | Import | Setup | Def | When


@dataclass(frozen=True, slots=True)
class Program:
    """A whole program.

    Args:
        items: the top level, in order, without `main`.
        main: written last.
        ending: comments and blank lines after `main`.
        python: the Python it was read from, where `to_python` would spell it otherwise or name
            another robot.
    """

    items: tuple[Item, ...] = ()
    main: Main | None = None
    ending: tuple[Comment | Blank, ...] = ()
    python: str | None = field(default=None, compare=False)
    span: Span = field(default=NOWHERE, compare=False)

    @property
    def functions(self) -> dict[str, Def]:
        """The user's functions by name; of several of one name, the last."""
        return {item.name: item for item in self.items if type(item) is Def}

    @property
    def whens(self) -> dict[str, When]:
        """The ``when``s by name; of several of one name, the last."""
        return {item.name: item for item in self.items if type(item) is When}


Node = Item | Main | Branch | Else | Expression | Keyword | Program


def set_by(node: Item | Main) -> str | None:
    """The variable that a statement itself sets, if any."""
    match node:
        case Assign(target=Name(name=name)) | ForEach(target=Name(name=name)):
            return name
        case ForRange(target=Name(name=name)):
            return name
    return None


def _if_bodies(node: If) -> tuple[Body, ...]:
    found = tuple(branch.body for branch in node.branches)
    return found if node.otherwise is None else (*found, node.otherwise.body)


def _own_body(node: Any) -> tuple[Body, ...]:
    return (node.body,)


_BODIES: dict[type, Callable[[Any], tuple[Body, ...]]] = {
    If: _if_bodies,
    While: _own_body,
    Repeat: _own_body,
    ForEach: _own_body,
    ForRange: _own_body,
    Def: _own_body,
    When: _own_body,
    Main: _own_body,
}


def bodies(node: Item | Main) -> tuple[Body, ...]:
    """The bodies right inside a statement or an item of the top level, in order."""
    get = _BODIES.get(type(node))
    return () if get is None else get(node)


def statements(body: tuple[Item, ...]) -> Iterator[Item]:
    """Every statement of a body and of the bodies within it, in order of the text."""
    ahead: list[Item] = list(reversed(body))
    while ahead:
        statement = ahead.pop()
        yield statement
        for inner in reversed(bodies(statement)):
            ahead.extend(reversed(inner))


def _range_parts(node: ForRange) -> tuple[Expression, ...]:
    found = (node.target, node.start, node.stop)
    return found if node.step is None else (*found, node.step)


def _optional(value: Expression | None) -> tuple[Expression, ...]:
    return () if value is None else (value,)


def _arguments(node: Any) -> tuple[Expression, ...]:
    if not node.keywords:
        return cast("tuple[Expression, ...]", node.arguments)
    return (*node.arguments, *(keyword.value for keyword in node.keywords))


_EXPRESSIONS: dict[type, Callable[[Any], tuple[Expression, ...]]] = {
    Perform: lambda node: (node.call,),
    Assign: lambda node: (node.target, node.value),
    If: lambda node: tuple(branch.condition for branch in node.branches),
    While: lambda node: (node.condition,),
    Repeat: lambda node: (node.count,),
    ForEach: lambda node: (node.target, node.values),
    ForRange: _range_parts,
    Return: lambda node: _optional(node.value),
    When: lambda node: _optional(node.condition),
    Setup: _arguments,
}
_OPERANDS: dict[type, Callable[[Any], tuple[Expression, ...]]] = {
    Call: _arguments,
    SkillCall: _arguments,
    List: lambda node: node.items,
    Index: lambda node: (node.value, node.index),
    Unary: lambda node: (node.operand,),
    Binary: lambda node: (node.left, node.right),
    Compare: lambda node: node.operands,
}


def expressions(node: Item | Main) -> tuple[Expression, ...]:
    """The expressions that a statement itself holds, without those of the bodies within it."""
    get = _EXPRESSIONS.get(type(node))
    return () if get is None else get(node)


def within(expression: Expression) -> list[Expression]:
    """An expression and every expression inside it."""
    found = [expression]
    for node in found:
        get = _OPERANDS.get(type(node))
        if get is not None:
            found.extend(get(node))
    return found
