"""Measure calls and pictures per second over Ice, and what our layers add to a call.

Run it with ``python benchmarks/robots_ice.py``. The components use the real Ice runtime
(Debian's python3-zeroc-ice) on this machine.
"""

import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from ice_runtime import components
from learnblock.devices import Base, Camera, DistanceSensors
from learnblock.ice import Proxy
from learnblock.ice.robocomp import Layout, interfaces
from learnblock.robots.rcis import Robot

OBJECTS = (
    "differentialrobot",
    *[("laser", {"dist": [300.0] * 5})] * 5,
    "jointmotor",
    "display",
    ("rgbd", {"depths": 0}),
)
ROUNDS = 15


def seconds_of(calls: Sequence[Callable[[], object]], times: int) -> list[float]:
    """Return the least time of one call of each kind; the kinds take turns."""

    def round_of(call: Callable[[], object]) -> float:
        begun = perf_counter()
        for _ in range(times):
            call()
        return (perf_counter() - begun) / times

    rounds = [[round_of(call) for call in calls] for _ in range(ROUNDS)]
    return [min(column) for column in zip(*rounds, strict=True)]


def row(name: str, seconds: float, bare: float | None = None) -> None:
    more = "" if bare is None else f"   {(seconds - bare) * 1e6:+.1f} us over the bare proxy"
    print(f"{name:<36} {1 / seconds:8.0f} /s {seconds * 1e6:8.1f} us{more}")


def main() -> None:
    with (
        tempfile.TemporaryDirectory() as folder,
        components(folder, "tool", *OBJECTS, quiet=True) as running,
    ):
        base, *lasers, joint, display, camera = running.ports
        known = interfaces(Layout.TOOL)
        robot = Robot(
            skills=["set_move"],
            base_port=base,
            laser_ports=lasers,
            joint_port=joint,
            display_port=display,
            camera_port=camera,
            patience=10.0,
            address="127.0.0.1",
        )
        text = "{}:tcp -h 127.0.0.1 -p {}"
        with (
            robot,
            Proxy.parse(
                text.format("differentialrobot", base), known["differentialrobot"]
            ) as wheels,
            Proxy.parse(text.format("rgbd", camera), known["rgbd"]) as eyes,
        ):
            measure(robot, wheels, eyes)


def measure(robot: Robot, wheels: Proxy, eyes: Proxy) -> None:
    base = robot.device(Base)
    look, lasers = robot.device(Camera).read, robot.device(DistanceSensors).read
    bare, device, skill = seconds_of(
        (
            lambda: wheels.call("setSpeedBase", 10.0, 0.1),
            lambda: base.move(10, 5),
            lambda: robot.set_move(10, 5),
        ),
        2000,
    )
    row("setSpeedBase, bare proxy", bare)
    row("Base.move of the robot", device, bare)
    row("set_move of the robot", skill, bare)
    bare, device = seconds_of((lambda: eyes.call("getData"), look), 100)
    row("getData, bare proxy", bare)
    row("Camera.read of the robot", device, bare)
    row("DistanceSensors.read, five lasers", *seconds_of((lasers,), 300))


if __name__ == "__main__":
    main()
