"""When a run came to a place that a question names: "at the wall", "en el borde"."""

import re

from learnblock.runtime.log.events import Op
from learnblock.why.history import EventHistory
from learnblock.why.vocabulary import Concept, concept, forms, plain, words
from learnblock.why.wording import unpacked

_PLACE = re.compile(rf"\b{forms('place')} (?:{forms('article')} )?(\w+)")
#: A sensor that measures less, in mm, is near a thing.
_NEAR = 200.0


def place_time(history: EventHistory, text: str) -> float | None:
    """When the robot first was at the place that a plain text names, in s; None for no place."""
    place = _PLACE.search(text)
    name = words(place[1])[-1] if place and words(place[1]) else ""
    if concept(name) not in (Concept.WALL, Concept.EDGE, Concept.TAG):
        return None
    bumps = [line for line in history.recorded.lines if "bump" in line]
    matches = [line for line in bumps if name in plain(str(line["bump"])).split()]
    if concept(name) is Concept.WALL and (matches or bumps):
        return round(float((matches or bumps)[0]["t"]), 2)
    return _nearest(history) if concept(name) is Concept.WALL else None


def _nearest(history: EventHistory) -> float | None:
    """When the front sensor first measured least; None if it saw nothing near."""
    readings: list[tuple[float, float]] = []
    for index, event in enumerate(history.events):
        if event[0] == Op.READING and str(event[1]).startswith("DistanceSensors"):
            values = unpacked(event[2])
            front = values.get("front") if isinstance(values, dict) else None
            near = [mm for mm in front or () if isinstance(mm, int | float)]
            if near and min(near) < _NEAR:
                readings.append((min(near), history.time(index)))
    return min(readings)[1] if readings else None
