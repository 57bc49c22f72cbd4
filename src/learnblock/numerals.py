"""Write numbers in as few digits as a sentence about them needs."""

#: Decimals that are enough for a number by itself.
_DECIMALS = 2
#: Decimals that tell any two numbers of everyday size apart.
_MOST = 17


def shown(value: float, *others: float) -> str:
    """A number with two decimals, or as many more as tell it from those it is compared with.

    ``shown(0.1 + 0.2)`` is 0.3, and ``shown(0.1 + 0.2, 0.3)`` is 0.30000000000000004.
    """
    for decimals in range(_DECIMALS, _MOST):
        short = round(value, decimals)
        if all(_order(short, other) == _order(value, other) for other in others):
            return repr(short).removesuffix(".0")
    return repr(value)


def _order(value: float, other: float) -> int:
    return (value > other) - (value < other)
