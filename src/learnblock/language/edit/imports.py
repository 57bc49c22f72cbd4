"""Find the libraries that a program imports and uses, and add imports."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

from learnblock.blocks import BlockConfiguration
from learnblock.language.tree.layout import prologue_length
from learnblock.language.tree.nodes import Blank, Import, Program, SkillCall
from learnblock.language.tree.traversal import all_expressions, statements


def with_import(program: Program, module: str) -> Program:
    """Add the import of a library below the other imports."""
    if module in imported(program):
        return program
    items = program.items
    place = prologue_length(items)
    if place and isinstance(items[place - 1], Import):
        items = (*items[:place], Import(module), *items[place:])
    else:
        heading = items[: place + 1] if items[place : place + 1] == (Blank(),) else items[:place]
        items = (*heading, Import(module), *items[len(heading) :])
    return replace(program, items=items, python=None)


def imported(program: Program) -> frozenset[str]:
    """The libraries that a program imports."""
    return frozenset(item.module for item in program.items if isinstance(item, Import))


def libraries_used(
    program: Program, configurations: Mapping[str, BlockConfiguration]
) -> frozenset[str]:
    """The libraries whose skills a program calls, whether it imports them or not."""
    modules = (configurations.get(name) for name in _skills(program))
    return frozenset(module.library for module in modules if module is not None and module.library)


def _skills(program: Program) -> Iterator[str]:
    main = program.main.body if program.main else ()
    for statement in statements((*program.items, *main)):
        for node in all_expressions(statement):
            if isinstance(node, SkillCall):
                yield node.name
