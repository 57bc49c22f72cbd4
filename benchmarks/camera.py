"""Measure the time of a camera frame, and how much faster than real time a camera runs."""

import math
import statistics
import time
from collections.abc import Callable

import numpy as np

from learnblock.simulator.camera import CameraModel, CameraPose, Image, Surface, render
from learnblock.simulator.textures import FloorLine, face, floor, tag

FRAMES = 100
CAMERA_HERTZ = 20


def upright(
    start: tuple[float, float], end: tuple[float, float], low: float, high: float, texture: Image
) -> Surface:
    """A wall whose left end, seen from its front, is `start`."""
    corners = [(*start, high), (*end, high), (*end, low), (*start, low)]
    return Surface(np.array(corners), texture, two_sided=False)


def plain(*colour: int) -> Image:
    return np.full((1, 1, 3), colour, np.uint8)


def ring(half: float, x: float = 0.0, y: float = 0.0) -> list[tuple[float, float]]:
    return [(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]


def box(x: float, y: float, half: float, height: float, colour: Image) -> list[Surface]:
    foot = ring(half, x, y)
    sides = [upright(foot[i], foot[(i + 1) % 4], 0, height, colour) for i in range(4)]
    lid = np.array([(*foot[i], height) for i in (3, 2, 1, 0)])
    return [*sides, Surface(lid, colour, two_sided=False)]


def typical_world() -> list[Surface]:
    """A floor with lines, four walls, three boxes and three posters."""
    lines = [
        FloorLine([*ring(700), (-700, -700)], 25),
        FloorLine([(-900, 0), (900, 0)], 25, (200, 20, 20)),
    ]
    edge = ring(1000)
    ground = np.array([(*edge[i], 0.0) for i in (3, 2, 1, 0)])
    wall = plain(190, 170, 140)
    return [
        Surface(ground, floor((2000, 2000), (235, 235, 225), lines), two_sided=False),
        *(upright(edge[(i + 1) % 4], edge[i], 0, 300, wall) for i in range(4)),
        *box(500, 300, 60, 120, plain(180, 60, 40)),
        *box(300, -350, 50, 100, plain(50, 140, 60)),
        *box(700, -100, 80, 60, plain(60, 80, 180)),
        upright((998, 500), (998, 350), 50, 200, tag(3)),
        upright((998, 100), (998, -100), 50, 250, face("joy")),
        upright((998, -300), (998, -400), 100, 200, tag(8)),
    ]


def milliseconds(task: Callable[[int], object]) -> float:
    """Return the median over a drive, after a lap to warm up."""
    task(0)
    times = []
    for frame in range(FRAMES):
        begin = time.perf_counter()
        task(frame)
        times.append(time.perf_counter() - begin)
    return 1000 * statistics.median(times)


def pose_at(frame: int) -> CameraPose:
    angle = 2 * math.pi * frame / FRAMES
    return CameraPose(300 * math.cos(angle) - 400, 300 * math.sin(angle), 100, 20 * angle, -10)


def report(model: CameraModel) -> None:
    world, generator = typical_world(), np.random.default_rng(1)
    clean = milliseconds(lambda frame: render(world, model, pose_at(frame)))
    noisy = milliseconds(lambda frame: render(world, model, pose_at(frame), noise=(generator, 2.0)))
    print(f"{model.width} by {model.height}")
    print(f"  render            {clean:6.2f} ms")
    print(f"  render with noise {noisy:6.2f} ms")
    print(f"  {CAMERA_HERTZ} Hz camera      {1000 / CAMERA_HERTZ / noisy:6.1f} times real time")


if __name__ == "__main__":
    report(CameraModel(320, 240, 290))
    report(CameraModel(640, 480, 580))
