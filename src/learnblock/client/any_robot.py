"""The hint for the robot of a skill."""

from learnblock.client.client import Client
from learnblock.client.skill_sets import EverySkill


class AnyRobot(Client, EverySkill):
    """A robot of any kind, whose skills editors and type checkers all know.

    def waltz(robot: AnyRobot, times: int = 3) -> None: ...
    """
