"""Tools for testing skills, programs and robots without hardware.

`FakeRobot` is a robot in virtual time, `check_robot` checks that a client keeps the rules for every
robot, `check_function` checks one function of a device, `Relay` is a link between a client and its
robot that can be made to fail, and with a `ManualClock` a driver's threads wait in virtual time.
"""

from learnblock.testing.clock import VirtualClock
from learnblock.testing.conformance import (
    CLAIMS,
    LINK_CLAIMS,
    Certificate,
    NotConformingError,
    check_robot,
)
from learnblock.testing.contract import check_function, functions_of
from learnblock.testing.manual_clock import ManualClock
from learnblock.testing.relay import Fault, Relay
from learnblock.testing.robot import FakeRobot
from learnblock.testing.wheels import Wheels

__all__ = [
    "CLAIMS",
    "LINK_CLAIMS",
    "Certificate",
    "FakeRobot",
    "Fault",
    "ManualClock",
    "NotConformingError",
    "Relay",
    "VirtualClock",
    "Wheels",
    "check_function",
    "check_robot",
    "functions_of",
]
