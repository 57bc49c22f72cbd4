"""For the tests of skills, programs and robots: robots without hardware, wires that fail, promises.

`FakeRobot` is a robot in virtual time, `check_robot` asks any client for what every robot promises,
`check_function` asks one function of one device,
and `Relay` is a wire between a client and its robot that can be made to fail.
"""

from learnblock.testing.clock import VirtualClock
from learnblock.testing.conformance import CLAIMS, Certificate, NotConformingError, check_robot
from learnblock.testing.contract import check_function, functions_of
from learnblock.testing.relay import Fault, Relay
from learnblock.testing.robot import FakeRobot
from learnblock.testing.wheels import Wheels

__all__ = [
    "CLAIMS",
    "Certificate",
    "FakeRobot",
    "Fault",
    "NotConformingError",
    "Relay",
    "VirtualClock",
    "Wheels",
    "check_function",
    "check_robot",
    "functions_of",
]
