"""Defaults of parameters, in the JSON of a configuration.

They may be written as strings, like those in the paper's example.
"""

import json
import math
from collections.abc import Callable, Mapping
from typing import Any

from learnblock.blocks.schema.configuration import ParameterType, is_colour


def _to_float(value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        raise TypeError(value)
    if isinstance(value, int):
        return value
    converted = float(value)
    if not math.isfinite(converted):
        raise ValueError(value)
    # A block shows 40, not 40.0.
    return int(converted) if converted.is_integer() else converted


def _to_int(value: object) -> int:
    converted = _to_float(value)
    if not isinstance(converted, int):
        raise TypeError(value)
    return converted


def _to_string(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(value)
    return value


def _to_boolean(value: object) -> bool:
    return {"true": True, "1": True, "false": False, "0": False}[str(value).lower()]


def _to_list(value: object) -> list[Any]:
    converted = json.loads(value) if isinstance(value, str) else value
    if not isinstance(converted, list):
        raise TypeError(value)
    return converted


def _to_colour(value: object) -> str:
    if not is_colour(value):
        raise ValueError(value)
    return str(value)


def _to_tag(value: object) -> int | str:
    if isinstance(value, str) and not value.isdecimal():
        return value
    return _to_int(value)


#: How a JSON value becomes a default, by type.
DEFAULTS: Mapping[ParameterType, Callable[[object], object]] = {
    "float": _to_float,
    "int": _to_int,
    "string": _to_string,
    "boolean": _to_boolean,
    "list": _to_list,
    "choice": _to_string,
    "colour": _to_colour,
    "angle": _to_float,
    "apriltext": _to_tag,
}
