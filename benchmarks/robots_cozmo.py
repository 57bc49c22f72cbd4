"""Measure the cost of driving a Cozmo, and the effect of a bad network: ours and bare pycozmo.

Run it with ``python benchmarks/robots_cozmo.py``. Our emulator is at the other end of the wire,
and a relay loses datagrams in both directions.
"""

import logging
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from time import monotonic, perf_counter
from typing import Any

import pycozmo
from pycozmo import protocol_encoder as packets

from learnblock.devices import Base, Camera, Gyroscope, JointMotor, Speaker
from learnblock.emulators.cozmo import Emulator
from learnblock.emulators.twin import Twin
from learnblock.robots import connect
from learnblock.robots.cozmo import sound
from learnblock.testing import Relay

ROUNDS, CALLS = 7, 200
#: The microseconds that a call may cost more than pycozmo's own.
LITTLE = 20.0
LOSSES = (0.0, 0.02, 0.1, 0.2)
#: The seconds after which a sound counts as lost.
TIMEOUT = 5.0
TONE = sound.packed(sound.tone(440, 1.0))


@contextmanager
def emulated(loss: float = 0.0) -> Iterator[tuple[Any, int]]:
    """A Cozmo in its world, and the port of the wire to it."""
    with (
        Twin("sim-cozmo", "tags") as twin,
        closing(Emulator(twin)) as emulator,
        Relay(("127.0.0.1", emulator.settings["port"]), udp=True) as relay,
    ):
        relay.loss = loss
        yield emulator.machine, relay.port


def reached(port: int) -> Any:
    """Our driver, connected."""
    return connect("cozmo", address="127.0.0.1", port=port)


@contextmanager
def bare(port: int) -> Iterator[pycozmo.Client]:
    """Bare pycozmo."""
    client = pycozmo.Client(("127.0.0.1", port), enable_procedural_face=False)
    client.start()
    client.connect()
    try:
        client.wait_for_robot()
        yield client
    finally:
        client.disconnect()
        client.stop()


def cost(work: Callable[[], object]) -> float:
    """Return the microseconds of one call in the fastest round, while few packets wait."""
    best = float("inf")
    for _ in range(ROUNDS):
        began = perf_counter()
        for _ in range(CALLS):
            work()
        best = min(best, perf_counter() - began)
        threading.Event().wait(0.3)
    return best / CALLS * 1e6


def costs() -> dict[str, tuple[float, float]]:
    """Return the microseconds of calls, ours and pycozmo's."""
    with emulated() as (_, port), reached(port) as robot:
        base, gyroscope = robot.device(Base), robot.device(Gyroscope, "Z_AXIS")
        head = robot.device(JointMotor, "CAMERA")
        ours = cost(lambda: base.move(10, 5)), cost(lambda: head.move(10)), cost(gyroscope.read)
    with emulated() as (_, port), bare(port) as client:
        theirs = (
            cost(lambda: client.drive_wheels(10, 5)),
            cost(lambda: client.set_head_angle(0.2)),
            cost(lambda: client.pose.rotation.angle_z.degrees),
        )
    return dict(zip(("drive", "head", "gyroscope"), zip(ours, theirs, strict=True), strict=True))


def rates() -> tuple[float, float, float]:
    """Return reports and pictures per second, and the ms until a command reaches the robot."""
    with emulated() as (machine, port), reached(port) as robot:
        camera, frames, last = robot.device(Camera), 0, None
        reports: list[object] = []
        # Only the session knows how many there are.
        robot._session.add_handler(packets.RobotState, lambda *said: reports.append(said))  # noqa: SLF001
        until = monotonic() + 3
        while monotonic() < until:
            frame = camera.read()
            frames += frame is not last
            last = frame
            threading.Event().wait(0.005)
        latencies = sorted(latency(robot, machine) for _ in range(50))
    return len(reports) / 3, frames / 3, latencies[25] * 1e3


def latency(robot: Any, machine: Any) -> float:
    """Return the seconds until a command reaches the robot."""
    known, began = machine.received["SetHeadAngle"], perf_counter()
    robot.device(JointMotor, "CAMERA").move(5)
    while machine.received["SetHeadAngle"] == known:
        threading.Event().wait(0.0005)
    return perf_counter() - began


def arrived(machine: Any) -> str:
    """Return how much of a sound arrives, and how long that takes."""
    began = monotonic()
    while len(machine.heard) < len(TONE) and monotonic() - began < TIMEOUT:
        threading.Event().wait(0.005)
    return f"{len(machine.heard):2}/{len(TONE)} in {monotonic() - began:.1f} s"


def our_sound(loss: float) -> str:
    with emulated(loss) as (machine, port), reached(port) as robot:
        robot.device(Speaker).tone(440, 1000)
        return arrived(machine)


def their_sound(loss: float) -> str:
    with emulated(loss) as (machine, port):
        try:
            with bare(port) as client:
                client.anim_controller.play_audio([packets.OutputAudio(one) for one in TONE])
                return arrived(machine)
        except pycozmo.exception.ConnectionTimeout:
            return "no connection"


def main() -> None:
    logging.getLogger("pycozmo").addHandler(logging.NullHandler())
    print(f"{'µs a call':<12}{'ours':>8}{'pycozmo':>9}{'more':>7}")
    for name, (ours, theirs) in costs().items():
        verdict = "" if ours - theirs < LITTLE else f"  more than {LITTLE:g}"
        print(f"{name:<12}{ours:8.1f}{theirs:9.1f}{ours - theirs:7.1f}{verdict}")
    reports, pictures, wait = rates()
    print(f"{reports:.1f} reports a second of 33.3, {pictures:.1f} pictures of 15")
    print(f"a command is with the robot after {wait:.1f} ms")
    print(f"{'lost':<6}{'a sound of ours':<20}pycozmo's")
    for loss in LOSSES:
        print(f"{loss:<6.0%}{our_sound(loss):<20}{their_sound(loss)}")


if __name__ == "__main__":
    main()
