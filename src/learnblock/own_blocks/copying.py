"""A copy of a block, whose functions have other names: no two skills share one."""

import re
from collections.abc import Collection, Mapping
from dataclasses import replace

from learnblock import skill_files
from learnblock.blocks.written import written
from learnblock.own_blocks import chosen as choices
from learnblock.skill_names import places, replaced


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
    # One that is written in an unusual way stays, and the check of the copy tells it.
    return replaced(source, (one for one in places(tree, source, names) if one.is_plain), names)


def renamed_configuration(configuration: str, names: Mapping[str, str]) -> str:
    """A configuration of the functions under their other names; one that is wrong stays so."""
    blocks, wrong = choices.read(configuration)
    if wrong or not blocks:
        return configuration
    return written(replace(one, name=names.get(one.name, one.name)) for one in blocks)
