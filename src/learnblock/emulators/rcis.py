"""Emulates RCIS: nine components, which move EBO's twin."""

from collections.abc import Mapping
from contextlib import ExitStack
from functools import cache, partial
from types import MappingProxyType
from typing import Any

import numpy as np

from learnblock.emulators.robocomp import Ranger, Servo, Wheels, row_of
from learnblock.emulators.twin import Twin
from learnblock.ice import Adapter, Servant
from learnblock.ice.robocomp import BaseState, Image, Layout, MotorState, interfaces
from learnblock.robots.rcis.face import draw_face
from learnblock.simulator.robot_body import EMOTION_COLOURS


class Emulator:
    """An emulated RCIS; every component listens on a free port.

    Args:
        twin: the robot.
        host: the local address on which the components listen.
        layout: their message layout.
    """

    def __init__(
        self, twin: Twin, *, host: str = "127.0.0.1", layout: Layout = Layout.TOOL
    ) -> None:
        self._known = interfaces(layout)
        wheels = Wheels(twin, knows_place=True)
        with ExitStack() as beginning:
            self._adapter = beginning.enter_context(Adapter(host))
            settings: dict[str, Any] = {
                "address": host,
                "base_port": self._serve("differentialrobot", wheels),
                "laser_ports": [
                    self._serve("laser", Ranger(partial(_one_of, twin, place)))
                    for place in range(5)
                ],
                "joint_port": self._serve("jointmotor", Servo(twin, -1, reports_angle=True)),
                "display_port": self._serve("display", _Screen(twin)),
                "camera_port": self._serve("rgbd", _Eyes(twin, wheels)),
            }
            self._ending = beginning.pop_all()
        self.settings: Mapping[str, Any] = MappingProxyType(settings)

    def close(self) -> None:
        self._ending.close()

    def _serve(self, identity: str, component: object) -> int:
        return self._adapter.serve({identity: Servant(self._known[identity], component)})


def _one_of(twin: Twin, place: int) -> list[float]:
    return [row_of(twin)[place]]


class _Screen:
    """Display: a known picture is shown as an emotion, since our simulator has no screens."""

    def __init__(self, twin: Twin) -> None:
        self._twin = twin

    def setImage(self, image: Image) -> None:  # noqa: N802 - RoboComp's name
        emotion = _faces().get(image.Img)
        with self._twin.body() as body:
            if emotion:
                body.show_emotion(emotion)
            else:
                body.note("Display", "show_image", image.width, image.height)


class _Eyes:
    """RGBD: colours without depth."""

    def __init__(self, twin: Twin, wheels: Wheels) -> None:
        self._twin = twin
        self._wheels = wheels

    def getData(  # noqa: N802 - RoboComp's name
        self,
    ) -> tuple[bytes, list[float], dict[str, MotorState], BaseState]:
        with self._twin.body() as body:
            frame = np.ascontiguousarray(body.frame())
        return frame.tobytes(), [], {}, self._wheels.getBaseState()


@cache
def _faces() -> Mapping[bytes, str]:
    """The emotions by the pictures of our faces; "neutral" has the same picture as "none"."""
    names = sorted(EMOTION_COLOURS, key=lambda name: name == "neutral")
    return {draw_face(name).tobytes(): name for name in names}
