"""The shapes of the events of a log: which of them have a node, and the content of the others."""

from collections.abc import Sequence

from learnblock.runtime.log.events import Event, Op

#: Operations whose second value is a node of the program.
OF_NODES = frozenset(
    {
        Op.CONDITION,
        Op.OPERAND,
        Op.RESULT,
        Op.WRITE,
        Op.TURN,
        Op.CALLS,
        Op.ENTER,
        Op.LEAVE,
        Op.RETURN,
        Op.JUMP,
        Op.GONE,
    }
)
#: The values after the operation in other events.
_SHAPES: dict[int, tuple[type, ...]] = {
    Op.SKILL: (str, list),
    Op.SKILL_END: (str,),
    Op.COMMAND: (str, str, list),
    Op.READING: (str, object),
    Op.MISSING: (str, str),
    Op.REPEATED: (int, int, int),
    Op.GAP: (),
    Op.SENT: (str, object),
    Op.CONTENTS: (int, object),
    Op.VARIABLES: (int, int, list, list, bool),
}


def require_event(event: Event, nodes: int) -> None:
    """Check the shape of an event: the file may be damaged or forged.

    Args:
        event: one of a log.
        nodes: how many nodes its program has.

    Raises:
        ValueError: it isn't an event of this program.
    """
    if event[0] in OF_NODES:
        number = event[1]
        is_right = type(number) is int and 0 <= number < nodes
    else:
        shape = _SHAPES[event[0]]
        is_right = len(event) == len(shape) + 1 and all(map(isinstance, event[1:], shape))
    if not is_right:
        raise ValueError("no event of this program")


def identities(event: Event) -> Sequence[int]:
    """The identity of each value that an event tells, if it is a list, else 0; in their order."""
    match event:
        case (Op.WRITE, _, _, 0, several):
            return several  # type: ignore[no-any-return] # from the log
        case (Op.WRITE, _, _, identity):
            return (identity,)
        case (Op.TURN | Op.ENTER, _, _, several) | (Op.VARIABLES, _, _, _, several, _):
            return several  # type: ignore[no-any-return] # from the log
    return ()
