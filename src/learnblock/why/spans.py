"""The times in a question: "at 8.9", "between 3 and 5 s", "after 5 seconds"."""

import re
from dataclasses import dataclass

from learnblock.why.vocabulary import forms

_NUMBER = rf"(?:{forms('second')} |t ?= ?)?(\d+(?:[.,]\d+)?)"
_UNIT = rf"\s*{forms('unit')}\b\.?"
_BETWEEN = re.compile(
    rf"\b{forms('between')}\s+{_NUMBER}(?:{_UNIT})?"
    rf"\s*(?:{forms('until')}|-)\s*{_NUMBER}(?:{_UNIT})?"
)
_RANGE = re.compile(rf"\b{_NUMBER}\s*(?:-|–|{forms('range')})\s*{_NUMBER}{_UNIT}")
_AFTER = re.compile(rf"\b{forms('after')}\s+{_NUMBER}(?:{_UNIT})?")
_BEFORE = re.compile(rf"\b{forms('before')}\s+{_NUMBER}(?:{_UNIT})?")
_AT = rf"(?:\b(?:{forms('at')}|t)\b|@|=)\s*(?:t ?= ?)?"
#: A number is a time only after "at", as the last word or with a unit.
_MOMENT = re.compile(rf"{_AT}{_NUMBER}(?:{_UNIT}|\s*$)|^{forms('moment')} {_NUMBER}\b")


@dataclass(frozen=True, slots=True)
class RunSpan:
    """The part of a run that a question is about.

    Args:
        time: its end, or the moment in question, in s; None for the end of the run.
        since: its start, in s; None for a moment, or the whole run.
    """

    time: float | None = None
    since: float | None = None


def take_span(text: str) -> tuple[RunSpan, str]:
    """The times in a plain text, and the text without them."""
    for pattern in (_BETWEEN, _RANGE):
        if times := pattern.search(text):
            first, last = sorted((_seconds(times[1]), _seconds(times[2])))
            return RunSpan(last, first), _without(text, times)
    if times := _AFTER.search(text):
        return RunSpan(None, _seconds(times[1])), _without(text, times)
    if times := _BEFORE.search(text):
        return RunSpan(_seconds(times[1]), 0.0), _without(text, times)
    if times := _MOMENT.search(text):
        return RunSpan(_seconds(times[1] or times[2])), _without(text, times)
    return RunSpan(), text


def _seconds(digits: str) -> float:
    return float(digits.replace(",", "."))


def _without(text: str, times: re.Match[str]) -> str:
    return " ".join((text[: times.start()] + " " + text[times.end() :]).split()).strip(" ,;")
