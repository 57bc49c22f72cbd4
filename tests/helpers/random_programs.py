"""Random programs that run: every kind of statement, skills with values, and a random twin."""

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from learnblock.blocks import builtin
from runs import TWINS

#: Values for parameters without a default, by their type.
VALUES = {
    "angle": "20",
    "apriltext": "1",
    "boolean": "True",
    "float": "40",
    "int": "3",
    "string": '"CAMERA"',
}
#: Skills that only work together with other robots or a person.
LEFT_OUT = frozenset(("received", "message_value"))
WORLDS = ("arena", "faces", "labyrinth", "line", "obstacles", "square", "table", "tags", "walls")
NUMBERS = ("x", "y", "n")
LISTS = ("values", "others")
#: Conditions on what the robot measures.
SEEN = (
    "function.is_front_obstacle(300)",
    "function.get_min_distance() < 200",
    "function.is_there_black_line()",
    "function.is_any_tag()",
    "elapsedTime(2)",
)
RAW = (
    "x, y = y, x",
    "values, others = others, values",
    "values = [one * 2 for one in values]",
    "try:\n    x = 1 / (n - n)\nexcept ZeroDivisionError as error:\n    y = str(error)",
    "(x := n + 1)",
    "for i, (x, y) in enumerate([(1, 2), (3, 4)]):\n    robot.sleep(0.05)",
    "table = {'a': [1]}\ntable['a'].append(x)",
    "values += [x]\ndel values[:1]",
    "with open(__file__ + 'x', 'w') if False else __import__('contextlib').nullcontext(3) as z:\n"
    "    robot.sleep(0.03)",
)


def call(rng: random.Random) -> str:
    """A call of a random skill, with values where it needs some."""
    skill = builtin()[rng.choice(sorted(builtin().keys() - LEFT_OUT))]
    arguments = ", ".join(
        VALUES[parameter.type] for parameter in skill.parameters if parameter.required
    )
    called = f"function.{skill.name}({arguments})"
    return f"x = {called}" if skill.returns_value else called


@dataclass(frozen=True)
class RandomProgram:
    """A program, and where it runs.

    Args:
        text: its Block-Text.
        robot: a twin.
        world: the world.
    """

    text: str
    robot: str
    world: str


def random_program(seed: int) -> RandomProgram:
    """A random program with functions, whens, loops and lists."""
    return _Writing(random.Random(seed)).program()  # noqa: S311 - not a secret


class _Writing:
    """Writes one program."""

    def __init__(self, rng: random.Random) -> None:
        self._rng = rng
        self._choice = rng.choice
        self._statements: tuple[Callable[[int], Iterator[str]], ...] = (
            self._assign,
            self._assign,
            self._list,
            self._skill,
            self._skill,
            self._wait,
            self._wait,
            self._show,
            self._call,
            self._raw,
            self._if,
            self._repeat,
            self._for,
            self._while,
        )

    def program(self) -> RandomProgram:
        has_whens = self._rng.random() < 0.4
        parts = [
            "x = 0\ny = 1\nn = 2\nvalues = [1, 2]\nothers = values\nglobal_count = 0",
            "def step(n, values):\n"
            + _inside([*self._block(1), "z = n + 1", "function.sleep(0.07)", "return z"])
            + "end",
            "def down(n):\n    if n > 0:\n        function.sleep(0.02)\n        down(n - 1)\n"
            "    end\nend",
        ]
        parts += [self._when(name) for name in ("near", "often")] if has_whens else []
        head = "when start:" if has_whens else "main:"
        body = [line for _ in range(self._rng.randint(3, 7)) for line in self._block(2)]
        parts.append(f"{head}\n{_inside(body)}end")
        return RandomProgram("\n\n".join(parts) + "\n", self._choice(TWINS), self._choice(WORLDS))

    def _when(self, name: str) -> str:
        condition = self._choice((f" = {self._condition()}", ""))
        body = [*self._block(1), "function.sleep(0.05)"]
        body += ["deactivate near"] if self._rng.random() < 0.2 else []
        return f"when {name}{condition}:\n{_inside(body)}end"

    def _block(self, depth: int) -> list[str]:
        choices = self._statements if depth > 0 else self._statements[:-4]
        return [*self._choice(choices)(depth - 1)]

    def _number(self) -> str:
        leaf = self._choice((*NUMBERS, "3", "0.5", "-2", "len(values)", "random(1, 9)"))
        other = self._choice((*NUMBERS, "2", "7"))
        return self._choice((leaf, f"{leaf} + {other}", f"{leaf} * {other}", f"[{leaf}][0]"))

    def _condition(self) -> str:
        plain = f"{self._choice(NUMBERS)} {self._choice(('<', '>', '=='))} {self._number()}"
        return self._choice((plain, self._choice(SEEN), f"{plain} and {self._choice(SEEN)}"))

    def _assign(self, _: int) -> Iterator[str]:
        sign = self._choice(("=", "=", "+=", "-="))
        yield f"{self._choice(NUMBERS)} {sign} {self._number()}"

    def _list(self, _: int) -> Iterator[str]:
        name, other = self._rng.sample(LISTS, 2)
        yield self._choice(
            (
                f"append({name}, {self._number()})",
                f"{name} = {other}",
                f"{name} = [{self._number()}, {self._number()}]",
                f"{name} = [[1], {{2: 3}}, 'a']",
                f"if len({name}) > 0:\n    {name}[0] = {self._number()}\nend",
                f"{name} = {{'a': {self._number()}}}\n{name}['b'] = 3\n{name} = [1]",
                f"copy_of = {name}",
            )
        )

    def _skill(self, _: int) -> Iterator[str]:
        yield call(self._rng)

    def _wait(self, _: int) -> Iterator[str]:
        yield self._choice(
            (
                "function.sleep(0.2)",
                "function.sleep(0.01)",
                "function.sleep(1)",
                "function.turn(30)",
            )
        )

    def _show(self, _: int) -> Iterator[str]:
        yield self._choice((f"print({self._number()}, values)", 'print("ñ 🤖", end="")'))

    def _call(self, _: int) -> Iterator[str]:
        yield self._choice((f"y = step({self._number()}, values)", "down(3)", "step(1, others)"))

    def _raw(self, _: int) -> Iterator[str]:
        yield f"python:\n{_inside([self._choice(RAW)])}end"

    def _if(self, depth: int) -> Iterator[str]:
        yield f"if {self._condition()}:\n{_inside(self._block(depth))}"
        if self._rng.random() < 0.3:
            yield f"elif {self._condition()}:\n{_inside(self._block(depth))}"
        if self._rng.random() < 0.5:
            yield f"else:\n{_inside(self._block(depth))}"
        yield "end"

    def _repeat(self, depth: int) -> Iterator[str]:
        body = [*self._block(depth), *self._block(depth), "function.sleep(0.03)"]
        yield f"repeat {self._rng.randint(0, 20)}:\n{_inside(body)}end"

    def _for(self, depth: int) -> Iterator[str]:
        head = self._choice(("for i from 0 to 4:", "for one in values:", "for one in [3, 2, 1]:"))
        jump = self._choice((f"if {self._condition()}:\n    break\nend", "pass"))
        yield f"{head}\n{_inside([*self._block(depth), jump, 'function.sleep(0.04)'])}end"

    def _while(self, depth: int) -> Iterator[str]:
        body = [*self._block(depth), "function.sleep(0.05)", "turns -= 1"]
        yield f"turns = {self._rng.randint(1, 30)}"
        yield f"while turns > 0:\n{_inside(body)}end"


def _inside(statements: list[str]) -> str:
    lines = "\n".join(statements).splitlines()
    return "".join(f"    {line}\n" for line in lines)
