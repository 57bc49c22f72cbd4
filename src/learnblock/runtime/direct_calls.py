"""The calls of a program in the thread of its host, which need no message."""

from typing import Any

from learnblock.runtime.conversation import Conversation
from learnblock.runtime.hosted_robot import HostedRobot
from learnblock.runtime.recorder import Recorder


class DirectCalls:
    """What is done at once for a program in the thread of its host; see `AtOnce`.

    Args:
        robot: the program's robot, which is simulated: no time passes while the program runs.
        recorder: its recorder.
        conversation: the conversation with the program.
    """

    def __init__(self, robot: HostedRobot, recorder: Recorder, conversation: Conversation) -> None:
        self.note = recorder.note
        self.note_call = recorder.note_call
        self._call = robot.call
        self._conversation = conversation

    def obey(self, device: int, function: str, args: tuple[Any, ...]) -> bool:
        try:
            self._call(device, function, args)
        except Exception as error:  # noqa: BLE001 - it ends the run as soon as the host has a turn
            self._conversation.fail(error)
            return False
        return True

    def answer(self, device: int, function: str, args: tuple[Any, ...]) -> Any:
        return self._conversation.copied(self._call(device, function, args))
