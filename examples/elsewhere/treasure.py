"""A walk to a treasure, as a book about Python may have it: no robot and nothing of LearnBlock."""

from math import hypot

STEPS = {"north": (0, 1), "east": (1, 0), "south": (0, -1), "west": (-1, 0)}
TREASURE = (3, 4)


class Walker:
    """Someone who walks over a map, and knows the way back."""

    def __init__(self, x=0, y=0):
        self.x, self.y = x, y
        self.ways = []

    def walk(self, way, steps):
        across, up = STEPS[way]
        self.x += across * steps
        self.y += up * steps
        self.ways.append((way, steps))

    def distance(self, place):
        return hypot(place[0] - self.x, place[1] - self.y)


def answer(walker, command):
    """Do what a line says, and say what happened."""
    match command.split():
        case []:
            return "Say where to go."
        case ["dig"] if (walker.x, walker.y) == TREASURE:
            return "Found it!"
        case ["dig"]:
            return f"Nothing here. It is {walker.distance(TREASURE):.1f} steps away."
        case [way, steps] if way in STEPS:
            try:
                walker.walk(way, int(steps))
            except ValueError:
                return f"How many steps is {steps}?"
            return f"You are at {walker.x}, {walker.y}."
        case [word, *_]:
            return f"I don't know how to {word}."


def way_back(ways):
    """The ways home, the last one first."""
    if not ways:
        return []
    (way, steps), *rest = ways
    names = list(STEPS)
    opposite = names[(names.index(way) + 2) % len(names)]
    return [*way_back(rest), f"{opposite} {steps}"]


if __name__ == "__main__":
    walker = Walker()
    for command in ("", "fly", "north 4", "east two", "dig", "east 3", "dig"):
        print(f"> {command}")
        print(answer(walker, command))
    home = way_back(walker.ways)
    for command in home:
        answer(walker, command)
    assert walker.distance((0, 0)) == 0
    print("Home again:", ", ".join(home))
