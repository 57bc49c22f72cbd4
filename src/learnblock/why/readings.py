"""The answers to the program's questions, and the sensor readings behind them."""

from collections import defaultdict
from collections.abc import Iterable
from typing import Any

from learnblock.i18n import Phrase, Value
from learnblock.language.check.robots import need_phrase
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import Kind
from learnblock.why.decimals import FEW, decimals, is_compared_exactly
from learnblock.why.history import CalledSkill, EventHistory
from learnblock.why.slices import Slices
from learnblock.why.things import thing_at
from learnblock.why.wording import answer_phrase, blocks, skill_phrase, unpacked, value_phrase

#: The distance in mm at which a sensor sees nothing any more.
FAR = 1999
#: Percent below which the floor is dark.
_DARK = 50
#: Of a measurement.
_MOST_DECIMALS = 6
_LINES = frozenset({"black-line", "red-line", "blue-line"})


class Readings:
    """The readings of one run in words.

    Args:
        slices: of the run.
    """

    def __init__(self, slices: Slices) -> None:
        self._history: EventHistory = slices.history
        self._slices = slices
        self._of_device: dict[str, list[int]] = defaultdict(list)
        for index, event in enumerate(self._history.events):
            if event[0] == Op.READING:
                self._of_device[event[1].partition(":")[0]].append(index)

    def facts(self, event: int) -> tuple[Value, ...]:
        """What made a condition true or not: its operands in words, without repetitions."""
        facts: dict[str, Value] = {}
        count = self._decimals(event)
        for part in self._slices.parts(event):
            fact = self._fact(part, count)
            if fact is not None:
                facts.setdefault(str(fact), fact)
        return tuple(facts.values())

    def summary(self, event: int) -> Value:
        """The facts of a condition after a colon; "" if there are none."""
        facts = self.facts(event)
        return Phrase("why-facts", facts=tuple(map(_shown, facts))) if facts else ""

    def is_inexact(self, event: int) -> bool:
        """Whether a condition asked if a decimal is exactly what it only nearly was."""
        is_exact = is_compared_exactly(self._history.node(event).text)
        return is_exact and self._decimals(event) > FEW

    def _decimals(self, event: int) -> int:
        """How many decimals the operands of a condition need, so that they match its result."""
        history, outcome = self._history, self._history.value(event)
        if history.op(event) != Op.CONDITION or not isinstance(outcome, bool):
            return FEW
        values = {
            history.node(part).text: history.value(part) for part in self._slices.parts(event)
        }
        return decimals(history.node(event).text, values, was_true=outcome)

    def _fact(self, part: int, count: int) -> Phrase | None:
        node, value = self._history.node(part), self._history.value(part)
        if node.kind is Kind.NAME:
            return Phrase("why-name-was", name=node.name, value=value_phrase(value, count))
        if node.kind is Kind.STATE:
            if node.name == "time":
                seconds = value_phrase(float(value), count if count > FEW else 1)
                return Phrase("why-when-time", name=node.base, seconds=seconds)
            return Phrase("why-when-state", name=node.base, active=str(value).lower())
        use = self._history.skills.get(part)
        if use is not None:
            return self.answered(use, part, count)
        if node.kind is Kind.CALL and not node.base and self._slices.called(part):
            return Phrase("why-own-gave", name=node.name, value=value_phrase(value, count))
        return None

    def answered(self, use: CalledSkill, result: int, count: int = FEW) -> Phrase:
        """The answer of a skill in words, with this many decimals."""
        value = self._history.value(result)
        if use.missing:
            device = need_phrase(use.missing[0])
            return Phrase(
                "why-never-answers", device=device, skill=skill_phrase(use.name, use.args)
            )
        return (
            (self._measured(use, result) if count == FEW else None)
            or self._time_asked(use, result)
            or Phrase(
                "why-answered",
                skill=skill_phrase(use.name, use.args),
                value=answer_phrase(value, count),
            )
        )

    def _measured(self, use: CalledSkill, result: int) -> Phrase | None:
        """The reading behind an answer; None if it is not one of a sensor."""
        block = blocks().get(use.name)
        needs = block.needs if block else ()
        for need in needs:
            kind, _, _ = need.partition(":")
            if kind.startswith("obstacle-"):
                return self._distance(use, result)
            if kind in ("GroundSensors", "ground-line"):
                return self._ground(result)
            if kind in _LINES:
                return self._line(kind.partition("-")[0], result) or self._ground(result)
            if kind == "Camera" and "tag" in use.name:
                return self._tags(result)
        return None

    def values(self, reading: int) -> tuple[float, ...]:
        """The numbers of a reading that has one for each side."""
        values = unpacked(self._history.value(reading))
        numbers = values.values() if isinstance(values, dict) else ()
        return tuple(float(number) for number in numbers if _is_number(number))

    def closest(self, events: Iterable[int]) -> tuple[float, str, int] | None:
        """The smallest distance that some conditions asked about, its side, and the result."""
        distances: list[tuple[float, str, int]] = []
        for event in events:
            for part in self._slices.parts(event):
                use = self._history.skills.get(part)
                near = self._nearest(use, part) if use and not use.missing else None
                if near and near[0] < FAR:
                    distances.append((*near, part))
        return min(distances, default=None)

    def _nearest(self, use: CalledSkill, result: int) -> tuple[float, str] | None:
        block = blocks().get(use.name)
        needs = block.needs if block else ()
        sides = [need.removeprefix("obstacle-") for need in needs if need.startswith("obstacle-")]
        reading = self._reading("DistanceSensors", use, result)
        if reading is None or not sides:
            return None
        values = unpacked(self._history.value(reading))
        if not isinstance(values, dict):
            return None
        distances = [
            (mm, side) for side in sides for mm in values.get(side) or () if _is_number(mm)
        ]
        return min(distances, default=None)

    def _distance(self, use: CalledSkill, result: int) -> Phrase | None:
        near = self._nearest(use, result)
        if near is None:
            return None
        mm, side = near
        limit = _limit(use)
        if mm >= FAR:
            return Phrase("why-saw-nothing", side=_side(side))
        thing = thing_at(side, self._history.time(result))
        values: dict[str, Value] = {"side": _side(side), "mm": _exact(mm, limit), "thing": thing}
        if limit is None:
            return Phrase("why-measured", **values)
        return Phrase("why-measured-limit", **values, limit=limit, less=str(mm < limit).lower())

    def _ground(self, result: int) -> Phrase | None:
        reading = self._reading("GroundSensors", self._history.skills[result], result)
        if reading is None:
            return None
        values = unpacked(self._history.value(reading))
        if not isinstance(values, dict):
            return None
        sensors = tuple(
            Phrase(
                "why-ground", side=_on(side), dark=str(value < _DARK).lower(), value=round(value)
            )
            for side, value in values.items()
            if _is_number(value)
        )
        return Phrase("why-ground-saw", sensors=sensors) if sensors else None

    def _line(self, colour: str, result: int) -> Phrase | None:
        reading = self._reading("Camera", self._history.skills[result], result)
        values = unpacked(self._history.value(reading)) if reading is not None else None
        points = values.get(colour) if isinstance(values, dict) else None
        if not isinstance(points, dict):
            return None
        shares = {side: round(points.get(side) or 0) for side in ("left", "center", "right")}
        if not any(shares.values()):
            return Phrase("why-saw-no-line", colour=Phrase("why-colour", colour=colour))
        return Phrase("why-saw-line", colour=Phrase("why-colour", colour=colour), **shares)

    def _tags(self, result: int) -> Phrase | None:
        reading = self._reading("Camera", self._history.skills[result], result)
        values = unpacked(self._history.value(reading)) if reading is not None else None
        if not isinstance(values, list):
            return None
        numbers = [str(tag["id"]) for tag in values if isinstance(tag, dict) and "id" in tag]
        if not numbers:
            return Phrase("why-saw-no-tag")
        return Phrase("why-saw-tags", tags=tuple(numbers))

    def _time_asked(self, use: CalledSkill, result: int) -> Phrase | None:
        if use.name != "elapsedTime" or not use.args or not _is_number(use.args[0]):
            return None
        time, limit = self._history.time(result), use.args[0]
        is_over = self._history.value(result)
        return Phrase(
            "why-time-was-over" if is_over else "why-time-was",
            time=_apart(time, limit, 1, is_more=bool(is_over)),
            limit=limit,
        )

    def _reading(self, device: str, use: CalledSkill | None, before: int) -> int | None:
        """The reading of a device that a skill used: its own, or the newest one of that moment."""
        own = [
            index
            for index in (use.readings if use else ())
            if self._history.device(index).startswith(device)
        ]
        if own:
            return own[-1]
        last = self._history.last_of(self._of_device[device], before)
        return last if last >= 0 else None


def _limit(use: CalledSkill) -> float | None:
    """The distance in mm within which an obstacle counts."""
    block = blocks().get(use.name)
    for index, parameter in enumerate(block.parameters if block else ()):
        if parameter.name == "threshold":
            value = use.args[index] if index < len(use.args) else parameter.default
            return value if isinstance(value, int | float) else None
    return None


def _side(name: str) -> Phrase:
    return Phrase("why-side", side=name)


def _on(side: str) -> Phrase:
    return Phrase("why-ground-side", side=side)


def _exact(mm: float, limit: float | None) -> float:
    """A distance in whole millimetres, or as exact as a comparison with its limit needs."""
    return round(mm) if limit is None else _apart(mm, limit, 0, is_more=mm > limit)


def _apart(value: float, limit: float, count: int, *, is_more: bool) -> float:
    """A number with at least this many decimals, and enough to be on its side of a limit."""
    for more in range(count, _MOST_DECIMALS):
        number = round(value, more)
        if (number > limit) == is_more and (number == limit) == (value == limit):
            return number
    return value


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _shown(fact: Value) -> str | Phrase:
    return fact if isinstance(fact, Phrase) else str(fact)
