"""The way to a brick with ev3dev on which our agent runs."""

from collections.abc import Callable

from learnblock.robots.ev3 import lines
from learnblock.robots.ev3.brick import NoSuchWayError, State, Word
from learnblock.robots.ev3.link import Link
from learnblock.robots.ev3.network import dial, hang_up
from learnblock.robots.ev3.settings import Settings


class AgentLink(Link):
    """Lines of JSON over TCP, one for each word and each answer.

    Args:
        settings: of the robot.
        told: is given each new state.

    Raises:
        NoSuchWayError: no agent answers there.
        RobotConnectionError: it does not know our secret, or has another client.
    """

    def __init__(self, settings: Settings, told: Callable[[State], None]) -> None:
        super().__init__(f"{settings.address}:{settings.agent_port}", told)
        self._begun = b""
        self._socket = dial(settings.address, settings.agent_port, settings.patience)
        try:
            self._introduce(settings)
        except BaseException:
            self._socket.close()
            raise

    def exchange(self, word: Word) -> State:
        self._put(lines.spoken(word))
        return self._answered()

    def hang_up(self) -> None:
        hang_up(self._socket)

    def _introduce(self, settings: Settings) -> None:
        try:
            greeting = lines.greeting(self._line())
        except (OSError, ValueError) as error:
            raise NoSuchWayError(
                f"what answers at {self.where} is not LearnBlock's agent:"
                " learnblock robots setup ev3"
            ) from error
        self._put(lines.introduction(settings, greeting.nonce))
        self._answered()

    def _answered(self) -> State:
        answer = lines.answer(self._line(), self.where)
        self.speaks = answer.speaks
        assert answer.state is not None  # noqa: S101 - `lines.answer` refuses an answer without
        return answer.state

    def _put(self, line: bytes) -> None:
        self._socket.sendall(line + b"\n")

    def _line(self) -> bytes:
        """The next line that comes."""
        while b"\n" not in self._begun:
            if len(self._begun) > lines.LONGEST_LINE:
                raise ValueError("a line without end")
            data = self._socket.recv(lines.LONGEST_LINE)
            if not data:
                raise ConnectionResetError("closed by the brick")
            self._begun += data
        line, _, self._begun = self._begun.partition(b"\n")
        return line
