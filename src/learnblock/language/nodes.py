"""The syntax tree in which the three notations meet: one value for each rule of the grammar.

A node knows where it was written (`span`), which does not count when two trees are compared.
Comments and blank lines count: `Comment` and `Blank` stand among the statements, and a statement
keeps the comment at the end of its line. The rules of layout are those of `layout`: a blank line
that every program has there, such as the one before a ``def``, is not in the tree.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple


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
    """``import "dance"``: everything that the Python file ``dance.py`` defines."""

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
        python: the Python it was read from, where `to_python` would spell it otherwise.
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


def bodies(node: Item | Main) -> Iterator[Body]:
    """The bodies right inside a statement or an item of the top level, in order."""
    if isinstance(node, If):
        for branch in node.branches:
            yield branch.body
        if node.otherwise is not None:
            yield node.otherwise.body
    elif isinstance(node, While | Repeat | ForEach | ForRange | Def | When | Main):
        yield node.body


def statements(body: tuple[Item, ...]) -> Iterator[Item]:
    """Every statement of a body and of the bodies within it, in order of the text."""
    for statement in body:
        yield statement
        for inner in bodies(statement):
            yield from statements(inner)


def expressions(node: Item | Main | Branch) -> Iterator[Expression]:
    """The expressions that a statement itself holds, without those of the bodies within it."""
    match node:
        case Perform(call=call):
            yield call
        case Assign(target=target, value=value):
            yield target
            yield value
        case If(branches=branches):
            yield from (branch.condition for branch in branches)
        case While(condition=value) | Repeat(count=value):
            yield value
        case ForEach(target=target, values=value):
            yield target
            yield value
        case ForRange(target=target, start=start, stop=stop, step=step):
            yield target
            yield start
            yield stop
            if step is not None:
                yield step
        case Return(value=value) | When(condition=value) if value is not None:
            yield value
        case Setup(arguments=arguments, keywords=keywords):
            yield from arguments
            yield from (keyword.value for keyword in keywords)
        case _:
            return


def operands(expression: Expression) -> tuple[Expression, ...]:
    """The expressions right inside an expression, in order of the text."""
    found: tuple[Expression, ...] = ()
    match expression:
        case Call(_, arguments, keywords) | SkillCall(_, arguments, keywords):
            found = arguments + tuple(keyword.value for keyword in keywords)
        case List(items=found) | Compare(operands=found):
            pass
        case Index(value=value, index=index):
            found = (value, index)
        case Unary(operand=operand):
            found = (operand,)
        case Binary(left=left, right=right):
            found = (left, right)
    return found


def within(expression: Expression) -> Iterator[Expression]:
    """An expression and every expression inside it, in order of the text."""
    yield expression
    for operand in operands(expression):
        yield from within(operand)
