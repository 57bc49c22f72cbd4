"""A shop of pets, as a book about Python has it."""

from collections import Counter
from random import choice as pick

SOUNDS = {"dog": "wuff", "cat": "miaow"}


class Pet:
    """A pet with a name."""

    def __init__(self, name, kind="dog", *tricks, hungry: bool = True):
        self.name, self.kind = name, kind
        self.tricks = list(tricks)
        self.hungry = hungry

    @property
    def sound(self):
        return SOUNDS.get(self.kind, "?")

    def feed(self, food):
        if food is None:
            raise ValueError("no food")
        self.hungry = False


def describe(pets):
    lines = [f"{pet.name:>6}: {pet.sound}" for pet in pets if not pet.hungry]
    kinds = Counter([pet.kind for pet in pets])
    first, *rest = sorted(kinds, key=lambda kind: -kinds[kind])
    for line in lines:
        print(line)
    return first, len(rest)


def factorial(n):
    if n == 0:
        return 1
    smaller = factorial(n - 1)
    return n * smaller


pets = [Pet("Ana"), Pet("Luis", "cat", "jump", hungry=False)]
try:
    pets[0].feed("bone")
    pick(pets).feed(None)
except ValueError as error:
    print(error)
else:
    print("all fed")
finally:
    print(describe(pets)[0])
print(factorial(5), 0 < factorial(3) < 10)
