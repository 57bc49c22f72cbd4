"""The connection to a brick with ev3dev and LearnBlock's agent."""

from collections.abc import Callable

from learnblock.errors import RobotNotFoundError
from learnblock.robots.ev3 import lines
from learnblock.robots.ev3.brick import State, Word
from learnblock.robots.ev3.link import BrickLink
from learnblock.robots.ev3.network import dial, hang_up
from learnblock.robots.ev3.settings import Settings
from learnblock.timing import MONOTONIC, SteadyClock


class AgentLink(BrickLink):
    """Lines of JSON over TCP, one for each command and each answer.

    Args:
        settings: the robot's settings.
        on_state: called with each new state.
        clock: the clock of its periods and limits.

    Raises:
        RobotNotFoundError: no agent responds at this address.
        RobotConnectionError: the agent has a different secret or another client.
    """

    def __init__(
        self,
        settings: Settings,
        on_state: Callable[[State], None],
        clock: SteadyClock = MONOTONIC,
    ) -> None:
        super().__init__(f"{settings.address}:{settings.agent_port}", on_state, clock)
        self._begun = b""
        self._socket = dial(settings.address, settings.agent_port, settings.patience, clock)
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
            raise RobotNotFoundError("ev3-not-agent", place=self.place) from error
        self._put(lines.introduction(settings, greeting.nonce))
        self._answered()

    def _answered(self) -> State:
        answer = lines.answer(self._line(), self.place)
        self.speaks = answer.speaks
        assert answer.state is not None  # noqa: S101 - `lines.answer` requires one
        return answer.state

    def _put(self, line: bytes) -> None:
        self._socket.sendall(line + b"\n")

    def _line(self) -> bytes:
        """Receive the next line."""
        while b"\n" not in self._begun:
            if len(self._begun) > lines.LONGEST_LINE:
                raise ValueError("the line is too long")
            data = self._socket.recv(lines.LONGEST_LINE)
            if not data:
                raise ConnectionResetError("closed by the brick")
            self._begun += data
        line, _, self._begun = self._begun.partition(b"\n")
        return line
