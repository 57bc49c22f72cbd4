"""The page's view of a robot, the same for simulated and real robots.

A `Monitor` is made by `make_monitor` before a program runs, and by `monitor_of` for the robot of a
running program.
"""

from learnblock.monitor.making import make_monitor, make_monitors, monitor_of
from learnblock.monitor.monitor import (
    GoalNow,
    Link,
    LinkState,
    Monitor,
    Robot,
    Scene,
    State,
    Stroke,
)
from learnblock.monitor.sensors import Sensor

__all__ = [
    "GoalNow",
    "Link",
    "LinkState",
    "Monitor",
    "Robot",
    "Scene",
    "Sensor",
    "State",
    "Stroke",
    "make_monitor",
    "make_monitors",
    "monitor_of",
]
