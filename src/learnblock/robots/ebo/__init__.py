"""EBO, the paper's robot: a Raspberry Pi on wheels with a face, running RoboComp's components.

It is a Wi-Fi access point with the address 192.168.16.1.
"""

from typing import Annotated

from msgspec import Meta

from learnblock.client import skill_sets
from learnblock.devices import Base, Camera, Display, DistanceSensors, JointMotor
from learnblock.ice.robocomp import Layout
from learnblock.robots import settings as user_settings
from learnblock.robots.ebo.camera import StreamedCamera
from learnblock.robots.robocomp import RoboCompRobot, RoboCompSettings, by_side, in_range
from learnblock.robots.settings import Address, Port
from learnblock.wheels import Drivetrain

__all__ = ["Robot", "Settings"]

#: What its motors can do, as on its twin. They report nothing, so its pose is reckoned with this.
DRIVETRAIN = Drivetrain(track=130.0, maximum_speed=300.0, acceleration=800.0)

CameraPort = Annotated[int, Meta(ge=0, le=65535, description="robot-setting-camera-port")]


class Settings(RoboCompSettings, frozen=True):
    """The settings of an EBO; the ports are those of its components."""

    address: Address = "192.168.16.1"
    laser_port: Port = 10104
    joint_port: Port = 10067
    face_port: Port = 30001
    camera_port: CameraPort = 50000


class Robot(RoboCompRobot[Settings], skill_sets.Ebo):
    """An EBO.

    Its components know neither its pose nor the angle of its head.
    """

    settings_type = Settings
    model = "ebo"
    usual_layout = Layout.ROBOT

    @classmethod
    def device_names(cls) -> frozenset[str]:
        """The devices by the saved settings: without a camera if its port is 0."""
        saved = user_settings.load(cls.name(), Settings)
        return super().device_names() - (frozenset() if saved.camera_port else {"Camera:ROBOT"})

    @classmethod
    def drivetrain_for(cls, settings: Settings) -> Drivetrain:  # noqa: ARG003 - always the same
        return DRIVETRAIN

    def laser_ports(self) -> tuple[int, ...]:
        return (self.settings.laser_port,)

    def connect(self) -> None:
        super().connect()
        self._face = self.component("emotionalmotor", "face", self.settings.face_port)
        self.add(Base(move=self.drive, drivetrain=DRIVETRAIN))
        self.add(DistanceSensors(read=self._distances))
        self.add(Display(show_emotion=self._express))
        self.add(JointMotor(move=self.tilt), "CAMERA")
        if self.settings.camera_port:
            self._connect_camera()

    def check_link(self) -> None:
        super().check_link()
        if self.settings.camera_port:
            self._camera.check()

    def _connect_camera(self) -> None:
        settings = self.settings
        self._camera = StreamedCamera(
            settings.address, settings.camera_port, settings.patience, self.steady_clock
        )
        self._ending.callback(self._camera.close)
        self._camera.open()
        self.add(Camera(read=self._camera.read))

    def _distances(self) -> dict[str, list[float]]:
        return by_side([in_range(point.dist) for point in self.lasers[0].ask("getLaserData")])

    def _express(self, emotion: str) -> None:
        operation = "expressNeutral" if emotion == "none" else f"express{emotion.capitalize()}"
        # The face of RoboComp since 2020 has no neutral expression, so it keeps the current one.
        if self._face.can(operation):
            self._face.ask(operation)
