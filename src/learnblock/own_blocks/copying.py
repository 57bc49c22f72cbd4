"""A copy of a block, whose functions have other names: no two skills share one."""

import ast
import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace

from learnblock import skill_files
from learnblock.blocks.written import written
from learnblock.own_blocks import chosen as choices


def new_names(functions: Collection[str], wish: str, taken: Collection[str]) -> Mapping[str, str]:
    """A free name for each function: the only one is called as the copy, if it can be."""
    plain = re.sub(r"\W+", "_", wish).strip("_")
    wishes = {name: name for name in functions}
    if len(functions) == 1 and plain.isidentifier() and not re.match(r"\d", plain):
        wishes = dict.fromkeys(functions, plain)
    used = {*taken, *functions}
    found: dict[str, str] = {}
    for name, wished in wishes.items():
        found[name] = _free(wished, used)
        used.add(found[name])
    return found


def _free(wish: str, used: Collection[str]) -> str:
    numbered = (f"{wish}_{number}" for number in range(2, len(used) + 3))
    return next(name for name in (wish, *numbered) if name not in used)


def renamed_source(source: str, names: Mapping[str, str]) -> str:
    """A source in which functions have other names, wherever it speaks of them.

    Raises:
        ProgramError: it is no Python.
    """
    tree = skill_files.parse(source, "block.py")
    # From the end, so that what is still to be changed stays where it was.
    places = sorted(_places(tree, names), reverse=True)
    lines = [line.encode() for line in source.split("\n")]
    for row, column, name in places:
        line = lines[row - 1]
        at = line.find(name.encode(), column)
        lines[row - 1] = line[:at] + names[name].encode() + line[at + len(name.encode()) :]
    return b"\n".join(lines).decode()


def _places(tree: ast.Module, names: Collection[str]) -> Iterator[tuple[int, int, str]]:
    """Line, and byte of the line at or before which a name begins."""
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef(name=name) if name in names:
                yield node.lineno, node.col_offset + len("def"), name
            case ast.Name(id=name) if name in names:
                yield node.lineno, node.col_offset, name
            case ast.Attribute(value=ast.Name(id="robot") as robot, attr=name) if name in names:
                if node.end_lineno == robot.end_lineno and robot.end_col_offset is not None:
                    yield node.lineno, robot.end_col_offset, name


def renamed_configuration(configuration: str, names: Mapping[str, str]) -> str:
    """A configuration of the functions under their other names; one that is wrong stays so."""
    blocks, wrong = choices.read(configuration)
    if wrong or not blocks:
        return configuration
    return written(replace(one, name=names.get(one.name, one.name)) for one in blocks)
