"""Anki's Cozmo, over its own Wi-Fi with pycozmo."""

from collections.abc import Iterator, Mapping
from contextlib import ExitStack
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

from msgspec import Meta

from learnblock.client import Rights, RobotStatus, skill_sets
from learnblock.devices import (
    Accelerometer,
    Animator,
    Base,
    Camera,
    Display,
    GroundSensors,
    Gyroscope,
    JointMotor,
    Pose,
    RGBLed,
    Screen,
    Speaker,
)
from learnblock.robots import settings as user_settings
from learnblock.robots.cozmo import units
from learnblock.robots.cozmo.halt import halt, responds
from learnblock.robots.cozmo.use import Use, is_used
from learnblock.robots.guardian import Guardian
from learnblock.robots.real import RealRobot, require
from learnblock.robots.settings import Address, Patience, Port, RobotSettings
from learnblock.timing import SteadyClock
from learnblock.wheels import Drivetrain

if TYPE_CHECKING:
    from learnblock.robots.cozmo.session import CozmoSession

__all__ = ["CozmoSettings", "Robot"]


#: A voice of espeak-ng, with or without a variant: ``en``, ``en-us+f3``.
Voice = Annotated[
    str,
    Meta(
        pattern=r"^[\w-]+(\+\w+)?$", min_length=1, max_length=40, description="robot-setting-voice"
    ),
]


class CozmoSettings(RobotSettings, frozen=True):
    """The settings of a Cozmo."""

    address: Address = "172.31.1.1"
    port: Port = 5551
    patience: Patience = 3.0
    colour: Annotated[bool, Meta(description="robot-setting-colour")] = True
    stop_at_cliff: Annotated[bool, Meta(description="robot-setting-stop-at-cliff")] = True
    volume: Annotated[int, Meta(ge=0, le=100, description="robot-setting-volume")] = 60
    voice: Voice = "en"


class Robot(RealRobot[CozmoSettings], skill_sets.Cozmo):
    """A Cozmo whose Wi-Fi this computer has joined.

        from learnblock.robots.cozmo import Robot

        robot = Robot()
        robot.move_straight(50)
        robot.sleep(2)

    Args:
        settings: by name; they override those of the user's file; see `CozmoSettings`.

    Raises:
        RobotConnectionError: Cozmo does not respond.
    """

    settings_type = CozmoSettings
    model = "cozmo"
    add_on = ("pycozmo",)
    # One lithium cell; below 3.5 V, Cozmo asks for its charger.
    battery_range = (3.4, 4.2)
    # Its guardian, and espeak-ng.
    rights = Rights(network=True, programs=True)
    _session: "CozmoSession | None" = None
    _guardian: Guardian | None = None
    _use: Use | None = None
    #: The emotion that its screen shows when there is no text.
    _emotion = "none"

    @classmethod
    def device_names(cls) -> frozenset[str]:
        one_each = (Accelerometer, Animator, Base, Camera, Display, GroundSensors, Screen, Speaker)
        return frozenset(
            [f"{kind.__name__}:ROBOT" for kind in one_each]
            + ["Gyroscope:Z_AXIS", "JointMotor:ARM", "JointMotor:CAMERA"]
            + [f"RGBLed:{slot}" for slot in units.LIGHTS]
        )

    @classmethod
    def abilities(cls) -> frozenset[str]:
        return frozenset(f"Speaker:{action}" for action in ("say", "play", "tone"))

    @classmethod
    def drivetrain_for(cls, settings: CozmoSettings) -> Drivetrain:  # noqa: ARG003 - always the same
        return units.DRIVETRAIN

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        """Try the address in the settings, unless a program on this computer uses the robot.

        The robot doesn't move, but it ends its conversation with any program that is elsewhere.
        """
        settings: CozmoSettings = user_settings.load(cls.name(), cls.settings_type)
        if is_used(settings.address, settings.port):
            return
        if responds(settings.address, settings.port, seconds):
            yield {"address": settings.address, "port": settings.port}

    @classmethod
    def is_in_use(cls) -> bool:
        settings: CozmoSettings = user_settings.load(cls.name(), cls.settings_type)
        return is_used(settings.address, settings.port)

    @classmethod
    def halt(cls, settings: CozmoSettings) -> None:
        halt(settings.address, settings.port, settings.patience)

    def connect(self) -> None:
        settings = self.settings
        self._session = session = _session(
            settings.address, settings.port, settings.patience, self.steady_clock
        )
        self._use = Use(settings.address, settings.port)
        session.prepare(
            colour=settings.colour, stop_at_cliff=settings.stop_at_cliff, volume=settings.volume
        )
        # Without a guardian, the robot stops only after five seconds without messages.
        self._guardian = Guardian(type(self), settings, self.steady_clock)
        self._add_sensors(session)
        self._add_joints(session)
        self._add_stage(session)
        # The default LED is the first added, "Center", as on the twin.
        for slot in sorted(units.LIGHTS):
            self.add(RGBLed(set_color=partial(session.light, slot)), slot)

    def disconnect(self) -> None:
        # Both run even if one fails, in reverse order.
        with ExitStack() as ending:
            if self._use is not None:
                ending.callback(self._use.end)
            if self._guardian is not None:
                ending.callback(self._guardian.dismiss)
            if self._session is not None:
                ending.callback(self._session.close)

    def check_link(self) -> None:
        if self._guardian is not None:
            self._guardian.check()
        if self._session is not None:
            self._session.check()

    def status(self) -> RobotStatus:
        return self._session.status() if self._session else RobotStatus()

    def _add_sensors(self, session: "CozmoSession") -> None:
        odometry = session.odometry
        self.add(Gyroscope(read=odometry.turned, reset=odometry.reset), "Z_AXIS")
        self.add(Accelerometer(read=partial(self._acceleration, session)))
        self.add(GroundSensors(read=partial(self._ground, session)))
        self.add(Camera(read=session.frame))

    def _acceleration(self, session: "CozmoSession") -> tuple[float, float, float]:
        return units.acceleration(*session.accelerations)

    def _ground(self, session: "CozmoSession") -> dict[str, float | None]:
        return _ground(on_cliff=session.on_cliff())

    def _pose(self, session: "CozmoSession") -> Pose:
        return session.odometry.pose

    def _add_joints(self, session: "CozmoSession") -> None:
        def lift(degrees: float) -> None:
            session.set_lift_height(units.lift_height(degrees))

        def head(degrees: float) -> None:
            session.set_head_angle(units.head_angle(degrees))

        self.add(JointMotor(move=lift, read=lambda: units.lift_angle(session.lift)), "ARM")
        self.add(JointMotor(move=head, read=lambda: session.head_angle.degrees), "CAMERA")

    def _add_stage(self, session: "CozmoSession") -> None:
        # Both need pycozmo, like the session.
        from learnblock.robots.cozmo import face, sound  # noqa: PLC0415
        from learnblock.robots.cozmo.stage import Stage  # noqa: PLC0415

        stage = Stage(session.anim_controller)

        def move(adv: float, rot: float) -> None:
            if self._guardian is not None and (adv or rot):
                self._guardian.check()
            stage.end_moves()
            session.drive_wheels(*units.treads(adv, rot))

        def say(text: str) -> None:
            stage.play(sound.speech(text, self.settings.voice))

        self.add(Base(move, partial(self._pose, session), units.DRIVETRAIN))

        def express(name: str) -> None:
            self._emotion = name
            stage.show(face.emotion(name))

        def write(text: str) -> None:
            stage.show(face.text(text) if text else face.emotion(self._emotion))

        self.add(
            Display(show_emotion=express, show_image=lambda frame: stage.show(face.picture(frame)))
        )
        self.add(Screen(write))
        self.add(
            Speaker(
                say=say if sound.can_speak() else None,
                play=lambda name: stage.play(sound.named(name)),
                tone=lambda hertz, milliseconds: stage.play(sound.tone(hertz, milliseconds / 1000)),
            )
        )
        self.add(Animator(play=stage.act))


def _session(address: str, port: int, timeout: float, clock: SteadyClock) -> "CozmoSession":
    require("pycozmo", "cozmo")
    # It needs pycozmo, which only owners of a Cozmo install.
    from learnblock.robots.cozmo.session import CozmoSession  # noqa: PLC0415

    return CozmoSession(address, port, timeout, clock)


def _ground(*, on_cliff: bool) -> dict[str, float | None]:
    return {"left": None, "central": 0.0 if on_cliff else 100.0, "right": None}
