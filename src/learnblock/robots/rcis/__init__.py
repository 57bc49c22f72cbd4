"""RCIS, RoboComp's simulator, with the paper's EBO in it."""

from typing import TYPE_CHECKING

from learnblock.client import skill_sets
from learnblock.devices import Base, Camera, Display, DistanceSensors, JointMotor, Screen
from learnblock.ice.robocomp import Image, Layout
from learnblock.robots.rcis.camera import FrameConverter
from learnblock.robots.robocomp import RoboCompRobot, RoboCompSettings, by_side, in_range
from learnblock.robots.settings import Port

if TYPE_CHECKING:
    from learnblock.devices import Frame

__all__ = ["Robot", "Settings"]


class Settings(RoboCompSettings, frozen=True):
    """The settings of a robot in RCIS; the ports are those of its components."""

    laser_ports: tuple[Port, Port, Port, Port, Port] = (10102, 10103, 10104, 10105, 10106)
    joint_port: Port = 20000
    display_port: Port = 30000
    camera_port: Port = 10097


class Robot(RoboCompRobot[Settings], skill_sets.Rcis):
    """An EBO in RCIS."""

    settings_type = Settings
    model = "ebo"
    usual_layout = Layout.TOOL
    # In RCIS the servo turns the other way.
    servo_scale = -RoboCompRobot.servo_scale

    #: The emotion that its screen shows when there is no text.
    _emotion = "none"

    @classmethod
    def device_names(cls) -> frozenset[str]:
        return super().device_names() | {"Screen:ROBOT"}

    def laser_ports(self) -> tuple[int, ...]:
        return self.settings.laser_ports

    def connect(self) -> None:
        super().connect()
        self._display = self.component("display", "screen", self.settings.display_port)
        self._camera = self.component("rgbd", "camera", self.settings.camera_port)
        self._pictures = FrameConverter()
        self.add(Base(move=self.drive, read=self.pose))
        self.add(DistanceSensors(read=self._distances))
        self.add(Display(show_emotion=self._express))
        self.add(Screen(self._write))
        self.add(Camera(read=self._look))
        self.add(JointMotor(move=self.tilt, read=self.tilted), "CAMERA")

    def _distances(self) -> dict[str, list[float]]:
        rows = (laser.ask("getLaserData") for laser in self.lasers)
        nearest = (min((in_range(point.dist) for point in row), default=0.0) for row in rows)
        return by_side([in_range(mm) for mm in nearest])

    def _look(self) -> "Frame | None":
        colour, *_ = self._camera.ask("getData")
        return self._pictures.unpacked(colour)

    def _express(self, emotion: str) -> None:
        # Imported here so that OpenCV is loaded only with the first face.
        from learnblock.robots.rcis.face import draw_face  # noqa: PLC0415

        self._emotion = emotion
        self._show(draw_face(emotion))

    def _write(self, text: str) -> None:
        from learnblock.robots.rcis.face import draw_text  # noqa: PLC0415 - as above

        if text:
            self._show(draw_text(text))
        else:
            self._express(self._emotion)

    def _show(self, picture: "Frame") -> None:
        height, width, depth = picture.shape
        self._display.ask("setImage", Image(width, height, depth, picture.tobytes()))
