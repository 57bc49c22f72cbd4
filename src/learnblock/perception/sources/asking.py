"""The components that the user has chosen in place of our detectors."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from learnblock.perception.settings import PerceptionSettings

if TYPE_CHECKING:
    from learnblock.perception.robocomp import Asked


def chosen_components(settings: PerceptionSettings) -> "Mapping[str, Asked]":
    """The detectors that use these components, by name; nothing is sent yet."""
    if not (settings.apriltag or settings.emotionrecognition):
        return {}
    # Few users choose any.
    from learnblock.perception.robocomp import AskedEmotions, AskedTags, PixelOrder  # noqa: PLC0415

    order = None if settings.layout == "auto" else PixelOrder(settings.layout)
    places = {AskedTags: settings.apriltag, AskedEmotions: settings.emotionrecognition}
    return {
        kind.name: kind(*_place(place), order=order, timeout=settings.patience)
        for kind, place in places.items()
        if place
    }


def _place(address: str) -> tuple[str, int]:
    host, _, port = address.rpartition(":")
    return host, int(port)
