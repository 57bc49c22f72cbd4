"""The names that a program defines, and where."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from learnblock.language.blocktext.names import state_of
from learnblock.language.tree.markers import defined_names, raw_names, set_names
from learnblock.language.tree.nodes import (
    AnyPython,
    Def,
    Item,
    Main,
    Name,
    Program,
    Span,
    When,
)
from learnblock.language.tree.traversal import all_expressions, locals_in, statements, targets


@dataclass(frozen=True)
class Symbols:
    """The names of a program.

    Variables belong to the whole program, except for the parameters of a function, and the loop
    variables of ``for`` and what is ``local`` in a function or a ``when``.

    Args:
        program: the tree.
    """

    program: Program

    @cached_property
    def functions(self) -> dict[str, Def]:
        """The user's functions."""
        return self.program.functions

    @cached_property
    def whens(self) -> dict[str, When]:
        """The ``when``s."""
        return self.program.whens

    @cached_property
    def variables(self) -> dict[str, Span]:
        """The variables of the whole program, and where each is first set, else first read."""
        read: dict[str, Span] = {}
        written: dict[str, Span] = {}
        for item in self.items:
            own = self.own(item)
            for name in names_in(item):
                if name.name not in own and state_of(name.name, self.whens.keys()) is None:
                    read.setdefault(name.name, name.span)
            for name in _targets(item):
                if name.name not in own:
                    written.setdefault(name.name, name.span)
        return {name: written.get(name, span) for name, span in read.items()}

    @cached_property
    def in_python(self) -> set[str]:
        """The names that raw Python uses."""
        raw = (node.text for node in statements(self.items) if isinstance(node, AnyPython))
        return {name for text in raw for name in raw_names(text)}

    @cached_property
    def set_in_python(self) -> set[str]:
        """The names that lines of Python set, import and define, as spelled there."""
        raw = (node.text for node in statements(self.items) if isinstance(node, AnyPython))
        return {name for text in raw for name in defined_names(text) | set_names(text)}

    @cached_property
    def items(self) -> tuple[Item, ...]:
        """The items of the top level, followed by the statements of `main`."""
        return self.program.items + (self.program.main.body if self.program.main else ())

    def own(self, item: Item | Main) -> dict[str, Span]:
        """The local variables of a function or a ``when``, and where each is defined."""
        if not isinstance(item, Def | When):
            return {}
        parameters = dict.fromkeys(item.parameters, item.span) if isinstance(item, Def) else {}
        own = {name: target.span for name, target in locals_in(item.body).items()}
        return own | parameters

    def owner(self, line: int) -> Def | When | None:
        """The function or ``when`` at a line of the source."""
        for item in self.program.items:
            if isinstance(item, Def | When) and item.span.line <= line <= item.span.end_line:
                return item
        return None


def names_in(item: Item) -> Iterator[Name]:
    """Every variable that is set or read in an item of the top level."""
    for node in statements((item,)):
        yield from (
            expression for expression in all_expressions(node) if isinstance(expression, Name)
        )


def _targets(item: Item) -> Iterator[Name]:
    for node in statements((item,)):
        yield from targets(node)
