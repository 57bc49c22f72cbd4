"""A direct connection to a Thymio, over a cable, its radio's dongle, or the network.

It uses the messages, the node description and the assembler of `thymiodirect`, but not its
connection: over TCP it mistakes half a message for a whole one, loops if the other end closes, and
never ends its threads.
"""

import secrets
import threading

from thymiodirect.message import Message

from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots.thymio.frames import Frames, encoded, signed
from learnblock.robots.thymio.link import ThymioLink
from learnblock.robots.thymio.node import AsebaNode
from learnblock.robots.thymio.program import READY, Event
from learnblock.robots.thymio.wires import Wire
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: Seconds between two readings; the robot updates its motors 100 times and its distances 10 times
#: per second.
PERIOD = 0.02
#: Seconds after which a missing answer is requested again.
OVERDUE = 0.25
#: Words of bytecode in one message.
CHUNK = 200
PROTOCOL = 5


class AsebaLink(ThymioLink):
    """A connection in Aseba's binary protocol.

    Raises:
        RobotConnectionError: no Thymio answers, or it does not run our program.
    """

    def __init__(self, wire: Wire, timeout: float, clock: SteadyClock = MONOTONIC) -> None:
        super().__init__(wire, timeout, clock)
        self._frames = Frames()
        self._node: AsebaNode | None = None
        self._values: tuple[int, ...] = ()
        self._begin = 0
        self._token = secrets.randbelow(2000)
        self._ready = False
        self._answered = True
        self._poller = threading.Thread(target=self._poll, name="thymio poller", daemon=True)
        self._reader.start()
        try:
            self._prepare()
        except BaseException:
            self.close()
            raise
        self._poller.start()

    def read(self, variable: str) -> tuple[int, ...]:
        self.check()
        offset, size = self._known().place(variable)
        begin = offset - self._begin
        return self._values[begin : begin + size]

    def tell(self, event: Event, *numbers: int) -> None:
        self._send(encoded(event.number, *numbers))

    def close(self) -> None:
        super().close()
        if self._poller.is_alive():
            self._poller.join()

    # Preparing the robot.

    def _prepare(self) -> None:
        self._send(encoded(Message.ID_LIST_NODES, PROTOCOL))
        self._expect(lambda: self._node is not None, "thymio-no-answer")
        node = self._known()
        self._send(encoded(Message.ID_GET_NODE_DESCRIPTION, node.number, PROTOCOL))
        self._expect(lambda: node.complete, "thymio-not-ready")
        self._require_thymio(node)
        self._upload(node)
        self._expect(lambda: self._ready, "thymio-not-ready")
        self._ask()
        self._expect(lambda: bool(self._values), "thymio-not-ready")

    def _require_thymio(self, node: AsebaNode) -> None:
        if not node.name.startswith("thymio"):
            raise RobotConnectionError("thymio-other-robot", place=self.place, name=node.name)
        if node.lacking:
            raise RobotConnectionError("thymio-too-old", place=self.place)

    def _upload(self, node: AsebaNode) -> None:
        try:
            code = node.bytecode(self._token)
        except LookupError as error:
            raise RobotConnectionError("thymio-too-old", place=self.place) from error
        for begin in range(0, len(code), CHUNK):
            words = code[begin : begin + CHUNK]
            self._send(encoded(Message.ID_SET_BYTECODE, node.number, begin, *words))
        self._send(encoded(Message.ID_RUN, node.number))

    def _known(self) -> AsebaNode:
        assert self._node is not None  # noqa: S101 - `_prepare` waits for it
        return self._node

    # Receiving.

    def _take(self, data: bytes) -> None:
        for message in self._frames.feed(data):
            self._heard = self._clock.now()
            if message.id == Message.ID_NODE_PRESENT and self._node is None:
                self._node = AsebaNode(message.source_node)
            if self._node is not None and message.source_node == self._node.number:
                self._understand(self._node, message)

    def _understand(self, node: AsebaNode, message: Message) -> None:
        if message.id == Message.ID_VARIABLES:
            self._note(node, message)
        elif message.id == READY.number:
            self._greet(message.user_event_arg)
        else:
            node.take(message)

    def _greet(self, words: list[int]) -> None:
        """Record that a program has started: ours, or one of another client of the same hub."""
        if words == [self._token]:
            self._ready = True
        elif self._ready:
            self._lose(Phrase("thymio-taken", place=self.place))

    def _note(self, node: AsebaNode, message: Message) -> None:
        """Store an answer to our own request; a hub also forwards the answers to others."""
        if not node.complete or node.lacking:
            return
        if (message.var_offset, len(message.var_data)) == node.span():
            self._begin, self._values = message.var_offset, tuple(map(signed, message.var_data))
            self._answered = True

    # Requests.

    def _ask(self) -> None:
        self._answered = False
        node = self._known()
        self._send(encoded(Message.ID_GET_VARIABLES, node.number, *node.span()))

    def _poll(self) -> None:
        """Request the readings repeatedly, whenever the last answer has arrived or is overdue."""
        overdue = Deadline.after(OVERDUE, self._clock)
        while not self._clock.wait(self._closed, min(PERIOD, overdue.left)):
            if self._lost is not None:
                return
            if self._answered or overdue.is_over:
                overdue = Deadline.after(OVERDUE, self._clock)
                self._try_to_ask()

    def _try_to_ask(self) -> None:
        try:
            self._ask()
        except RobotConnectionError:
            # The next use of the robot raises it again.
            return
