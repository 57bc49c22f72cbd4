"""Which functions call each other, in time that grows with the number of calls."""

from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Mapping

Calls = Mapping[str, Collection[str]]


def cycles(calls: Calls) -> dict[str, int]:
    """Number the functions; those that call each other in a circle have the same number."""
    callers = _callers(calls)
    # Kosaraju's algorithm: from the one that returns last, only its circle leads back to it.
    order: list[str] = []
    seen: set[str] = set()
    for name in calls:
        order += _in_order_of_return(name, calls, seen)
    numbers: dict[str, int] = {}
    seen = set()
    for number, name in enumerate(reversed(order)):
        numbers |= dict.fromkeys(_in_order_of_return(name, callers, seen), number)
    return numbers


def recursive(calls: Calls) -> set[str]:
    """The functions that call themselves, also through others."""
    numbers = cycles(calls)
    sizes = Counter(numbers.values())
    return {name for name, called in calls.items() if name in called or sizes[numbers[name]] > 1}


def callers_of(names: Iterable[str], calls: Calls) -> set[str]:
    """Some functions, and all that call them, also through others."""
    return reachable(names, _callers(calls))


def reachable(names: Iterable[str], calls: Calls) -> set[str]:
    """Some functions, and all that they call, also through others."""
    reached = set(names)
    ahead = list(reached)
    while ahead:
        more = set(calls.get(ahead.pop(), ())) - reached
        reached |= more
        ahead += more
    return reached


def _callers(calls: Calls) -> Calls:
    callers = defaultdict(list)
    for caller, called in calls.items():
        for name in called:
            callers[name].append(caller)
    return callers


def _in_order_of_return(name: str, calls: Calls, seen: set[str]) -> list[str]:
    """A function and those that it reaches, each after what it calls; without those `seen`."""
    if name in seen:
        return []
    seen.add(name)
    order: list[str] = []
    ahead = [(name, iter(calls.get(name, ())))]
    while ahead:
        caller, rest = ahead[-1]
        inner = next((other for other in rest if other not in seen), None)
        if inner is None:
            order.append(caller)
            ahead.pop()
        else:
            seen.add(inner)
            ahead.append((inner, iter(calls.get(inner, ()))))
    return order
