"""Which of several guesses comes first.

Each rule has a weight: the surer and the more useful to the pupil, the larger. What the program's
text alone proves comes before what the run shows, and that before what the robot's way suggests.
"""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from learnblock.lessons.hints.guess import Guess

WEIGHTS: Mapping[str, int] = MappingProxyType(
    {
        "error": 100,
        "empty": 98,
        "never-started": 92,
        "not-called": 91,
        "unreachable": 90,
        "message-name": 88,
        "text-almost": 87,
        "no-wait": 86,
        "repetition": 85,
        "too-large": 84,
        "impossible-condition": 83,
        "wrong-side": 82,
        "unchanged-variable": 81,
        "used-too-often": 80,
        "not-used": 79,
        "no-loop": 79,
        "checked-once": 78,
        "loop-without-wait": 77,
        "empty-body": 76,
        "never-ends": 74,
        "opposite-condition": 73,
        "motors-on": 72,
        "other-robot": 71,
        "wrong-order": 70,
        "wrong-sign": 66,
        "wrong-direction": 66,
        "never-asks": 64,
        "only-here": 63,
        "never-runs": 62,
        "collision": 61,
        "forbidden": 60,
        "never-stands": 59,
        "wrong-text": 58,
        "not-shown": 58,
        "event-missing": 57,
        "no-turn": 57,
        "too-few-times": 55,
        "too-many-times": 55,
        "value-too-small": 52,
        "value-too-large": 52,
        "lost-line": 50,
        "never-moved": 48,
        "too-early": 40,
        "too-late": 38,
        "look-again": 1,
    }
)


def weight(guess: Guess) -> int:
    """The weight of a guess: that of its rule, and what the run adds."""
    return WEIGHTS[guess.rule] + guess.surely


def ranked(guesses: Iterable[tuple[int, Guess]]) -> list[tuple[int, Guess]]:
    """Guesses with the place of their check, best first; of each rule only the best.

    Of two with the same weight, that of the first check comes first, then that of the first line.
    """
    ordered = sorted(guesses, key=lambda pair: (-weight(pair[1]), pair[0], pair[1].lines))
    best: dict[str, tuple[int, Guess]] = {}
    for check, guess in ordered:
        best.setdefault(guess.rule, (check, guess))
    return list(best.values())
