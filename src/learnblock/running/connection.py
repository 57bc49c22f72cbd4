"""A connection to a real robot without a program: for looking at it, trying it and measuring it."""

import threading
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from learnblock.client import Client
from learnblock.devices import Base
from learnblock.errors import LearnBlockError, RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots import RobotEntry
from learnblock.running.hands import Action, Hands, InterruptedActionError
from learnblock.running.program_run import monitor_of
from learnblock.runtime.containment.driver import give_up

if TYPE_CHECKING:
    from learnblock.monitor import Monitor

#: Seconds between two looks at the link while nothing is done.
LOOK = 0.1


class RobotConnection:
    """A driver that runs as it does for a program: in its own thread, with its rights only.

    The motors stop when an action ends or is halted, when the connection is closed, and when the
    driver fails; if this process is killed, as after a program (see `learnblock.robots.guardian`).

    Args:
        robot: the robot.
        chosen: settings that override those in the user's file.
        on_change: called from the connection's thread when it is connected, when an action begins
            or ends, and when the connection has ended.
    """

    def __init__(
        self, robot: RobotEntry, chosen: Mapping[str, Any], on_change: Callable[[], object]
    ) -> None:
        self.robot = robot
        self.chosen = chosen
        #: The robot as the page shows it, once it is connected.
        self.monitor: Monitor | None = None
        #: The robot, once it is connected.
        self.client: Client | None = None
        #: The name of the action that is under way; empty if there is none.
        self.doing = ""
        #: Why the connection has ended or the last action failed; None if nothing went wrong.
        self.problem: Phrase | None = None
        self.ended = threading.Event()
        self._on_change = on_change
        self._closing = threading.Event()
        self._halting = threading.Event()
        #: The newest order that has not begun, with the name of its action.
        self._order: tuple[str, Action] | None = None
        self._changed = threading.Condition()

    def start(self) -> None:
        """Begin to connect, in a thread."""
        threading.Thread(target=self._serve, name="connection", daemon=True).start()

    def order(self, name: str, action: Action) -> None:
        """Do something; what is under way is halted first."""
        with self._changed:
            self._order = name, action
            self._halting.set()
            self._changed.notify()

    def halt(self) -> None:
        """Stop what is under way, and the motors."""
        self.order("", _rest)

    def close(self) -> None:
        """Begin to disconnect; `ended` is set once the motors have stopped."""
        self._closing.set()
        self.halt()

    def give_up(self) -> None:
        """Count as ended: the driver does not come back, and its thread can't be ended."""
        self.problem = RobotConnectionError("connect-given-up").phrase
        self.ended.set()

    @property
    def closing(self) -> bool:
        """Whether it has been closed, or has ended by itself."""
        return self._closing.is_set() or self.ended.is_set()

    def _serve(self) -> None:
        try:
            self._contained()
        except Exception as error:  # noqa: BLE001 - a driver may raise any exception
            self.problem = _reason(error)
        finally:
            self.doing = ""
            self.ended.set()
            self._on_change()

    def _contained(self) -> None:
        kind = self.robot.load()
        give_up(kind.known_rights())
        client = kind.hosted(dict(self.chosen), {})
        try:
            if self._closing.is_set():
                return
            self.client, self.monitor = client, monitor_of(client)
            self._on_change()
            self._obey(client)
        finally:
            # It stops the motors, then disconnects.
            client.stop()

    def _obey(self, client: Client) -> None:
        hands = Hands(client, self._halting)
        while not self._closing.is_set():
            client.require_link()
            if order := self._taken():
                self._do(hands, *order)

    def _taken(self) -> tuple[str, Action] | None:
        """The newest order, after a short wait for it."""
        with self._changed:
            self._changed.wait_for(lambda: self._order is not None, LOOK)
            order, self._order = self._order, None
            # A halt from now on applies to this order.
            self._halting.clear()
            return order

    def _do(self, hands: Hands, name: str, action: Action) -> None:
        self.doing, self.problem = name, None
        self._on_change()
        try:
            action(hands)
        except InterruptedActionError:
            pass
        except LearnBlockError as error:
            hands.client.require_link()
            self.problem = error.phrase
        finally:
            _stop(hands.client)
            self.doing = ""
        self._on_change()


def _rest(hands: Hands) -> None:
    """Do nothing; the motors stop after every action."""


def _stop(client: Client) -> None:
    for _, device in client.devices():
        if isinstance(device, Base):
            device.stop()


def _reason(error: Exception) -> Phrase:
    if isinstance(error, LearnBlockError):
        return error.phrase
    reason = Phrase(f"{type(error).__name__}: {error}")
    if isinstance(error, PermissionError):
        # Its author may not know of the fence.
        reason = Phrase("run-driver-refused", reason=reason)
    return RobotConnectionError("run-robot-not-created", reason=reason).phrase
