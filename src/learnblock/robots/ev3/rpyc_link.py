"""The connection to a brick with ev3dev and rpyc 4.1 to 5.3, as the paper used it.

The agent's `serve` is executed on the brick, with python-ev3dev2's motors and sensors. A command
then takes one round trip, instead of one for each attribute of a remote motor; and the motors
stop on the brick when this program is gone.
"""

from collections.abc import Callable
from importlib import resources
from types import ModuleType
from typing import Any

from learnblock.errors import RobotConnectionError, RobotNotFoundError
from learnblock.robots.ev3 import lines
from learnblock.robots.ev3.brick import State, Word
from learnblock.robots.ev3.link import BrickLink
from learnblock.robots.ev3.network import dial, hang_up
from learnblock.robots.ev3.settings import Settings
from learnblock.robots.real import require
from learnblock.timing import MONOTONIC, SteadyClock

#: The maximum number of bytes of a message: an answer, or the traceback of an error.
LARGEST = 1 << 20
#: Seconds within which the slow processor must import python-ev3dev2 and find its devices.
BEGINNING = 20.0
#: The code that starts answering on the brick, unless another program is being served. The file
#: lock ends with the process, and is released when the program has stopped sending.
BEGIN = """
import fcntl, os, tempfile
from ev3dev2.motor import Motor as _Motor
from ev3dev2.sensor import list_sensors as _list_sensors

def begin(line):
    global guard
    lock = open(os.path.join(tempfile.gettempdir(), "learnblock-ev3.lock"), "w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        guard = serve(line, _Motor, _list_sensors, lock.close)
    except BrickError as error:
        lock.close()
        return error.answer()
    except BlockingIOError:
        lock.close()
        return json.dumps(TAKEN)
    return guard.answer("{}")

def answer(line):
    return guard.answer(line)

def end():
    guard.close()
"""


class RpycLink(BrickLink):
    """The agent's commands as calls over rpyc.

    Args:
        settings: the robot's settings.
        on_state: called with each new state.
        clock: the clock of its periods and limits.

    Raises:
        RobotNotFoundError: no rpyc server responds at this address.
        MissingPackageError: rpyc is not installed on this computer.
        RobotConnectionError: the brick has another client, or lacks a motor or python-ev3dev2.
    """

    def __init__(
        self,
        settings: Settings,
        on_state: Callable[[State], None],
        clock: SteadyClock = MONOTONIC,
    ) -> None:
        super().__init__(f"{settings.address}:{settings.rpyc_port}", on_state, clock)
        self._socket = dial(settings.address, settings.rpyc_port, settings.patience, clock)
        try:
            self._rpyc = require("rpyc", "ev3")
            self._connection = self._connected(settings.patience)
            self._answer = self._begin(settings)
        except BaseException:
            self._socket.close()
            raise

    def exchange(self, word: Word) -> State:
        reply = self._asked(self._answer, lines.spoken(word).decode())
        return self._read(reply)

    def farewell(self) -> None:
        self._asked(self._connection.root.eval, "end()")
        self._connection.close()

    def hang_up(self) -> None:
        hang_up(self._socket)

    def _connected(self, timeout: float) -> Any:
        stream = _bounded_stream(self._rpyc)(self._socket)
        try:
            # A classic client would let the brick execute any code on this computer, and needs many
            # round trips to start.
            connection = self._rpyc.connect_stream(
                stream, self._rpyc.core.service.FakeSlaveService, {"sync_request_timeout": timeout}
            )
            connection.ping(timeout=timeout)
            return connection
        except Exception as error:
            raise RobotNotFoundError("ev3-not-rpyc", place=self.place) from error

    def _begin(self, settings: Settings) -> Any:
        agent = resources.files("learnblock.robots.ev3").joinpath("agent.py").read_text("utf-8")
        try:
            slave = self._connection.root
            self._slowly(slave.execute, agent + BEGIN)
            introduction = lines.introduction(settings, "").decode()
            reply = self._slowly(slave.eval, f"begin({introduction!r})")
            answer = slave.eval("answer")
        except Exception as error:
            raise RobotConnectionError(
                "ev3-rpyc-failed", place=self.place, reason=_first_line(error)
            ) from error
        self._read(reply)
        return answer

    def _slowly(self, function: Any, argument: str) -> object:
        """Call a function that may be slow on the brick."""
        doing = self._rpyc.async_(function)(argument)
        doing.set_expiry(BEGINNING)
        # Waits for the result, and raises errors of the brick.
        return doing.value

    def _read(self, answer_line: object) -> State:
        if not isinstance(answer_line, str):
            raise ValueError("not a text")
        answer = lines.answer(answer_line, self.place)
        self.speaks = answer.speaks
        assert answer.state is not None  # noqa: S101 - `lines.answer` requires one
        return answer.state

    def _asked(self, function: Any, *arguments: str) -> object:
        try:
            return function(*arguments)
        except TimeoutError:
            raise
        except Exception as error:
            # EOFError for a cut connection; any other error of rpyc for invalid data.
            if self._socket.fileno() < 0 or isinstance(error, EOFError):
                raise ConnectionResetError(str(error)) from error
            raise ValueError(str(error)) from error


def _bounded_stream(rpyc: ModuleType) -> Any:
    """A stream that, unlike rpyc's, limits the time and the size of a message."""

    class Bounded(rpyc.core.stream.SocketStream):  # type: ignore[misc,name-defined]
        __slots__ = ()

        def read(self, count: int) -> bytes:
            if count > LARGEST:
                raise EOFError("the message is too long")
            data = b""
            while len(data) < count:
                try:
                    piece = self.sock.recv(count - len(data))
                except OSError as error:
                    raise EOFError(str(error)) from error
                if not piece:
                    raise EOFError("closed by the brick")
                data += piece
            return data

    return Bounded


def _first_line(error: Exception) -> str:
    """The first line of an error, without the traceback from the brick."""
    return (str(error).strip() or type(error).__name__).splitlines()[0][:200]
