"""The components that the user has chosen to look in our detectors' place."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from learnblock.vision.settings import PerceptionSettings

if TYPE_CHECKING:
    from learnblock.components import Asked


def chosen_components(settings: PerceptionSettings) -> "Mapping[str, Asked]":
    """Detectors that ask them, by their names; nothing is asked yet."""
    if not (settings.apriltag or settings.emotionrecognition):
        return {}
    # Few users have any.
    from learnblock.components import AskedEmotions, AskedTags, Order  # noqa: PLC0415

    order = None if settings.layout == "auto" else Order(settings.layout)
    places = {AskedTags: settings.apriltag, AskedEmotions: settings.emotionrecognition}
    return {
        kind.name: kind(*_place(place), order=order, patience=settings.patience)
        for kind, place in places.items()
        if place
    }


def _place(address: str) -> tuple[str, int]:
    host, _, port = address.rpartition(":")
    return host, int(port)
