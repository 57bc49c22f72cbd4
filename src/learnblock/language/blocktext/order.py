"""Put definitions and events above the statements that use them.

In Block-Text and in blocks a definition counts wherever it is, as `main` does; Python runs a file
from top to bottom. A program whose order already works keeps it.
"""

import ast
from collections.abc import Iterable, Iterator, Sequence

from learnblock.language.blocktext.names import from_python, state_of, stem
from learnblock.language.tree.layout import prologue_length
from learnblock.language.tree.loads import Function, loaded_names, parsed
from learnblock.language.tree.markers import defined_names
from learnblock.language.tree.nodes import (
    Activate,
    AnyPython,
    Blank,
    Body,
    Call,
    Comment,
    Deactivate,
    Def,
    Expression,
    Item,
    Main,
    Name,
    PythonBlock,
    Raw,
    RawExpression,
    Setup,
    When,
    WithoutRobot,
)
from learnblock.language.tree.traversal import all_expressions, statements_at_once

#: What identifies a definition.
Key = tuple[type[Def | When], str]


def definitions_first(items: Sequence[Item | Main]) -> list[Item | Main]:
    """The items of the top level, with definitions above the statements that use them.

    If a statement uses a definition below it, all definitions below move above it, in their order,
    each with the comments directly above it. They move past the whole run of statements, so that
    this stays one stack of blocks. A program without a robot keeps its order, as Python does.
    """
    if any(isinstance(item, WithoutRobot) for item in items):
        return list(items)
    place = _first_early_use(items)
    if place is None:
        return list(items)
    top = _top(items, place)
    moved: list[Item | Main] = []
    remaining: list[Item | Main] = []
    for item in items[top:]:
        if isinstance(item, Def | When):
            lead = _comments_at_end(remaining)
            moved += remaining[len(remaining) - lead :]
            del remaining[len(remaining) - lead :]
            moved.append(item)
        else:
            remaining.append(item)
    return [*items[:top], *moved, *remaining]


def _first_early_use(items: Sequence[Item | Main]) -> int | None:
    """The place of the first statement that uses a definition below it."""
    places = {_key(item): place for place, item in enumerate(items) if isinstance(item, Def | When)}
    if not places:
        return None
    last = max(places.values())
    uses = _Uses(items)
    known: set[Key] = set()
    for place, item in enumerate(items[:last]):
        if isinstance(item, Def | When):
            known.add(_key(item))
        elif not isinstance(item, Main | Setup) and uses.of(item) - known:
            return place
    return None


def _top(items: Sequence[Item | Main], place: int) -> int:
    """Where a run of statements begins: below the definition or the setup above it."""
    above = (i + 1 for i in range(place) if isinstance(items[i], Def | When | Setup))
    heading = [item for item in items if not isinstance(item, Main)]
    top = max([prologue_length(heading), *above])
    while top < place and isinstance(items[top], Blank):
        top += 1
    return top


def _comments_at_end(items: Sequence[Item | Main]) -> int:
    count = 0
    while count < len(items) and isinstance(items[-1 - count], Comment):
        count += 1
    return count


def _key(item: Def | When) -> Key:
    return type(item), item.name


class _Uses:
    """Finds the definitions that statements use, also through the functions that they call."""

    def __init__(self, items: Sequence[Item | Main]) -> None:
        named = [item for item in items if isinstance(item, Def | When)]
        self.definitions = {_key(item): item for item in named}
        self.whens = {item.name for item in named if isinstance(item, When)}
        self.in_raw = _raw_functions(item for item in items if isinstance(item, Raw))
        self.in_blocks = dict(_functions_in_blocks(items))

    def of(self, item: Item) -> set[Key]:
        """The definitions that must exist when a statement runs."""
        if isinstance(item, Raw) and "robot.run(" in item.text:
            return set(self.definitions)
        keys: set[Key] = set()
        ahead = set(self.named((item,)))
        while ahead:
            key = ahead.pop()
            if key not in keys:
                keys.add(key)
                ahead.update(self.within(key))
        return keys & self.definitions.keys()

    def within(self, key: Key) -> Iterator[Key]:
        """What a call of a function uses; an event only runs at the end of the program."""
        definition = self.definitions.get(key)
        if isinstance(definition, Def):
            yield from self.named(definition.body)
        elif definition is None and key[0] is Def and key[1] in self.in_raw:
            for statement in self.in_raw[key[1]]:
                yield from _keys(statement)
        elif definition is None and key[0] is Def and key[1] in self.in_blocks:
            yield from self.named(self.in_blocks[key[1]])

    def named(self, body: tuple[Item, ...]) -> Iterator[Key]:
        for statement in statements_at_once(body):
            if isinstance(statement, Activate | Deactivate):
                yield When, statement.name
            elif isinstance(statement, AnyPython):
                yield from _keys_in(statement.text)
            for node in all_expressions(statement):
                yield from self.named_in(node)

    def named_in(self, node: Expression) -> Iterator[Key]:
        if isinstance(node, Call):
            yield Def, node.name
        elif isinstance(node, Name) and self.whens:
            state = state_of(node.name, self.whens)
            if state is not None:
                yield When, state[0]
        elif isinstance(node, RawExpression):
            yield from _keys_in(node.text)


def _functions_in_blocks(items: Iterable[Item | Main]) -> Iterator[tuple[str, Body]]:
    """The bodies of the functions and classes in blocks of Python, by their names."""
    for item in items:
        if isinstance(item, PythonBlock) and item.has_scope:
            for name in defined_names(f"{item.parts[0].header}: pass"):
                plain = from_python(name)
                if plain is not None:
                    yield plain, _within(item)


def _within(block: PythonBlock) -> Body:
    """The statements of a function, and those of the methods of a class."""
    body = block.parts[0].body
    methods = (item for item in body if isinstance(item, PythonBlock) and item.defers)
    return (*body, *(statement for method in methods for statement in method.parts[0].body))


def _raw_functions(raw: Iterable[Raw]) -> dict[str, list[ast.stmt]]:
    """The bodies of the functions that parts in raw Python define, by their names in Block-Text."""
    return {
        name: node.body
        for statement in raw
        for node in ast.walk(parsed(statement.text))
        if isinstance(node, Function) and (name := from_python(node.name)) is not None
    }


def _keys_in(text: str) -> Iterator[Key]:
    yield from _keys(parsed(text.strip()))


def _keys(node: ast.AST) -> Iterator[Key]:
    for name in loaded_names(node):
        plain = from_python(name)
        if plain is not None:
            yield Def, plain
            yield When, stem(plain)
