"""The three layouts of RoboComp's structs that are about."""

from collections.abc import Mapping
from enum import StrEnum

from learnblock.ice.types import Structure


class Layout(StrEnum):
    """Whose order of members a component follows."""

    #: EBO's own components of 2018.
    ROBOT = "robot"
    #: The paper's desktop tool of 2021, and with it the simulator RCIS.
    TOOL = "tool"
    #: RoboComp since May 2020.
    SINCE_2020 = "2020"


def laid_out(kind: type, layout: Layout, orders: Mapping[Layout, str]) -> Structure:
    """A struct in the order of a layout; its dataclass has the order of those not named."""
    return Structure.of(kind, orders.get(layout))
