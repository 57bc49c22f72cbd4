"""A copy of a custom block; its functions get new names, because skills cannot share one."""

import re
from collections.abc import Collection, Mapping
from dataclasses import replace

from learnblock.blocks.schema.writing import written
from learnblock.extensions.custom_blocks import chosen as choices
from learnblock.extensions.skill_names import places, replaced
from learnblock.storage import skill_files


def new_names(functions: Collection[str], wish: str, others: Collection[str]) -> Mapping[str, str]:
    """A free name for each function; if there is only one, the name of the copy if possible."""
    plain = re.sub(r"\W+", "_", wish).strip("_")
    wishes = {name: name for name in functions}
    if len(functions) == 1 and plain.isidentifier() and not re.match(r"\d", plain):
        wishes = dict.fromkeys(functions, plain)
    unavailable = {*others, *functions}
    names: dict[str, str] = {}
    for name, wished in wishes.items():
        names[name] = _free(wished, unavailable)
        unavailable.add(names[name])
    return names


def _free(wish: str, unavailable: Collection[str]) -> str:
    numbered = (f"{wish}_{number}" for number in range(2, len(unavailable) + 3))
    return next(name for name in (wish, *numbered) if name not in unavailable)


def renamed_source(source: str, names: Mapping[str, str]) -> str:
    """A source with its functions renamed, also in calls.

    Raises:
        ProgramError: it is not valid Python.
    """
    tree = skill_files.parse(source, "block.py")
    # A name spelled in an unusual form of Unicode is not renamed; the check of the copy reports it.
    return replaced(
        source, (place for place in places(tree, source, names) if place.is_plain), names
    )


def renamed_configuration(configuration: str, names: Mapping[str, str]) -> str:
    """A configuration with the functions renamed; an invalid one is returned unchanged."""
    blocks, wrong = choices.read(configuration)
    if wrong or not blocks:
        return configuration
    return written(replace(block, name=names.get(block.name, block.name)) for block in blocks)
