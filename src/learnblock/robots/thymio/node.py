"""The description of a Thymio: its variables, events and functions."""

from collections.abc import Mapping
from typing import Any

from thymiodirect.assembler import Assembler
from thymiodirect.connection import RemoteNode
from thymiodirect.message import Message

from learnblock.robots.thymio.program import assembly

#: The variables that are read, with their sizes; they are close together in memory, so that one
#: request reads them all.
READ: Mapping[str, int] = {
    "button.backward": 1,
    "button.left": 1,
    "button.center": 1,
    "button.forward": 1,
    "button.right": 1,
    "prox.horizontal": 7,
    "prox.ground.delta": 2,
    "motor.left.target": 1,
    "motor.right.target": 1,
    "motor.left.speed": 1,
    "motor.right.speed": 1,
    "acc": 3,
}


class AsebaNode:
    """A node of Aseba's network, described by a sequence of messages.

    Args:
        number: the node's number.
    """

    def __init__(self, number: int) -> None:
        self.number = number
        self._remote: Any = RemoteNode(number)
        self._expected: tuple[int, int, int] | None = None

    def take(self, message: Message) -> None:
        """Process a message that describes the node; others are ignored."""
        if self.complete:
            return
        if message.id == Message.ID_DESCRIPTION:
            self._begin(message)
        elif message.id == Message.ID_NAMED_VARIABLE_DESCRIPTION:
            self._remote.add_var(message.var_name, message.var_size)
        elif message.id == Message.ID_LOCAL_EVENT_DESCRIPTION:
            self._remote.local_events.append(message.event_name)
        elif message.id == Message.ID_NATIVE_FUNCTION_DESCRIPTION:
            self._remote.native_functions.append(message.fun_name)

    @property
    def name(self) -> str:
        """The kind of node; ``thymio-II`` is a Thymio."""
        return self._remote.name or ""

    @property
    def complete(self) -> bool:
        """Whether everything it announced has been described."""
        remote = self._remote
        return self._expected == (
            len(remote.named_variables),
            len(remote.local_events),
            len(remote.native_functions),
        )

    @property
    def lacking(self) -> list[str]:
        """The required variables that the node does not have."""
        sizes = self._remote.var_size
        return [name for name, size in READ.items() if sizes.get(name) != size]

    def place(self, variable: str) -> tuple[int, int]:
        """The first word of a variable and its number of words."""
        return self._remote.var_offset[variable], self._remote.var_size[variable]

    def span(self) -> tuple[int, int]:
        """The first word of all required variables, and their number of words."""
        offset, length = self._remote.data_span_for_variables(set(READ))
        return offset, length

    def bytecode(self, token: int) -> list[int]:
        """Our program for this node; it sends the token when it starts.

        Raises:
            LookupError: the node lacks something that the program needs.
        """
        try:
            code: list[int] = Assembler(self._remote, assembly(token)).assemble()
        except Exception as error:
            # The assembler has no exception class of its own.
            raise LookupError(str(error)) from error
        return code

    def _begin(self, message: Message) -> None:
        self._remote.name = message.node_name
        self._remote.max_var_size = message.max_var_size
        self._expected = (
            message.num_named_var,
            message.num_local_events,
            message.num_native_fun,
        )
