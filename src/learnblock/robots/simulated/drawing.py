"""Pictures of runs on simulated robots."""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock.client import Client
from learnblock.errors import LearnBlockError
from learnblock.robots.simulated.robot import SimulatedRobot
from learnblock.runtime.recorder import Recorder

if TYPE_CHECKING:
    from learnblock.simulator.picture import DrivenRun


def draw(recordings: Mapping[str, tuple[Client, Recorder]], path: Path, title: str) -> None:
    """Draw a run on simulated robots in one world, as .png or .svg.

    Args:
        recordings: the robots with what they did, by name.
        path: the file of the picture.
        title: the title.

    Raises:
        LearnBlockError: there is no simulated robot.
    """
    from learnblock.simulator.picture import PictureScene, draw_png, draw_svg  # noqa: PLC0415 - optional

    twins = {
        name: (robot, recorder)
        for name, (robot, recorder) in recordings.items()
        if isinstance(robot, SimulatedRobot)
    }
    if not twins:
        raise LearnBlockError("world-not-drawable")
    has_names = len(recordings) > 1
    scene = PictureScene(
        world=next(iter(twins.values()))[0].simulation.world.description,
        drives=tuple(_drive(name if has_names else "", *twin) for name, twin in twins.items()),
        title=title,
    )
    is_svg = path.suffix == ".svg"
    picture = draw_svg(scene, follows_theme=True).encode() if is_svg else draw_png(scene)
    path.write_bytes(picture)


def _drive(name: str, robot: SimulatedRobot, recorder: Recorder) -> "DrivenRun":
    from learnblock.simulator.picture import DrivenRun  # noqa: PLC0415 - as above

    drawing = robot.simulation.world.drawing
    strokes = tuple(stroke for stroke in drawing.strokes if stroke.robot == robot.name)
    return DrivenRun(
        body=robot.body.description.body,
        path=tuple((time, *pose) for time, pose in recorder.path),
        marks=tuple(
            # Where a robot's path ends, its name is shown.
            (mark.time, mark.kind, _named(name, mark.kind, mark.text), mark.pose[0], mark.pose[1])
            for mark in recorder.marks
            # Texts would cover a drawing.
            if mark.pose and not (strokes and mark.kind == "text")
        ),
        strokes=strokes,
    )


def _named(name: str, kind: str, text: str) -> str:
    return f"{name}: {text}" if name and kind == "end" else text
