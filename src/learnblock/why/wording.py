"""Values, skills and movements in words."""

import re
from functools import cache
from typing import Any

from learnblock.blocks import BlockConfiguration, Configurations
from learnblock.blocks.known import all_configurations
from learnblock.blocks.labels import Filling, direction, sentence, spoken
from learnblock.i18n import Multilingual, Phrase, Value
from learnblock.i18n.words import languages
from learnblock.why.decimals import FEW, rounded

#: Names of movements: the ends of their codes in ``why.ftl``.
STAND = "stand"
FORWARD, BACK = "forward", "back"
SPIN_LEFT, SPIN_RIGHT = "spin-left", "spin-right"
CURVE_LEFT, CURVE_RIGHT = "curve-left", "curve-right"
_MOVEMENT_CODES = {
    STAND: "why-move-stand",
    FORWARD: "why-move-forward",
    BACK: "why-move-back",
    SPIN_LEFT: "why-move-spin-left",
    SPIN_RIGHT: "why-move-spin-right",
    CURVE_LEFT: "why-move-curve-left",
    CURVE_RIGHT: "why-move-curve-right",
    # Any turn.
    "": "why-move-turn",
}
MOVEMENTS = tuple(_MOVEMENT_CODES)
_ANSWER_CODES = {None: "why-value-none", True: "why-answer-true", False: "why-answer-false"}
#: Things that are named by what they show.
_NUMBERED = frozenset({"tag", "face"})
#: mm/s and degrees/s below which a robot hardly moves: it corrects its course.
_CREEPING, _STEERING = 1.0, 1.0


#: Numbers with more decimals would be shortened.
_FORMATTED = 3


@cache
def blocks() -> Configurations:
    """The blocks of this computer."""
    return all_configurations()


def movement(advance: float, rotation: float) -> str:
    """The name of a movement at `advance` mm/s and `rotation` degrees/s to the right."""
    if abs(advance) < _CREEPING:
        if abs(rotation) < _STEERING:
            return STAND
        return SPIN_RIGHT if rotation > 0 else SPIN_LEFT
    if abs(rotation) < _STEERING:
        return FORWARD if advance > 0 else BACK
    return CURVE_RIGHT if rotation > 0 else CURVE_LEFT


def movement_phrase(name: str) -> Phrase:
    """A movement in words: "turn right on the spot"."""
    return Phrase(_MOVEMENT_CODES[name])


def skill_phrase(name: str, args: list[Any] | None = None) -> Value:
    """A skill in the words of its block; the name itself if there is no block.

    Args:
        name: of the skill.
        args: its arguments; None leaves them out.
    """
    block = blocks().get(name)
    if block is None:
        return name
    return Multilingual({language: _spoken(block, language, args) for language in languages()})


def _spoken(block: BlockConfiguration, language: str, args: list[Any] | None) -> str:
    if args is None:
        filling = Filling(
            lambda _: "…", lambda parameter: direction(parameter, parameter.default, language)
        )
        return sentence(block, language, filling)
    names = [parameter.name for parameter in block.parameters]
    return spoken(block, language, dict(zip(names, args, strict=False)))


def thing_phrase(name: str) -> Phrase:
    """A thing of one of our worlds in the reader's words; other names as they are."""
    word = re.sub(r"[^a-z0-9]+", "-", name.casefold()).strip("-")
    kind, _, rest = word.partition("-")
    return Phrase("why-name", word=kind if kind in _NUMBERED else word, rest=rest, name=name)


def value_phrase(value: Any, decimals: int = FEW) -> Value:
    """A snapshot of a value as a reader of the program knows it, with this many decimals."""
    if value is None:
        return Phrase(_ANSWER_CODES[value])
    if isinstance(value, bool):
        return str(value)
    if isinstance(value, float):
        # A number with many decimals is written as in the program.
        number = rounded(value, decimals)
        return number if decimals <= _FORMATTED else repr(number)
    if isinstance(value, int):
        return value if abs(value) < 10**6 else str(value)
    if isinstance(value, str):
        return f'"{value}"'
    return _structure(value)


def answer_phrase(value: Any, decimals: int = FEW) -> Value:
    """A snapshot of a skill's answer: yes or no rather than a value of the program."""
    is_yes_or_no = value is None or isinstance(value, bool)
    return Phrase(_ANSWER_CODES[value]) if is_yes_or_no else value_phrase(value, decimals)


def _structure(value: Any) -> str:
    """A list or a dictionary, as in the program."""
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_structure, value)) + "]"
    if isinstance(value, dict):
        if "pairs" in value:
            pairs = (f"{_structure(key)}: {_structure(item)}" for key, item in value["pairs"])
            return "{" + ", ".join(pairs) + "}"
        return "..."
    return repr(round(value, 2) if isinstance(value, float) else value)


def unpacked(value: Any) -> Any:
    """A snapshot with its dictionaries as such, for readings of sensors."""
    if isinstance(value, dict) and "pairs" in value:
        return {str(key): unpacked(item) for key, item in value["pairs"]}
    if isinstance(value, list):
        return [unpacked(item) for item in value]
    return value
