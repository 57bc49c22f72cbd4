"""The names of the robots of a run."""

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import count


def robot_names(wishes: Sequence[str]) -> Iterator[str]:
    """The name of each robot: the one that it asks for, with a number if several ask for it.

    >>> list(robot_names(["swarm", "swarm", "swarm-1"]))
    ['swarm-2', 'swarm-3', 'swarm-1']
    """
    uses = Counter(wishes)
    unique = {wish for wish in wishes if uses[wish] == 1}
    numbers = {wish: count(1) for wish in uses}
    for wish in wishes:
        if uses[wish] == 1:
            yield wish
        else:
            numbered = (f"{wish}-{number}" for number in numbers[wish])
            yield next(name for name in numbered if name not in unique)
