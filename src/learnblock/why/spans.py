"""The times in a question: "at 8.9", "between 3 and 5 s", "after 5 seconds"."""

import re
from dataclasses import dataclass

_NUMBER = r"(?:(?:the |el |los )?(?:second|segundo|seconds|segundos)s? |t ?= ?)?(\d+(?:[.,]\d+)?)"
_UNIT = r"\s*(?:s|sec|secs|second|seconds|seg|segs|segundo|segundos)\b\.?"
_BETWEEN = re.compile(
    rf"\b(?:between|from|entre|desde|de|del)\s+(?:el |los )?{_NUMBER}(?:{_UNIT})?"
    rf"\s*(?:and|to|until|till|y|a|al|hasta|-)\s*(?:el )?{_NUMBER}(?:{_UNIT})?"
)
_RANGE = re.compile(rf"\b{_NUMBER}\s*(?:-|–|to|a)\s*{_NUMBER}{_UNIT}")
_AFTER = re.compile(
    rf"\b(?:after|since|later than|despues de(?:l)?|a partir de(?:l)?|tras|desde|pasados)\s+"
    rf"{_NUMBER}(?:{_UNIT})?"
)
_BEFORE = re.compile(
    rf"\b(?:before|earlier than|within|in the first|antes de(?:l)?|en los primeros)\s+"
    rf"{_NUMBER}(?:{_UNIT})?"
)
_AT = (
    r"(?:\b(?:at|by|until|around|about|t|en|a los|a las|hasta|sobre|hacia|a)\b|@|=)"
    r"\s*(?:t ?= ?|about |el )?"
)
#: A number is a time only after "at", as the last word or with a unit.
_MOMENT = re.compile(rf"{_AT}{_NUMBER}(?:{_UNIT}|\s*$)|^at {_NUMBER}\b")


@dataclass(frozen=True, slots=True)
class Span:
    """The part of a run that a question is about.

    Args:
        time: its end, or the moment in question, in s; None for the end of the run.
        since: its start, in s; None for a moment, or the whole run.
    """

    time: float | None = None
    since: float | None = None


def take_span(text: str) -> tuple[Span, str]:
    """The times in a plain text, and the text without them."""
    for pattern in (_BETWEEN, _RANGE):
        if times := pattern.search(text):
            first, last = sorted((_seconds(times[1]), _seconds(times[2])))
            return Span(last, first), _without(text, times)
    if times := _AFTER.search(text):
        return Span(None, _seconds(times[1])), _without(text, times)
    if times := _BEFORE.search(text):
        return Span(_seconds(times[1]), 0.0), _without(text, times)
    if times := _MOMENT.search(text):
        return Span(_seconds(times[1] or times[2])), _without(text, times)
    return Span(), text


def _seconds(digits: str) -> float:
    return float(digits.replace(",", "."))


def _without(text: str, times: re.Match[str]) -> str:
    return " ".join((text[: times.start()] + " " + text[times.end() :]).split()).strip(" ,;")
