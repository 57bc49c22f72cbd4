"""What happens in a run, as its log tells it: short tuples that begin with an `Op`.

Numbers of nodes are indexes of `Instrumented.nodes`; values are snapshots (`snapshots.snapshot`).
"""

from enum import IntEnum
from typing import Annotated, Any, Union

import msgspec
from msgspec import Meta, Raw

Event = tuple[Any, ...]
#: Functions of devices that only read; all others are commands.
QUESTIONS = frozenset({"read", "detect"})


class Op(IntEnum):
    """What an event says; behind it, what follows in the tuple."""

    #: ticks: the time from here on; the first event of each batch.
    AT = 0
    #: ticks: so much time has passed.
    PASSED = 1
    #: node, whether it was true.
    CONDITION = 2
    #: node, value: of an operand of a condition.
    OPERAND = 3
    #: node, value: what a call returned.
    RESULT = 4
    #: node, value, identity of a list or 0: a variable was written. Of several variables at once,
    #: their values in a list, 0, and a list of identities if any of them is a list.
    WRITE = 5
    #: node, value: the next turn of a `for` loop. Behind them a list of identities, if needed.
    TURN = 6
    #: node: one of the program's functions is about to be called.
    CALLS = 7
    #: node, values of the parameters. Behind them a list of identities, if one is a list.
    ENTER = 8
    #: node.
    LEAVE = 9
    #: node, value.
    RETURN = 10
    #: node: a `break`, `continue` or `pass`.
    JUMP = 11
    #: name, arguments: a skill begins.
    SKILL = 12
    #: name: it ends.
    SKILL_END = 13
    #: device, function, arguments.
    COMMAND = 14
    #: device, value.
    READING = 15
    #: skill, device: the skill had no effect.
    MISSING = 16
    #: node of a loop, turns, ticks: as many more turns as the one before, in so much time.
    REPEATED = 17
    #: events: the program did more at one moment than the log keeps.
    GAP = 18
    #: name, value: a message to other robots.
    SENT = 19
    #: node: its variables have been deleted.
    GONE = 20
    #: identity, value: a list contains something else than what was last said of it, because a
    #: list in it has changed, or by a function that is no part of the program.
    CONTENTS = 21
    #: depth of calls, line of the function or 0, pairs of a name and a value, identities, whether
    #: it is the innermost call: all variables, from time to time and where events are missing; one
    #: event for each call, from the outermost to the innermost.
    VARIABLES = 22


_Count = Annotated[int, Meta(ge=0, le=2**32 - 1)]
_Identity = Annotated[int, Meta(ge=0)]
_Identities = list[_Identity]
_Values = list[Raw]
#: What follows each operation, and what may follow that. Values are not looked at.
_FIELDS: dict[Op, tuple[tuple[Any, ...], tuple[Any, ...]]] = {
    Op.AT: ((_Count,), ()),
    Op.PASSED: ((_Count,), ()),
    Op.CONDITION: ((_Count, bool), ()),
    Op.OPERAND: ((_Count, Raw), ()),
    Op.RESULT: ((_Count, Raw), ()),
    Op.WRITE: ((_Count, Raw, _Identity), (_Identities,)),
    Op.TURN: ((_Count, Raw), (_Identities,)),
    Op.CALLS: ((_Count,), ()),
    Op.ENTER: ((_Count, _Values), (_Identities,)),
    Op.LEAVE: ((_Count,), ()),
    Op.RETURN: ((_Count, Raw), ()),
    Op.JUMP: ((_Count,), ()),
    Op.SKILL: ((str, _Values), ()),
    Op.SKILL_END: ((str,), ()),
    Op.COMMAND: ((str, str, _Values), ()),
    Op.READING: ((str, Raw), ()),
    Op.MISSING: ((str, str), ()),
    Op.REPEATED: ((_Count, _Count, _Count), ()),
    Op.GAP: ((), ()),
    Op.SENT: ((str, Raw), ()),
    Op.GONE: ((_Count,), ()),
    Op.CONTENTS: ((_Identity, Raw), ()),
    Op.VARIABLES: ((_Count, _Count, list[tuple[str, Raw]], _Identities, bool), ()),
}


def _form(op: Op) -> type:
    """The form in which the events of an operation are sent."""
    needed, optional = _FIELDS[op]
    fields: list[Any] = [(f"needed{index}", kind) for index, kind in enumerate(needed)]
    fields += [(f"optional{index}", kind | None, None) for index, kind in enumerate(optional)]
    return msgspec.defstruct(
        op.name, fields, tag=int(op), array_like=True, forbid_unknown_fields=True, gc=False
    )


_decode_batch = msgspec.msgpack.Decoder(list[Union[tuple(map(_form, Op))]]).decode  # type: ignore[misc] # noqa: UP007 - made here


def batch_problem(events: bytes) -> str:
    """What is wrong with the form of a batch of events, encoded with msgpack; "" for nothing."""
    try:
        _decode_batch(events)
    except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
        return str(error)
    return ""
