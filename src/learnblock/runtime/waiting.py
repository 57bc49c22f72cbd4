"""Waiting in a run that nobody watches, for which a program in its host's thread sends nothing."""

import math
from collections.abc import Callable

from learnblock.runtime.conversation import Conversation
from learnblock.runtime.messages import Answer, Failed
from learnblock.runtime.supervision import Supervision
from learnblock.runtime.world import HostedSimulation

#: Steps between two looks at whether the run is ending.
STRIDE = 10


class Waiting:
    """Lets the time of a world pass for its only program, whose run nobody watches.

    Args:
        simulation: the world.
        supervision: that of the program.
        look: looks around during the wait; returns whether the run is ending.
    """

    def __init__(
        self, simulation: HostedSimulation, supervision: Supervision, look: Callable[[], bool]
    ) -> None:
        self._simulation = simulation
        self._supervision = supervision
        self._look = look
        seconds = supervision.seconds
        self._last = math.inf if seconds is None else round(seconds / simulation.dt)

    def wait(self, steps: int) -> int | None:
        """Let so many steps pass; return the world's step counter.

        None if the run ends meanwhile: then the program has to wait as if no time had passed.
        """
        simulation = self._simulation
        wake = simulation.steps + steps
        if wake >= self._last:
            return None
        while simulation.steps < wake and not simulation.is_over:
            if self._look():
                return None
            simulation.advance(min(wake, simulation.steps + STRIDE))
        if simulation.is_over:
            return None
        self._supervision.note_time()
        return wake


class Parking:
    """Lets a program wait for a world that it shares with others: its host has turns meanwhile.

    Args:
        conversation: the conversation with the program.
        park: notes for how many steps it waits, and the devices whose readings it wants then.
    """

    def __init__(
        self, conversation: Conversation, park: Callable[[int, tuple[int, ...]], None]
    ) -> None:
        self._conversation = conversation
        self._park = park
        self._is_parked = False
        self._answer: Answer | Failed | None = None

    def wait(self, steps: int, reads: tuple[int, ...]) -> Answer | Failed | None:
        """Wait in the program; return what `wake` has got, or None if the run ends meanwhile."""
        self._park(steps, reads)
        self._answer, self._is_parked = None, True
        try:
            self._conversation.give_turn()
        finally:
            self._is_parked = False
        return self._answer

    def wake(self, answer: Answer | Failed) -> bool:
        """Have the program go on with this answer; return whether it waits here."""
        if self._is_parked:
            self._answer = answer
            if isinstance(answer, Answer):
                self._answer = Answer(self._conversation.copied(answer.value))
        return self._is_parked
