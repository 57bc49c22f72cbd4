"""What a program was busy with: a long statement, or a wait for something."""

from learnblock.i18n import Phrase
from learnblock.why.causes import Causes
from learnblock.why.history import CalledSkill, EventHistory
from learnblock.why.inquiry import Inquiry

#: The number of last decisions that are searched for the smallest distance.
_RECENT = 400


class Waits:
    """Tells what the program was busy with.

    Args:
        inquiry: the question, and its answer so far.
        causes: tells why something happened.
    """

    def __init__(self, inquiry: Inquiry, *, causes: Causes) -> None:
        self._history: EventHistory = inquiry.history
        self._readings = inquiry.readings
        self._position = inquiry.position
        self._draft = inquiry.draft
        self._causes = causes

    def busy(self, until: int) -> bool:
        """Tell which long statement the program was in, if it was in one."""
        use = self._position.running(until)
        if use is None:
            return self._waited(until)
        self.say_busy(use)
        return True

    def say_busy(self, use: CalledSkill) -> None:
        """Tell how long a statement kept the program from doing anything else."""
        since = round(self._history.time(use.begun), 2)
        end = round(self._position.end(use), 2)
        call = self._position.call_of(use)
        self._draft.say("why-busy", call, use.begun, since=since, until=end)

    def _waited(self, until: int) -> bool:
        """Tell which `wait until` the program was in, if it was in one."""
        question = self._position.waiting(until)
        if question < 0:
            return False
        number = self._history.number(question)
        self._draft.say(
            "why-waiting",
            number,
            question,
            facts=self._readings.summary(question),
            closest=self.closest(self._history.events_of(number, 0, until)),
        )
        self._causes.condition(question)
        self._causes.finish()
        return True

    def closest(self, decisions: list[int]) -> Phrase | str:
        """The smallest distance that some conditions asked about, in words; "" if none did."""
        near = self._readings.closest(decisions[-_RECENT:])
        if near is None:
            return ""
        return Phrase("why-closest", mm=round(near[0]), time=round(self._history.time(near[2]), 2))
