"""Blocks that are one block in two directions, such as `turn_left` and `turn_right`.

Both have the same sentence and the same parameters, and differ in the sign of a default that the
sentence says as a word. The page shows one of them in the palette; choosing the other word in the
block calls the other function.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from learnblock.blocks.schema.configuration import NEGATIVE, POSITIVE, BlockConfiguration, Parameter


@dataclass(frozen=True, slots=True)
class BlockPair:
    """Two blocks that are one in two directions.

    Args:
        parameter: the name of the number whose sign is the direction.
        first: the name of the function that comes first in the palette, which shows only this one.
        names: the names of the functions, by ``positive`` and ``negative``.
    """

    parameter: str
    first: str
    names: Mapping[str, str]


def pairs(configurations: Iterable[BlockConfiguration]) -> dict[str, BlockPair]:
    """The pairs in the configurations, by the name of each of their functions."""
    alike: dict[str, list[BlockConfiguration]] = {}
    for configuration in configurations:
        if _turned(configuration) is not None:
            alike.setdefault(_said(configuration), []).append(configuration)
    all_pairs = filter(None, map(_pair, alike.values()))
    return {name: pair for pair in all_pairs for name in pair.names.values()}


def _pair(group: list[BlockConfiguration]) -> BlockPair | None:
    names = {_direction(configuration): configuration.name for configuration in group}
    parameter = _turned(group[0])
    if len(group) != len(names) or len(names) == 1 or parameter is None:
        return None
    return BlockPair(parameter.name, group[0].name, names)


def _direction(block: BlockConfiguration) -> str:
    parameter = _turned(block)
    return NEGATIVE if parameter is not None and _number(parameter) < 0 else POSITIVE


def _turned(block: BlockConfiguration) -> Parameter | None:
    """The only parameter with words for its sign and a default with one."""
    candidates = [
        parameter
        for parameter in block.parameters
        if parameter.directions and _number(parameter) != 0
    ]
    return candidates[0] if len(candidates) == 1 else None


def _number(parameter: Parameter) -> float:
    return parameter.default if isinstance(parameter.default, int | float) else 0


def _said(block: BlockConfiguration) -> str:
    """What both blocks of a pair have in common."""
    turned = _turned(block)
    parameters = [
        replace(parameter, default=abs(_number(parameter))) if parameter is turned else parameter
        for parameter in block.parameters
    ]
    return repr((block.category, block.library, block.shapes, block.languages, parameters))
