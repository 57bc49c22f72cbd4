"""What a real robot reported in its run, and where its twin would have been."""

from bisect import bisect_right
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from learnblock.errors import LearnBlockError
from learnblock.monitor.monitor import Robot, State, located
from learnblock.monitor.sensors import Sensor, sensors_of
from learnblock.server import messages
from learnblock.server.messages.looking import MOST_POINTS

if TYPE_CHECKING:
    from learnblock.why.recorded import Recorded
    from learnblock.why.ways import Way


class Reported:
    """The moments of a real robot's run, as far as it reported them.

    Args:
        recorded: the log of the run.
    """

    def __init__(self, recorded: "Recorded") -> None:
        from learnblock.why.ways import odometry  # noqa: PLC0415 - the page opens before

        self._way = odometry(recorded.lines)
        self._lines = [line for line in recorded.lines if "sensed" in line or "device" in line]
        self._times = [line["t"] for line in self._lines]

    def at(self, time: float) -> State | None:
        """Its state at a time in s; None if it never reported where it was."""
        if not self._way.times:
            return None
        sensed: dict[str, Any] = {}
        emotion = "none"
        for line in self._lines[: bisect_right(self._times, time)]:
            if "sensed" in line:
                sensed[line["sensed"]] = line["value"]
            elif line["do"] == "show_emotion":
                emotion = str(line["args"][0])
        robot = Robot("robot", *located(self._way.at(time)), emotion=emotion)
        return State(time, (robot,), sensors=_sensors(sensed))


def predicted(recorded: "Recorded") -> messages.Predicted:
    """Where the twin of a real robot would have been, and what the difference means."""
    from learnblock.why.drift import drift  # noqa: PLC0415 - as above
    from learnblock.why.ghost import findings, unrecorded  # noqa: PLC0415
    from learnblock.why.prediction import predict  # noqa: PLC0415
    from learnblock.why.ways import odometry  # noqa: PLC0415

    try:
        prediction = predict(recorded)
    except LearnBlockError:
        # A simulated robot, or one without a twin.
        return messages.Predicted()
    reported = odometry(recorded.lines)
    start = reported.poses[0] if reported.poses else (0.0, 0.0, 0.0)
    drifted = drift(prediction)
    listed = findings(prediction, drifted)
    return messages.Predicted(
        _points(prediction.twin.moved_to(start)),
        prediction.parting.time if prediction.parting else None,
        tuple(messages.TwinFinding(finding.phrase, finding.time) for finding in listed),
        unrecorded(prediction, drifted),
    )


def _sensors(sensed: Mapping[str, Any]) -> tuple[Sensor, ...]:
    named = ((*name.split(":", 1), value) for name, value in sensed.items())
    return tuple(sensor for kind, key, value in named for sensor in sensors_of(kind, value, key))


def _points(way: "Way") -> tuple[tuple[float, float, float, float], ...]:
    every = 5 * (1 + len(way.times) // (5 * MOST_POINTS))
    pairs = zip(way.times[::every], way.poses[::every], strict=True)
    return tuple(
        (round(time, 2), round(x, 1), round(y, 1), round(heading, 1))
        for time, (x, y, heading) in pairs
    )
