"""The three layouts of RoboComp's structs."""

from collections.abc import Mapping
from enum import StrEnum

from learnblock.ice.types import Structure


class Layout(StrEnum):
    """The order of the members in a component's structs."""

    #: EBO's components of 2018.
    ROBOT = "robot"
    #: The paper's desktop tool of 2021, and the simulator RCIS.
    TOOL = "tool"
    #: RoboComp since May 2020.
    SINCE_2020 = "2020"


def laid_out(kind: type, layout: Layout, orders: Mapping[Layout, str]) -> Structure:
    """A struct in the order of a layout; layouts not named use the order of the dataclass."""
    return Structure.of(kind, orders.get(layout))
