"""The scripts of the emulated scene: ours, and the paper's."""

import math
from collections.abc import Callable, Mapping
from time import monotonic
from typing import Any

from learnblock.devices import NOTHING_SEEN
from learnblock.emulators.twin import Twin

#: The seconds without a call after which our scene script stops the motors.
WATCHDOG = 0.35
#: The types of devices that our scene script supports.
DEVICES = (
    "Base", "Camera", "Display", "DistanceSensors", "GroundSensors", "Gyroscope", "LightSensor",
)  # fmt: skip

Functions = Mapping[str, Callable[..., Any]]


class OurScript:
    """The functions of `scene.lua`, with our units and a watchdog.

    Args:
        twin: the simulated robot.
        camera: the handle of its camera, or -1.
    """

    def __init__(self, twin: Twin, camera: int) -> None:
        self._twin = twin
        self._camera = camera
        self._heard = 0.0
        self._alive = False
        self._wanted = (0.0, 0.0)
        self.functions: Functions = {
            "describe": self._describe,
            "drive": self._drive,
            "sense": self._sense,
            "show": self._show,
        }

    def begin(self) -> None:
        """Stop the motors and forget the program."""
        self._alive, self._wanted = False, (0.0, 0.0)
        self._move(0, 0)

    def watch(self) -> None:
        """Stop the motors if the program has not made a call for too long."""
        if self._alive and monotonic() - self._heard > WATCHDOG:
            self._alive = False
            self._move(0, 0)

    def _hear(self) -> None:
        """Record a call, which resumes the last drive command after a pause."""
        self._heard = monotonic()
        if not self._alive:
            self._alive = True
            self._move(*self._wanted)

    def _move(self, adv: float, rot: float) -> None:
        with self._twin.body() as body:
            body.drive(adv, rot)

    def _drive(self, adv: float, rot: float) -> None:
        self._wanted = (adv, rot)
        self._hear()
        self._move(adv, rot)

    def _describe(self) -> Mapping[str, Any]:
        self._drive(0, 0)
        with self._twin.body() as body:
            present = {name.partition(":")[0] for name in body.description.devices()}
        devices = [name for name in DEVICES if name in present | {"Gyroscope"}]
        return {"devices": devices, "camera": self._camera}

    def _sense(self) -> Mapping[str, Any]:
        self._hear()
        with self._twin.body() as body:
            distances = {side: readings for side, readings in body.distances().items() if readings}
            grounds = {
                side: reading for side, reading in body.ground().items() if reading is not None
            }
            light = body.light() if body.description.light else 0.0
            senses = {"pose": body.pose, "distances": distances, "ground": grounds, "light": light}
        # An empty Lua table could also be a list, so it is left out.
        return {name: sensed for name, sensed in senses.items() if sensed != {}}

    def _show(self, emotion: str) -> None:
        self._hear()
        with self._twin.body() as body:
            body.show_emotion(emotion)


class PaperScript:
    """The functions of `Funciones`, which take and return three lists and a buffer.

    Args:
        twin: the simulated robot.
    """

    def __init__(self, twin: Twin) -> None:
        self._twin = twin
        self.functions: Functions = {
            "On": self._on,
            "ResetGyroA": self._reset_gyroscope,
            "SensorGyroA": lambda *_: ([round(self._turned())], [], [], ""),
            "SensorLight": lambda *_: ([round(self._light())], [], [], ""),
            "SensorSonar": lambda *_: ([], [self._nearest()], [], ""),
        }

    def _on(self, _integers: Any, numbers: Any, _texts: Any, _buffer: Any) -> Any:
        adv, rot = numbers
        with self._twin.body() as body:
            body.drive(adv, math.degrees(rot))
        return [], [], [], ""

    def _reset_gyroscope(self, *_: Any) -> Any:
        with self._twin.body() as body:
            body.reset_gyroscope()
        return [], [], [], ""

    def _turned(self) -> float:
        with self._twin.body() as body:
            return body.gyroscope()

    def _light(self) -> float:
        with self._twin.body() as body:
            return body.ground()["central"] or 0.0

    def _nearest(self) -> float:
        """The distance in m; 0 if nothing is seen, as from V-REP's proximity sensors."""
        with self._twin.body() as body:
            distance = min(body.distances()["front"], default=NOTHING_SEEN)
        return 0.0 if distance >= NOTHING_SEEN else distance / 1000
