"""The connection to a Thymio through the device manager of Thymio Suite.

`tdmclient` writes and reads the messages. Our own wire carries them, since the threads of
`tdmclient`'s connections end only when the other side closes.
"""

import struct
import threading
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import tdmclient

from learnblock.errors import RobotConnectionError
from learnblock.robots.thymio.link import GarbledError, ThymioLink
from learnblock.robots.thymio.node import READ
from learnblock.robots.thymio.program import EVENTS, Event, source
from learnblock.robots.thymio.wires import Wire
from learnblock.timing import MONOTONIC, SteadyClock

#: Seconds between two checks that the Suite still answers.
ASKING = 0.5
_LENGTH = struct.Struct("<I")
#: The maximum number of bytes of a message in the protocol.
_LONGEST = 102_400


#: The messages that `tdmclient` handles; it prints all others into the pupil's output.
_UNDERSTOOD = frozenset(
    {
        tdmclient.ThymioFB.MESSAGE_TYPE_CONNECTION_HANDSHAKE,
        tdmclient.ThymioFB.MESSAGE_TYPE_NODES_CHANGED,
        tdmclient.ThymioFB.MESSAGE_TYPE_REQUEST_COMPLETED,
        tdmclient.ThymioFB.MESSAGE_TYPE_ERROR,
        tdmclient.ThymioFB.MESSAGE_TYPE_COMPILATION_RESULT_FAILURE,
        tdmclient.ThymioFB.MESSAGE_TYPE_COMPILATION_RESULT_SUCCESS,
        tdmclient.ThymioFB.MESSAGE_TYPE_VARIABLES_CHANGED,
    }
)


class Packets:
    """Splits a stream of bytes into packets, each preceded by a 32-bit little-endian length."""

    def __init__(self) -> None:
        self._waiting = b""

    def feed(self, data: bytes) -> Iterator[bytes]:
        """Yield the packets completed by these bytes.

        Raises:
            GarbledError: the data is invalid.
        """
        self._waiting += data
        while len(self._waiting) >= _LENGTH.size:
            (length,) = _LENGTH.unpack_from(self._waiting)
            if length > _LONGEST:
                raise GarbledError(f"a message of {length} bytes")
            end = _LENGTH.size + length
            if len(self._waiting) < end:
                return
            packet, self._waiting = self._waiting[_LENGTH.size : end], self._waiting[end:]
            yield packet


class SuiteLink(ThymioLink):
    """A connection to the first free Thymio of Thymio Suite.

    Raises:
        RobotConnectionError: no Thymio answers or is free, or it does not run our program.
    """

    def __init__(self, wire: Wire, timeout: float, clock: SteadyClock = MONOTONIC) -> None:
        super().__init__(wire, timeout, clock)
        self._packets = Packets()
        self._values: dict[str, tuple[int, ...]] = {}
        self._node: Any = None
        self._poller = threading.Thread(target=self._poll, name="thymio suite", daemon=True)
        try:
            self._client: Any = tdmclient.Client(tdm_transport=self)
            self._client.add_variables_changed_listener(self._note)
            self._reader.start()
            self._prepare()
        except BaseException:
            self.close()
            raise
        self._poller.start()

    def read(self, variable: str) -> tuple[int, ...]:
        self.check()
        return self._values[variable]

    def tell(self, event: Event, *numbers: int) -> None:
        self._node.send_send_events({event.name: list(numbers)})

    def close(self) -> None:
        self._closed.set()
        if self._node is not None and self._lost is None:
            self._try(self._node.send_unlock_node)
        super().close()
        if self._poller.is_alive():
            self._poller.join()

    def send_packet(self, packet: bytes) -> None:
        """Send a message; `tdmclient` calls this.

        Raises:
            RobotConnectionError: the connection is lost.
        """
        self._send(_LENGTH.pack(len(packet)) + packet)

    # Preparing the robot.

    def _prepare(self) -> None:
        self._expect(lambda: bool(self._client.nodes), "thymio-suite-empty")
        self._expect(lambda: self._free() is not None, "thymio-suite-busy")
        self._node = self._free()
        watched = tdmclient.ThymioFB.WATCHABLE_INFO_VARIABLES
        run = tdmclient.ThymioFB.VM_EXECUTION_STATE_COMMAND_RUN
        events = [(event.name, event.size) for event in EVENTS]
        node = self._node
        self._request(node.send_lock_node)
        self._request(node.send_register_events, events)
        self._request(node.send_program, source())
        self._request(node.set_vm_execution_state, run)
        self._request(node.watch_node, watched)
        self._expect(lambda: set(READ) <= set(self._values), "thymio-not-ready")

    def _free(self) -> Any:
        """The first robot that no program is using, or None."""
        free = tdmclient.ThymioFB.NODE_STATUS_AVAILABLE
        return next((node for node in self._client.nodes if node.status == free), None)

    def _request(self, send: Callable[..., None], *arguments: Any) -> None:
        """Send a request and wait for its answer.

        Raises:
            RobotConnectionError: the Suite refuses, or does not answer.
        """
        answers: list[Any] = []
        send(*arguments, request_id_notify=answers.append)
        self._expect(lambda: bool(answers), "thymio-suite-silent")
        if answers[0] is not None:
            raise RobotConnectionError(
                "thymio-suite-refused", place=self.place, code=str(answers[0])
            )

    # Receiving.

    def _take(self, data: bytes) -> None:
        for packet in self._packets.feed(data):
            self._heard = self._clock.now()
            try:
                if _is_understood(packet):
                    self._client.process_message(packet)
            except Exception as error:
                # On invalid data, its reader may raise any error.
                raise GarbledError(f"{type(error).__name__}: {error}") from error

    def _note(self, node: Any, variables: Mapping[str, Any]) -> None:
        if node is not None and self._node in (None, node):
            for name, numbers in variables.items():
                self._values[name] = tuple(numbers if isinstance(numbers, list) else [numbers])

    # Requests.

    def _poll(self) -> None:
        """Send requests regularly, because the Suite sends nothing while no variable changes."""
        watched = tdmclient.ThymioFB.WATCHABLE_INFO_VARIABLES
        while not self._clock.wait(self._closed, ASKING) and self._lost is None:
            self._try(self._node.watch_node, watched)

    def _try(self, send: Callable[..., None], *arguments: Any) -> None:
        try:
            send(*arguments)
        except RobotConnectionError:
            # The next use of the robot raises it again.
            return


def _is_understood(packet: bytes) -> bool:
    """Whether `tdmclient` handles this message."""
    buffer = tdmclient.FlatBuffer()
    buffer.parse(packet, tdmclient.ThymioFB.SCHEMA)
    return getattr(buffer.root, "union_type", None) in _UNDERSTOOD
