"""What a component offers: operations with the types of what they take and give."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property
from typing import Any

from learnblock.errors import IceEncodingError
from learnblock.ice.encoding import Reader, Writer
from learnblock.ice.types import BOOL, STRING, Refusal, Type, writing
from learnblock.ice.types import Sequence as SequenceType


class Mode(IntEnum):
    """How an operation is announced on the wire."""

    NORMAL = 0
    #: Of old, what changes nothing; the operations of every object still say it.
    NONMUTATING = 1
    #: Twice does no more than once, so that a lost call may be made again.
    IDEMPOTENT = 2


@dataclass(frozen=True, slots=True)
class Operation:
    """One operation.

    Args:
        name: as Slice calls it.
        takes: the types of what it takes.
        gives: those of what it gives: out parameters in their order, then what it returns.
        mode: both ends have to say the same, or the call is refused.
        refuses: the user exceptions it may raise.
    """

    name: str
    takes: tuple[Type, ...] = ()
    gives: tuple[Type, ...] = ()
    mode: Mode = Mode.NORMAL
    refuses: tuple[Refusal, ...] = ()


@dataclass(frozen=True)
class Interface:
    """An interface.

    Args:
        type_id: its name, such as ``::RoboCompLaser::Laser``.
        operations: what it offers.
    """

    type_id: str
    operations: tuple[Operation, ...]

    @cached_property
    def type_ids(self) -> tuple[str, ...]:
        """The names of all that it is."""
        return tuple(sorted(("::Ice::Object", self.type_id)))

    def operation(self, name: str) -> Operation:
        """The operation of that name, also one that every object has.

        Raises:
            KeyError: there is none.
        """
        return self._by_name[name]

    @cached_property
    def _by_name(self) -> Mapping[str, Operation]:
        return {one.name: one for one in (*OBJECT, *self.operations)}


#: The operations of every object.
OBJECT = (
    Operation("ice_ping", mode=Mode.NONMUTATING),
    Operation("ice_isA", takes=(STRING,), gives=(BOOL,), mode=Mode.NONMUTATING),
    Operation("ice_id", gives=(STRING,), mode=Mode.NONMUTATING),
    Operation("ice_ids", gives=(SequenceType(STRING),), mode=Mode.NONMUTATING),
)


def write_all(writer: Writer, types: Sequence[Type], values: Sequence[Any]) -> None:
    """Write parameters.

    Raises:
        IceEncodingError: they are not of these types, or not so many.
    """
    if len(types) != len(values):
        raise IceEncodingError(f"{len(types)} values are expected, not {len(values)}")
    for type_, value in zip(types, values, strict=True):
        with writing(type_, value):
            type_.write(writer, value)


def read_all(reader: Reader, types: Sequence[Type]) -> tuple[Any, ...]:
    """Read parameters, and nothing else.

    Raises:
        IceEncodingError: they are not there.
    """
    values = tuple(type_.read(reader) for type_ in types)
    reader.end()
    return values
