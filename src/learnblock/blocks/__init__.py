"""Blocks: skills described by block configurations in JSON, and the palette made from them.

Use them through this module. `known` has every block that a program may use, including the
custom blocks and installed libraries of this computer.
"""

from learnblock.blocks.schema.configuration import (
    NUMBERS,
    BlockConfiguration,
    Configurations,
    Parameter,
    ParameterType,
)
from learnblock.blocks.schema.loading import builtin, load_configurations

__all__ = [
    "NUMBERS",
    "BlockConfiguration",
    "Configurations",
    "Parameter",
    "ParameterType",
    "builtin",
    "load_configurations",
]
