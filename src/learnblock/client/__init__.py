"""The generic client, the base of every robot."""

from learnblock.client.any_robot import AnyRobot
from learnblock.client.client import Client, ClientState
from learnblock.client.observers import Goal, Observer, Outcome, Witness
from learnblock.client.rights import Rights
from learnblock.client.skill_sets import EverySkill
from learnblock.client.status import RobotStatus

__all__ = [
    "AnyRobot",
    "Client",
    "ClientState",
    "EverySkill",
    "Goal",
    "Observer",
    "Outcome",
    "Rights",
    "RobotStatus",
    "Witness",
]
