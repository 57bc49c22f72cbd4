"""Emulates EBO: four components that move a twin, and a broker with the camera's pictures."""

from collections.abc import Callable, Mapping
from contextlib import ExitStack
from types import MappingProxyType
from typing import Any

from learnblock.emulators.ebo_camera import Broker, CameraStream, find_broker
from learnblock.emulators.robocomp import Ranger, Servo, Wheels, row_of
from learnblock.emulators.twin import Twin
from learnblock.i18n import Phrase
from learnblock.ice import Adapter, Servant
from learnblock.ice.robocomp import Layout, interfaces

_EMOTIONS = "joy", "sadness", "surprise", "fear", "anger", "disgust", "neutral"


class Emulator:
    """An emulated EBO; every component listens on a free port.

    As on the real robot, the pictures go through the broker mosquitto. Without it there is no
    camera: ``camera_port`` is 0, and ``note`` explains what to install.

    Args:
        twin: the robot.
        host: the local address on which the components listen.
        layout: their message layout.
    """

    def __init__(
        self, twin: Twin, *, host: str = "127.0.0.1", layout: Layout = Layout.ROBOT
    ) -> None:
        self.note: Phrase | None = None
        self._known = interfaces(layout)
        with ExitStack() as beginning:
            self._adapter = beginning.enter_context(Adapter(host))
            wheels, servo = Wheels(twin, knows_place=False), Servo(twin, 1, reports_angle=False)
            settings: dict[str, Any] = {
                "address": host,
                "base_port": self._serve("differentialrobot", wheels),
                "laser_port": self._serve("laser", Ranger(lambda: row_of(twin))),
                "joint_port": self._serve("jointmotor", servo),
                "face_port": self._serve("emotionalmotor", _Face(twin)),
                "camera_port": self._stream(twin, host, beginning),
            }
            self._ending = beginning.pop_all()
        self.settings: Mapping[str, Any] = MappingProxyType(settings)

    def close(self) -> None:
        self._ending.close()

    def _stream(self, twin: Twin, host: str, ending: ExitStack) -> int:
        program = find_broker()
        if program is None:
            self.note = Phrase("emulator-no-camera")
            return 0
        broker = ending.enter_context(Broker(program, host))
        ending.callback(CameraStream(twin, host, broker.port).close)
        return broker.port

    def _serve(self, identity: str, component: object) -> int:
        return self._adapter.serve({identity: Servant(self._known[identity], component)})


class _Face:
    """EmotionalMotor: one operation for each emotion."""

    def __init__(self, twin: Twin) -> None:
        self._twin = twin

    def __getattr__(self, name: str) -> Callable[[], None]:
        emotion = name.removeprefix("express").lower()
        if emotion not in _EMOTIONS:
            raise AttributeError(name)

        def express() -> None:
            with self._twin.body() as body:
                body.show_emotion(emotion)

        return express

    def talking(self, talks: bool) -> None:  # noqa: FBT001 - RoboComp's signature
        with self._twin.body() as body:
            body.note("Display", "talking", talks)
