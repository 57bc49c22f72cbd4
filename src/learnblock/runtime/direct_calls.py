"""The calls of a program in the thread of its host, which need no message."""

import sys
from collections.abc import Callable
from threading import get_ident
from typing import Any

from learnblock.runtime.conversation import Conversation
from learnblock.runtime.hosted_robot import HostedRobot
from learnblock.runtime.messages import Answer, Failed
from learnblock.runtime.recorder import Recorder
from learnblock.runtime.waiting import Parking


class DirectCalls:
    """What is done at once for a program in the thread of its host; see `AtOnce`.

    Args:
        robot: the program's robot, which is simulated: no time passes while the program runs.
        recorder: its recorder.
        conversation: the conversation with the program.
        wait: lets steps of its world pass; None if others wait there, too, or somebody looks.
        parking: lets it wait for a world with others; None if it has a world alone, or as above.
    """

    def __init__(
        self,
        robot: HostedRobot,
        recorder: Recorder,
        conversation: Conversation,
        wait: Callable[[int], int | None] | None = None,
        parking: Parking | None = None,
    ) -> None:
        self.note = recorder.note
        self.note_call = recorder.note_call
        self._call = robot.call
        self._conversation = conversation
        self._wait = wait
        self._parking = parking
        self._write_noted = recorder.write_noted
        self._thread = get_ident()

    def obey(self, device: int, function: str, args: tuple[Any, ...]) -> bool:
        try:
            self._call(device, function, args)
        except Exception as error:  # noqa: BLE001 - it ends the run as soon as the host has a turn
            self._conversation.fail(error)
            return False
        return True

    def answer(self, device: int, function: str, args: tuple[Any, ...]) -> Any:
        return self._conversation.copied(self._call(device, function, args))

    def wait(self, steps: int) -> int | None:
        if self._wait is None or get_ident() != self._thread:
            return None
        self._write_noted()
        # The world runs no line of the program.
        tracer = sys.gettrace()
        sys.settrace(None)
        try:
            return self._wait(steps)
        except Exception as error:  # noqa: BLE001 - as above
            self._conversation.fail(error)
            return None
        finally:
            sys.settrace(tracer)

    def sleep(self, steps: int, reads: tuple[int, ...]) -> Answer | Failed | None:
        if self._parking is None or get_ident() != self._thread:
            return None
        self._write_noted()
        return self._parking.wait(steps, reads)
