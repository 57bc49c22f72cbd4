"""The interface of a component: operations with the types of parameters and results."""

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
    """The mode of an operation in Ice's protocol."""

    NORMAL = 0
    #: The old mode of operations that change nothing; those of every object still use it.
    NONMUTATING = 1
    #: Repeating a call is harmless, so that a lost call may be repeated.
    IDEMPOTENT = 2


@dataclass(frozen=True, slots=True)
class Operation:
    """One operation.

    Args:
        name: its name in Slice.
        takes: the types of its parameters.
        gives: the types of its results: out parameters in their order, then the return value.
        mode: must be the same at both ends, or the call is refused.
        refuses: the user exceptions that it may raise.
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
        operations: its operations.
    """

    type_id: str
    operations: tuple[Operation, ...]

    @cached_property
    def type_ids(self) -> tuple[str, ...]:
        """The names of all interfaces that it includes."""
        return tuple(sorted(("::Ice::Object", self.type_id)))

    def operation(self, name: str) -> Operation:
        """The operation with this name, including those of every object.

        Raises:
            KeyError: there is no such operation.
        """
        return self._by_name[name]

    @cached_property
    def _by_name(self) -> Mapping[str, Operation]:
        return {operation.name: operation for operation in (*OBJECT, *self.operations)}


#: The operations of every object.
OBJECT = (
    Operation("ice_ping", mode=Mode.NONMUTATING),
    Operation("ice_isA", takes=(STRING,), gives=(BOOL,), mode=Mode.NONMUTATING),
    Operation("ice_id", gives=(STRING,), mode=Mode.NONMUTATING),
    Operation("ice_ids", gives=(SequenceType(STRING),), mode=Mode.NONMUTATING),
)


def write_all(writer: Writer, types: Sequence[Type], values: Sequence[Any]) -> None:
    """Encode parameters.

    Raises:
        IceEncodingError: their number or types are wrong.
    """
    if len(types) != len(values):
        raise IceEncodingError("ice-value-count", expected=len(types), given=len(values))
    for type_, value in zip(types, values, strict=True):
        with writing(type_, value):
            type_.write(writer, value)


def read_all(reader: Reader, types: Sequence[Type]) -> tuple[Any, ...]:
    """Decode parameters, and check that nothing else follows.

    Raises:
        IceEncodingError: the data does not contain them.
    """
    values = tuple(type_.read(reader) for type_ in types)
    reader.end()
    return values
