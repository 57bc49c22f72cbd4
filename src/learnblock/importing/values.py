"""The arguments of skills: values in the fields of old blocks, as Block-Text."""

import re
from collections.abc import Collection
from math import degrees

from learnblock.blocks import NUMBERS, Parameter
from learnblock.importing.names import legal
from learnblock.importing.project import Value
from learnblock.language.tree.strings import quote

_NUMBER = re.compile(r"-?(?:\d{1,40}\.?\d{0,40}|\.\d{1,40})")
_TEXTS = frozenset(("string", "list"))
_TRUTHS = {"0": "False", "1": "True", "false": "False", "true": "True"}
#: Parameters that were radians per second in version 1.
_ROTATIONS = frozenset(("rot", "rotSpeed", "decRot"))


def argument(
    value: Value,
    parameter: Parameter | None,
    variables: Collection[str],
    *,
    in_radians: bool = False,
) -> str | None:
    """A value in a field as Block-Text; None if the field holds nothing usable.

    Args:
        value: the value.
        parameter: the parameter of the skill; None if the block is not a skill.
        variables: the names of the project's variables, which a field may hold too.
        in_radians: whether rotations are radians per second.
    """
    rotates = in_radians and parameter is not None and parameter.name in _ROTATIONS
    if value.text in variables:
        name = legal(value.text)
        return f"{name} * 180 / pi()" if rotates else name
    if value.type == "boolean":
        return _TRUTHS.get(value.text.casefold(), "True")
    number = number_of(value.text)
    if number is not None and (value.type not in _TEXTS or _is_number(parameter)):
        return in_degrees(number) if rotates else number
    if value.type in _TEXTS or value.type == "apriltext":
        return quote(unquoted(value.text))
    return _other(value.text)


def number_of(text: str) -> str | None:
    """A number as Block-Text spells it, also from quotes and with a comma; None for other text."""
    plain = unquoted(text).strip().replace(",", ".")
    if not _NUMBER.fullmatch(plain):
        return None
    sign, digits = ("-", plain[1:]) if plain.startswith("-") else ("", plain)
    whole, point, rest = digits.partition(".")
    return sign + (whole.lstrip("0") or "0") + (point + rest if rest else "")


def unquoted(text: str) -> str:
    """A text without the quotes around it."""
    if len(text) > 1 and text[0] == text[-1] and text[0] in "\"'":
        return text[1:-1]
    return text


def in_degrees(radians: str) -> str:
    """Radians as degrees, to a tenth, which no robot can tell from the exact value."""
    turned = round(degrees(float(radians)), 1)
    return str(int(turned)) if turned == int(turned) else str(turned)


def _is_number(parameter: Parameter | None) -> bool:
    return parameter is not None and parameter.type in NUMBERS


def _other(text: str) -> str | None:
    """A text in the field of a number: a name, or nothing usable."""
    name = legal(text)
    return name if text and name == text else None
