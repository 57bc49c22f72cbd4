"""What the page's gallery of worlds says about each."""

from learnblock.simulator.description_types import Difficulty, Group
from learnblock.simulator.world_description import WorldDescription
from learnblock.simulator.world_guide import group_of, needs_of, robots_for

__all__ = ["Difficulty", "Group", "WorldDescription", "group_of", "needs_of", "robots_for"]
