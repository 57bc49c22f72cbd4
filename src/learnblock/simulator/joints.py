"""The joints of a simulated robot, which turn as fast as they can."""

from typing import NamedTuple, Protocol

from learnblock.errors import UnknownNameError
from learnblock.simulator.physics import DT
from learnblock.simulator.robot_description import Joint


class JointWorld(Protocol):
    """The parts of the world that joints need."""

    steps: int


class _Motion(NamedTuple):
    """A moving joint: its angle at the last command, its target, and the step of the command."""

    start: float
    target: float
    since: int


class Joints:
    """The joints of one robot.

    Args:
        joints: their descriptions.
        clock: counts the world's steps.
    """

    def __init__(self, joints: tuple[Joint, ...], clock: JointWorld) -> None:
        self._joints = {joint.key: joint for joint in joints}
        self._clock = clock
        self._motions = {joint.key: self._at_rest(joint) for joint in joints}

    def turn(self, key: str, degrees: float) -> None:
        """Turn a joint to an angle, as far and as fast as it can.

        Raises:
            UnknownNameError: the robot has no such joint.
        """
        joint = self._find(key)
        target = min(max(degrees, joint.minimum), joint.maximum)
        if target == self._motions[key].target:
            # On its way, or there: telling it again changes nothing, not even the last digit.
            return
        self._motions[key] = _Motion(self.angle(key), target, self._clock.steps)

    def angle(self, key: str) -> float:
        """The current angle of a joint in degrees.

        Raises:
            UnknownNameError: the robot has no such joint.
        """
        speed = self._find(key).speed
        start, target, since = self._motions[key]
        reach = speed * DT * (self._clock.steps - since)
        return start + min(max(target - start, -reach), reach)

    def _find(self, key: str) -> Joint:
        if key not in self._joints:
            raise UnknownNameError("joint", key, self._joints)
        return self._joints[key]

    def _at_rest(self, joint: Joint) -> _Motion:
        rest = min(max(0.0, joint.minimum), joint.maximum)
        return _Motion(rest, rest, self._clock.steps)
