"""Skills and functions of devices whose calls are noted in the log of the program."""

from collections.abc import Callable
from functools import wraps
from typing import Any

from learnblock.runtime.log.events import QUESTIONS
from learnblock.runtime.log.noting import Noting


def noted_skill(noting: Noting, name: str, method: Callable[..., Any]) -> Callable[..., Any]:
    """A skill that notes when it begins and ends."""

    @wraps(method)
    def skill(*args: Any, **kwargs: Any) -> Any:
        noting.skill(name, args, kwargs)
        try:
            return method(*args, **kwargs)
        finally:
            noting.skill_end(name)

    return skill


def noted_function(
    noting: Noting, device: str, name: str, function: Callable[..., Any]
) -> Callable[..., Any]:
    """A function of a device that notes commands, and the answers to questions.

    Args:
        noting: the log.
        device: such as ``Base:ROBOT``.
        name: the name of the function.
        function: the function.
    """
    if name not in QUESTIONS:

        def command(*args: Any) -> Any:
            noting.command(device, name, args)
            return function(*args)

        return command
    if device.startswith("Camera:") and name == "read":
        # No pictures: a world shows them again.
        return function

    def question(*args: Any) -> Any:
        value = function(*args)
        noting.reading(device, value)
        return value

    return question
