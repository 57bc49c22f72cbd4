"""Random programs whose definitions, events and uses are in any order, in two notations.

Each comes from one random number: `Ordered(seed)` reproduces it.
"""

import random

FUNCTIONS = ("f0", "f1", "f2")
EVENTS = ("start", "e0", "e1")
VARIABLES = ("x", "y", "i", "time_e0", "state_e1")
#: A statement in Block-Text and in Python.
Lines = tuple[list[str], list[str]]


class Ordered:
    """A random program; `blocktext` and `python` have the same items in the same order."""

    def __init__(self, seed: int) -> None:
        self._rng = random.Random(seed)  # noqa: S311 - no secret
        self.choice = self._rng.choice
        # Most programs are sensible, so that the check passes them.
        self._variables = ("x", "y", *(VARIABLES[2:] if self._is(0.2) else ()))
        self._parameters = {name: self._parameter() for name in FUNCTIONS}
        parts = [self._function(place) for place in range(len(FUNCTIONS)) if self._is(0.95)]
        parts += [self._event(name) for name in EVENTS if name != "start" or self._is(0.5)]
        parts += [self._statement(2, FUNCTIONS) for _ in range(self._rng.randint(1, 4))]
        self._rng.shuffle(parts)
        first = [([f"{name} = 1"], [f"{name} = 1"]) for name in ("x", "y")]
        parts = [*first, *parts] if self._is(0.6) else [*parts, *first]
        main = self._body(FUNCTIONS) if self._is(0.4) else None
        self.blocktext = _text([blocktext for blocktext, _ in parts])
        self.python = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n\n" + _text(
            [python for _, python in parts]
        )
        if main is not None:
            self.blocktext += _text([["main:", *_inside(main[0]), "end"]])
            self.python += _text([["# main", *main[1]]])
        if "@robot.when" in self.python:
            self.python += "\nrobot.run()\n"

    def _is(self, chance: float) -> bool:
        return self._rng.random() < chance

    def _parameter(self) -> str:
        return self.choice(("n", "x", "time_e0")) if self._is(0.2) else ""

    def _function(self, place: int) -> Lines:
        name, parameter = FUNCTIONS[place], self._parameters[FUNCTIONS[place]]
        blocktext, python = self._body(FUNCTIONS[place + 1 :])
        prints = [f"print({parameter})"] if parameter else []
        result = ["return 1"] if self._is(0.3) else []
        declared = _globals(python, parameter)
        return (
            [f"def {name}({parameter}):", *_inside([*prints, *blocktext, *result]), "end"],
            [f"def {name}({parameter}):", *_inside([*declared, *prints, *python, *result])],
        )

    def _event(self, name: str) -> Lines:
        blocktext, python = self._body(FUNCTIONS)
        leave = ["return"] if self._is(0.2) else []
        condition = self._value() if name != "start" and self._is(0.6) else None
        head = "@robot.when_start" if name == "start" else "@robot.when"
        if condition is not None:
            head += f"(lambda: {condition[1]})"
        equals = "" if condition is None else f" = {condition[0]}"
        return (
            [f"when {name}{equals}:", *_inside([*blocktext, *leave]), "end"],
            [head, f"def {name}():", *_inside([*_globals(python, ""), *python, *leave])],
        )

    def _body(self, callees: tuple[str, ...]) -> Lines:
        parts = [self._statement(1, callees) for _ in range(self._rng.randint(1, 2))]
        return [line for lines, _ in parts for line in lines], [
            line for _, lines in parts for line in lines
        ]

    def _statement(self, depth: int, callees: tuple[str, ...]) -> Lines:
        kinds = [self._set, self._set, self._show, self._show, self._change]
        kinds += [self._loop, self._branch] if depth else []
        kinds += [self._call] * 3 if callees else []
        return self.choice(kinds)(depth - 1, callees)

    def _set(self, _: int, __: tuple[str, ...]) -> Lines:
        blocktext, python = self._value()
        name, sign = self.choice(self._variables), self.choice(("=", "=", "+="))
        return [f"{name} {sign} {blocktext}"], [f"{name} {sign} {python}"]

    def _show(self, _: int, __: tuple[str, ...]) -> Lines:
        blocktext, python = self._value()
        return [f"print({blocktext})"], [f"print({python})"]

    def _call(self, _: int, callees: tuple[str, ...]) -> Lines:
        call = self._called(self.choice(callees))
        return [call], [call]

    def _called(self, function: str) -> str:
        argument = "3" if bool(self._parameters[function]) is self._is(0.98) else ""
        return f"{function}({argument})"

    def _change(self, _: int, __: tuple[str, ...]) -> Lines:
        word, event = self.choice(("activate", "deactivate")), self.choice(EVENTS[1:])
        return [f"{word} {event}"], [f"{event}.{word}()"]

    def _loop(self, depth: int, callees: tuple[str, ...]) -> Lines:
        blocktext, python = self._statement(depth, callees)
        return (
            ["for i from 0 to 1:", *_inside(blocktext), "end"],
            ["for i in range(2):", *_inside(python)],
        )

    def _branch(self, depth: int, callees: tuple[str, ...]) -> Lines:
        blocktext, python = self._statement(depth, callees)
        return ["if 1 > 0:", *_inside(blocktext), "end"], ["if 1 > 0:", *_inside(python)]

    def _value(self) -> tuple[str, str]:
        plain = self.choice(("1", "2", *self._variables, *self._variables))
        event = self.choice(EVENTS[1:])
        states = ((f"time_{event}", f"{event}.time"), (f"state_{event}", f"{event}.active"))
        return self.choice(((plain, plain), (plain, plain), *states[:1], *states[1:]))


def _globals(body: list[str], parameter: str) -> list[str]:
    """The declaration of the variables that a function of Python sets and shares."""
    words = [line.split() for line in body]
    names = {
        line_words[0]
        for line_words in words
        if len(line_words) > 1 and line_words[1] in {"=", "+="}
    }
    shared = sorted(names - {parameter, "i"})
    return [f"global {', '.join(shared)}"] if shared else []


def _inside(lines: list[str]) -> list[str]:
    return [f"    {line}" for line in lines]


def _text(parts: list[list[str]]) -> str:
    return "".join("\n".join(part) + "\n\n" for part in parts)
