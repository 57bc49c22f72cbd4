"""Where the camera looked, and who turned it there."""

from learnblock.why.history import History
from learnblock.why.sentences import Telling
from learnblock.why.slicing import Slices
from learnblock.why.wording import blocks, value_phrase

#: What skills need whose answer depends on where the camera looks.
_NEEDS = frozenset({"Camera", "black-line", "red-line", "blue-line", "Camera:emotions"})


class Camera:
    """Tells who set the angle of the camera in one run.

    Args:
        slices: of the run.
        telling: the answer.
    """

    def __init__(self, slices: Slices, telling: Telling) -> None:
        self._history: History = slices.history
        self._slices = slices
        self._telling = telling

    def turned(self, event: int) -> int:
        """The command that set the angle, if a condition asked the camera; -1 if none did."""
        uses_camera = any(
            use and (block := blocks().get(use.name)) and _NEEDS.intersection(block.needs)
            for part in self._slices.parts(event)
            for use in (self._history.skills.get(part),)
        )
        return self._history.last_of(self._slices.of_camera, event) if uses_camera else -1

    def tell(self, command: int) -> None:
        """Tell which line set the angle."""
        use = self._history.skills.get(command)
        while use and use.within:
            use = use.within
        if use and use.node >= 0:
            angle = self._history.events[command][3][0]
            self._telling.say("why-camera", use.node, command, angle=value_phrase(angle))
