"""What the driver of a robot gives: its link, and what is known of its world."""

from collections.abc import Mapping
from typing import Any, Self

from learnblock.client.observers import Outcome, Witness
from learnblock.client.status import RobotStatus
from learnblock.devices import Pose


class Driver:
    """The methods that a kind of robot overrides; each has an answer for a robot without it."""

    def connect(self) -> None:
        """Connect to the robot and `add` its devices."""

    def disconnect(self) -> None:
        """Disconnect from the robot, whose motors have already stopped."""

    @classmethod
    def check_wishes(cls, wishes: Mapping[str, Any]) -> None:
        """Check the options for `hosted` before a program is started.

        Raises:
            LearnBlockError: one of them is not possible.
        """

    @classmethod
    def prepared(cls, wishes: Mapping[str, Any]) -> object:
        """What runs with these wishes need, and have from a process from which they are forked.

        Args:
            wishes: options for `hosted`.

        Raises:
            LearnBlockError: one of them is not possible.
        """
        cls.check_wishes(wishes)
        return None

    @classmethod
    def hosted(cls, arguments: Mapping[str, Any], wishes: Mapping[str, Any]) -> Self:
        """Create the robot in a host that runs the program in a separate process.

        Args:
            arguments: the arguments of ``Robot(...)`` in the program.
            wishes: world, seed and pace chosen outside the program; only simulated robots use
                them.
        """
        del wishes
        return cls(**arguments)

    def conditions(self) -> dict[str, object]:
        """Everything except the program that affects a run, for the first line of a trace."""
        from learnblock.perception.sources import TABLE  # noqa: PLC0415 - slow, and for traces only

        # Names only: a trace must not reveal addresses and paths.
        setting_names = [
            setting.name for setting in TABLE.describe() if setting.value != setting.default
        ]
        robot = type(self).__module__.rpartition(".")[2].replace("_", "-")
        return {"robot": robot, **({"perception": setting_names} if setting_names else {})}

    def surroundings(self) -> Mapping[str, object]:
        """What the log of a run must know: a simulated robot's world, a real one's calibration."""
        return {}

    def where(self) -> Pose | None:
        """The robot's true pose (x mm, y mm, heading in degrees); only a simulator knows it."""
        return None

    def observe(self, witness: Witness) -> None:
        """Report events to a witness: what happens in the robot's world, and in its game."""

    def check_link(self) -> None:
        """Check that the robot can still be reached; called several times a second.

        Raises:
            RobotConnectionError: the link to the robot broke.
        """

    def status(self) -> RobotStatus:
        """Battery and link as last reported; this does not access the robot."""
        return RobotStatus()

    def outcome(self) -> Outcome:
        """The result of the run so far."""
        return Outcome()
