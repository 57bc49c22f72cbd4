"""What can be said: skills as blocks, described by block configurations in JSON.

`learnblock.blocks.derivation` writes the configurations of skills that have none, and
`learnblock.blocks.reference` the page of all skills.
"""

from learnblock.blocks.configuration import BlockConfiguration, Parameter, ParameterType
from learnblock.blocks.load import all_configurations, builtin, load_configurations

__all__ = [
    "BlockConfiguration",
    "Parameter",
    "ParameterType",
    "all_configurations",
    "builtin",
    "load_configurations",
]
