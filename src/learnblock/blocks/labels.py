"""Labels of blocks: sentences that name their parameters in braces.

    drive {advSpeed.direction} at {advSpeed} mm/s

A parameter that the label does not name follows it, with the parameter's own translation. The sign
of a number can be a word of the sentence, its direction: ``forward`` or ``backward``. A part in
square brackets is shown only if its parameters differ from their defaults:

    drive {distance} mm[ at {advSpeed} mm/s]
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

from learnblock.blocks import translation
from learnblock.blocks.schema.configuration import (
    NEGATIVE,
    POSITIVE,
    BlockConfiguration,
    Parameter,
)

_OPTIONAL = re.compile(r"\[([^\[\]]+)\]")
_PLACE = re.compile(r"\{(\w+)(\.direction)?\}")


def translated(texts: Mapping[str, str], language: str, otherwise: str) -> str:
    """A text of a configuration in a language, else in English, else `otherwise`."""
    code = language.upper()
    return texts.get(code) or texts.get(code.partition("-")[0]) or texts.get("EN") or otherwise


def units(block: BlockConfiguration, language: str) -> dict[str, str]:
    """The units that follow parameters in the label, by parameter.

    >>> from learnblock.blocks.schema.loading import builtin
    >>> units(builtin()["move_straight"], "en")
    {'advSpeed': 'mm/s'}
    """
    return dict(_unit().findall(translated(block.languages, language, "")))


@cache
def _unit() -> re.Pattern[str]:
    """A parameter in a label and the unit that follows it."""
    longest_first = sorted(translation.units(), key=len, reverse=True)
    names = "|".join(map(re.escape, longest_first))
    return re.compile(rf"\{{(\w+)\}} ?({names})(?!\w)")


def label(block: BlockConfiguration, language: str) -> str:
    """The label with its parameters in brackets: ``drive forward at (speed) mm/s``.

    A direction is that of the default.
    """
    return sentence(
        block,
        language,
        Filling(
            lambda parameter: f"({parameter_name(parameter, language)})",
            lambda parameter: direction(parameter, parameter.default, language),
        ),
    )


def spoken(block: BlockConfiguration, language: str, values: Mapping[str, object]) -> str:
    """The sentence with these values, or the default for those that are missing.

    >>> from learnblock.blocks.schema.loading import builtin
    >>> spoken(builtin()["turn"], "en", {"angle": -90})
    'turn left by 90°'
    >>> spoken(builtin()["sleep"], "en", {"seconds": 1})
    'wait 1 second'
    """

    def value(parameter: Parameter) -> object:
        return values.get(parameter.name, parameter.default)

    def field(parameter: Parameter) -> str:
        content = value(parameter)
        is_directed = parameter.directions and isinstance(content, int | float)
        return str(abs(content) if is_directed else content)  # type: ignore[arg-type] # is_directed

    def unusual(parameters: Sequence[Parameter], words: str) -> str:
        return (
            words if any(value(parameter) != parameter.default for parameter in parameters) else ""
        )

    filling = Filling(
        field, lambda parameter: direction(parameter, value(parameter), language), unusual
    )
    ones = {parameter.name for parameter in block.parameters if value(parameter) == 1}
    return sentence(_with_singular(block, language, ones), language, filling)


def _with_singular(block: BlockConfiguration, language: str, ones: set[str]) -> BlockConfiguration:
    """The block with a label in which the units of these parameters are in the singular."""

    def unit(match: re.Match[str]) -> str:
        words = translation.units().get(match[2], match[2]) if match[1] in ones else match[2]
        return match[0].removesuffix(match[2]) + words

    text = _unit().sub(unit, translated(block.languages, language, ""))
    return replace(block, languages={language.upper(): text}) if text else block


def _unmarked(_: Sequence[Parameter], words: str) -> str:
    return words


@dataclass(frozen=True, slots=True)
class Filling:
    """What takes the places of a label.

    Args:
        field: returns the replacement for a parameter.
        direction: returns that for its direction; it precedes the parameter if the label does not
            say where it belongs.
        optional: returns the replacement for a part that may be left out, by its parameters and
            words, whose places are still to be filled; empty to leave it out.
    """

    field: Callable[[Parameter], str]
    direction: Callable[[Parameter], str]
    optional: Callable[[Sequence[Parameter], str], str] = _unmarked


def sentence(block: BlockConfiguration, language: str, filling: Filling) -> str:
    """The label of a block in a language such as ``es``, filled."""
    text = translated(block.languages, language, block.name)
    left_out: set[str] = set()
    for part in optional_parts(block, language):
        words = filling.optional(part.parameters, part.words)
        text = text.replace(f"[{part.words}]", words)
        left_out |= set() if words else {parameter.name for parameter in part.parameters}
    parameters = {parameter.name: parameter for parameter in block.parameters}
    fields = {name: filling.field(parameter) for name, parameter in parameters.items()}
    directions = {
        name: filling.direction(parameter)
        for name, parameter in parameters.items()
        if parameter.directions
    }
    placed_fields = {name for name, directed in _PLACE.findall(text) if not directed}
    placed_directions = {name for name, directed in _PLACE.findall(text) if directed}
    for name in directions.keys() - placed_directions:
        fields[name] = f"{directions.pop(name)} {fields[name]}"
    following = [
        f"{parameter_name(parameter, language)} {fields[name]}"
        for name, parameter in parameters.items()
        if name not in placed_fields | left_out
    ]

    def filled(place: re.Match[str]) -> str:
        # Each can be shown only once, and braces that name no parameter are plain text.
        return (directions if place[2] else fields).pop(place[1], place[0])

    return " ".join([_PLACE.sub(filled, text), *following])


@dataclass(frozen=True, slots=True)
class OptionalPart:
    """A part of a label in square brackets that only states defaults.

    Args:
        words: without the brackets.
        parameters: all of them have a default.
    """

    words: str
    parameters: tuple[Parameter, ...]


def optional_parts(block: BlockConfiguration, language: str) -> tuple[OptionalPart, ...]:
    """The optional parts of a label; brackets around anything else are plain text."""
    parameters = {
        parameter.name: parameter for parameter in block.parameters if not parameter.required
    }
    parts = []
    for words in _OPTIONAL.findall(translated(block.languages, language, block.name)):
        names = [name for name, directed in _PLACE.findall(words) if not directed]
        if names and parameters.keys() >= set(names):
            parts.append(OptionalPart(words, tuple(parameters[name] for name in names)))
    return tuple(parts)


def direction(parameter: Parameter, value: object, language: str) -> str:
    """The word for the sign of a number; the positive one for zero and for other values."""
    is_negative = isinstance(value, int | float) and value < 0
    words = parameter.directions.get(NEGATIVE if is_negative else POSITIVE, {})
    return translated(words, language, "")


def parameter_name(parameter: Parameter, language: str) -> str:
    """The name of a parameter for a reader."""
    return translated(parameter.translations, language, parameter.name)
