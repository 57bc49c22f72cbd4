"""Types that msgspec has learned, so that threads may convert to them at once.

msgspec learns a type when it is first used. If a second thread uses it meanwhile, it finds the type
half learned, and the process dies of a segmentation fault (seen in msgspec 0.22). So a type that
several threads of a server may be the first to use is learned before, by one of them.
"""

import threading
from collections.abc import Hashable
from functools import cache
from typing import TypeVar, cast

import msgspec

T = TypeVar("T")

_LEARNING = threading.Lock()


def learned(kind: T) -> T:
    """The type, once msgspec has learned it.

    >>> msgspec.convert([1.5, 2], learned(tuple[float, int]))
    (1.5, 2)
    """
    with _LEARNING:
        _learn(cast("Hashable", kind))
    return kind


@cache
def _learn(kind: Hashable) -> None:
    msgspec.json.Decoder(kind)
