"""The values that devices are given."""

import math

from learnblock.errors import DeviceValueError


def positive(name: str, value: object, code: str) -> float:
    """`value` as a finite float of more than 0.

    Args:
        name: the parameter.
        value: what it was given.
        code: the message about a number that is not more than 0, which has the number as `value`.

    Raises:
        DeviceValueError: the parameter has any other value.
    """
    result = number(name, value)
    if result <= 0:
        raise DeviceValueError(code, value=result)
    return result


def number(name: str, value: object) -> float:
    """`value` as a finite float.

    Raises:
        DeviceValueError: the parameter `name` has any other value.
    """
    if type(value) is float and math.isfinite(value):
        return value
    # numpy's numbers are not subclasses of float, but convert like other numbers. This check is a
    # hundred times faster than `isinstance(value, typing.SupportsFloat)`.
    convert = getattr(type(value), "__float__", None)
    if convert is None or isinstance(value, bool):
        raise DeviceValueError("device-not-number", name=name, value=f"{value!r:.80}")
    try:
        converted: float = convert(value)
    except (OverflowError, TypeError, ValueError) as error:
        # For example, a whole number with 400 digits, or an array of two numbers.
        raise DeviceValueError("device-not-number", name=name, value=f"{value!r:.80}") from error
    if not math.isfinite(converted):
        raise DeviceValueError("device-not-finite", name=name, value=repr(value))
    return converted


def whole(name: str, value: object) -> int:
    """`value` rounded to a whole number."""
    return round(number(name, value))


def clamped(name: str, value: object, most: int) -> int:
    """`value` as a whole number, limited to 0 to `most`."""
    return min(max(whole(name, value), 0), most)
