"""The places of a program that its log speaks of: calls, conditions, loops, assignments."""

from enum import StrEnum

import msgspec


class Kind(StrEnum):
    """What a node is in the program."""

    CALL = "call"
    #: A variable that a condition reads.
    NAME = "name"
    #: ``.active`` or ``.time`` of a `when`.
    STATE = "state"
    IF = "if"
    WHILE = "while"
    FOR = "for"
    #: The condition of a `when`.
    WHEN = "when"
    #: The condition of `wait until`.
    UNTIL = "until"
    FUNCTION = "function"
    RETURN = "return"
    BREAK = "break"
    CONTINUE = "continue"
    PASS = "pass"  # noqa: S105 - a statement of Python
    ASSIGN = "assign"


#: The nodes whose event says whether a condition was true.
CONDITIONS = frozenset({Kind.IF, Kind.WHILE, Kind.WHEN, Kind.UNTIL})
LOOPS = frozenset({Kind.WHILE, Kind.FOR})


class Node(msgspec.Struct, frozen=True, array_like=True):
    """A place of the program; its number is its index in `Instrumented.nodes`.

    Args:
        kind: what it is.
        line: the line of the program's Python where it begins.
        end: the line where it ends.
        text: its Python, shortened.
        last: the number of the last node inside it; its own if there is none.
        control: the number of the condition or loop that it is in; -1 for none.
        branch: whether it runs where that condition is true.
        function: the number of the function that it is in; -1 for the program itself.
        name: of the function called or defined, or of the variable written; else "".
        base: the name before the dot of a call, such as ``robot``; else "".
        reads: the variables that it reads.
        writes: the variables that it writes.
        parameters: those of a function.
        is_when: whether a function is the body of a `when`.
        first: the line where Python says that a function begins, which is its decorator's.
    """

    kind: Kind
    line: int
    end: int
    text: str
    last: int
    control: int = -1
    branch: bool = True
    function: int = -1
    name: str = ""
    base: str = ""
    reads: tuple[str, ...] = ()
    writes: tuple[str, ...] = ()
    parameters: tuple[str, ...] = ()
    is_when: bool = False
    first: int = 0
