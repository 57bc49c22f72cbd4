"""Pictures of runs on simulated robots."""

from pathlib import Path

from learnblock.client import Client
from learnblock.errors import LearnBlockError
from learnblock.robots.simulated.robot import SimulatedRobot
from learnblock.runtime.trace import Recorder


def draw(robot: Client, recorder: Recorder, path: Path, title: str) -> None:
    """Draw a run on a simulated robot, as .png or .svg.

    Raises:
        LearnBlockError: the robot is not simulated.
    """
    if not isinstance(robot, SimulatedRobot):
        raise LearnBlockError("world-not-drawable")
    from learnblock.simulator.picture import Scene, draw_png, draw_svg  # noqa: PLC0415 - optional

    scene = Scene(
        world=robot.simulation.world.description,
        body=robot.body.description.body,
        path=tuple((time, *pose) for time, pose in recorder.path),
        marks=tuple(
            (mark.time, mark.kind, mark.text, mark.pose[0], mark.pose[1])
            for mark in recorder.marks
            if mark.pose
        ),
        title=title,
    )
    drawn = draw_svg(scene).encode() if path.suffix == ".svg" else draw_png(scene)
    path.write_bytes(drawn)
