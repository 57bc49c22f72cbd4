"""The game of one program's robot, on the host's side."""

from collections.abc import Callable, Mapping
from typing import Any

from learnblock.client.game import Play
from learnblock.errors import LearnBlockError
from learnblock.runtime import messages
from learnblock.runtime.hosted_robot import HostedRobot
from learnblock.runtime.supervision import Supervision


class HostedGame:
    """Answers what a program asks about its game, and does what it says.

    Args:
        robot: the program's robot.
        supervision: that of the program.
        send: sends an answer.
    """

    def __init__(
        self,
        robot: HostedRobot,
        supervision: Supervision,
        send: Callable[[messages.Message], object],
    ) -> None:
        self._robot = robot
        self._supervision = supervision
        self._send = send

    @property
    def handlers(self) -> Mapping[type, Callable[[Any], object]]:
        """What answers each message."""
        return {
            messages.ChangeGame: self.change,
            messages.AskGame: self.answer,
            messages.CollectNews: self.collect,
        }

    def change(self, message: messages.ChangeGame) -> None:
        """Change what counts, or end the game."""
        with self._robot.world.exclusive:
            self._play.change(message.change, message.amount)
        self._supervision.note_call()

    def answer(self, _: messages.AskGame) -> None:
        """Answer with score, lives and time."""
        with self._robot.world.exclusive:
            standing = self._play.standing()
        self._send(messages.Answer(standing))
        self._supervision.note_call()

    def collect(self, _: messages.CollectNews) -> None:
        """Hand over the news that have arrived."""
        with self._robot.world.exclusive:
            news = [*self._play.collect()]
        self._send(messages.Answer(news))
        self._supervision.note_call()

    @property
    def _play(self) -> Play:
        if self._robot.client is None:
            raise LearnBlockError("run-robot-stopped")
        return self._robot.client.game.play
