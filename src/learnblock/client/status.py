"""The status that a robot reports: its battery and its link."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class RobotStatus:
    """Battery and link of a robot; None if its protocol does not report a value.

    Args:
        battery: the battery's voltage, V.
        charge: how full the battery is, 0 to 1, if the robot knows.
        link_quality: the share of the robot's regular messages that arrive, 0 to 1.
        silence: seconds since the robot's last message.
        round_trip: seconds from a question to its answer, as of late.
        signal: how strong its radio was when it was found, dBm.
    """

    battery: float | None = None
    charge: float | None = None
    link_quality: float | None = None
    silence: float | None = None
    round_trip: float | None = None
    signal: int | None = None
