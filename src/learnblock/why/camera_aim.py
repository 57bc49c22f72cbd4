"""Where the camera looked, and who turned it there."""

from learnblock.why.history import EventHistory
from learnblock.why.inquiry import Inquiry
from learnblock.why.wording import blocks, value_phrase

#: What skills need whose answer depends on where the camera looks.
_NEEDS = frozenset({"Camera", "black-line", "red-line", "blue-line", "Camera:emotions"})


class CameraAim:
    """Tells who set the angle of the camera in one run.

    Args:
        inquiry: the question, and its answer so far.
    """

    def __init__(self, inquiry: Inquiry) -> None:
        self._history: EventHistory = inquiry.history
        self._slices = inquiry.slices
        self._draft = inquiry.draft

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
        use = self._history.own_use(command)
        if use and use.node >= 0:
            angle = self._history.arguments(command)[0]
            self._draft.say("why-camera", use.node, command, angle=value_phrase(angle))
