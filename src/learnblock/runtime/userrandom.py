"""Gives a program its own random numbers, so that other programs in its thread change nothing."""

import random
from collections.abc import Callable

from learnblock.runtime.own_functions import OwnFunctions

#: The functions of the module that share its generator, such as `randint` and `seed`.
_SHARED = tuple(
    name
    for name, function in vars(random).items()
    if isinstance(getattr(function, "__self__", None), random.Random)
)
_RANDOM = OwnFunctions(random, _SHARED)


def use_own_random() -> Callable[[], None]:
    """Give the calling program a generator of its own; return the function that undoes it."""
    generator = random.Random()  # noqa: S311 - as the module's own, for programs
    return _RANDOM.use({name: getattr(generator, name) for name in _SHARED})
