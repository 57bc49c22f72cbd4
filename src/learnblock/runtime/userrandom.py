"""Gives a program its own random numbers, so that other programs in its thread change nothing."""

import random
from collections.abc import Callable
from operator import index

from learnblock.runtime.own_functions import OwnFunctions

#: The functions of the module that share its generator, such as `randint` and `seed`.
_SHARED = tuple(
    name
    for name, function in vars(random).items()
    if isinstance(getattr(function, "__self__", None), random.Random)
)
_RANDOM = OwnFunctions(random, _SHARED)


class _Generator(random.Random):
    """A generator that takes whole numbers only; before Python 3.12 a 6.0 was one, too."""

    def randrange(self, start: int, stop: int | None = None, step: int = 1) -> int:
        end = None if stop is None else index(stop)
        return super().randrange(index(start), end, index(step))


def use_own_random() -> Callable[[], None]:
    """Give the calling program a generator of its own; return the function that undoes it."""
    generator = _Generator()
    return _RANDOM.use({name: getattr(generator, name) for name in _SHARED})
