"""A robot that runs RoboComp's components: its connections, layout, base and joint."""

import math
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, closing
from typing import Annotated, Any, ClassVar, Generic, Literal, TypeVar

from msgspec import Meta

from learnblock.client import Rights
from learnblock.devices import Pose
from learnblock.errors import IceError, RobotConnectionError
from learnblock.ice.endpoint import Endpoint
from learnblock.ice.proxy import Proxy
from learnblock.ice.robocomp import Layout, MotorGoalPosition, interfaces
from learnblock.robots import settings as user_settings
from learnblock.robots.guardian import Guardian
from learnblock.robots.real import RealRobot
from learnblock.robots.robocomp.component import Component
from learnblock.robots.robocomp.layouts import layouts_of
from learnblock.robots.robocomp.units import pose_of
from learnblock.robots.settings import Address, Patience, Port, RobotSettings
from learnblock.timing import MONOTONIC, SteadyClock

LayoutChoice = Annotated[
    Literal["auto", "robot", "tool", "2020"],
    Meta(description="robot-setting-layout"),
]

#: The robots' name for the joint that tilts the camera.
SERVO = "servo"


class RoboCompSettings(RobotSettings, frozen=True):
    """The settings that EBO and RCIS share."""

    address: Address = "localhost"
    base_port: Port = 10004
    joint_port: Port = 20000
    layout: LayoutChoice = "auto"
    patience: Patience = 2.0


RoboCompT = TypeVar("RoboCompT", bound=RoboCompSettings)


class RoboCompRobot(RealRobot[RoboCompT], Generic[RoboCompT]):
    """A robot that runs RoboComp's components; EBO and RCIS add their own devices."""

    # Its guardian.
    rights = Rights(network=True, programs=True)
    #: The layout to use if it cannot be detected.
    usual_layout: ClassVar[Layout]
    #: The servo's angle in radians for one degree of the camera.
    servo_scale: ClassVar[float] = math.radians(1)

    @classmethod
    def device_names(cls) -> frozenset[str]:
        return frozenset(
            {
                "Base:ROBOT",
                "Camera:ROBOT",
                "Display:ROBOT",
                "DistanceSensors:ROBOT",
                "JointMotor:CAMERA",
            }
        )

    @classmethod
    def abilities(cls) -> frozenset[str]:
        return frozenset(f"DistanceSensors:{side}" for side in ("front", "left", "right"))

    def connect(self) -> None:
        self._ending = ExitStack()
        self._stopped = True
        self.layout = self.usual_layout
        self._base = self.component("differentialrobot", "base", self.settings.base_port)
        self._guardian = Guardian(type(self), self.settings, self.steady_clock)
        self._ending.callback(self._end_guard)
        self._joint = self.component("jointmotor", "joint", self.settings.joint_port)
        self.lasers = [self.component("laser", "laser", port) for port in self.laser_ports()]
        self._settle_layout()

    def disconnect(self) -> None:
        self._ending.close()

    def check_link(self) -> None:
        self._guardian.check()
        self._base.ping()

    @classmethod
    def halt(cls, settings: RoboCompT) -> None:
        # A guardian must be quick; it retries if the timeout was too short.
        proxy = cls.proxy("differentialrobot", settings, settings.base_port, timeout=0.5)
        with closing(Component(cls.name(), "base", proxy)) as base:
            base.ask("setSpeedBase", 0.0, 0.0)

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        """Try the address in the user's settings and the default one."""
        saved = user_settings.load(cls.name(), cls.settings_type)
        usual = cls.settings_type()
        addresses = dict.fromkeys((saved.address, usual.address))
        for address in addresses:
            candidate = cls.settings_type(address=address, base_port=saved.base_port)
            if cls.answers(candidate, seconds / len(addresses)):
                yield {"address": address}

    @classmethod
    def answers(cls, settings: RoboCompT, seconds: float) -> bool:
        """Whether a robot of this kind answers there within a few seconds."""
        with closing(
            cls.proxy("differentialrobot", settings, settings.base_port, timeout=seconds)
        ) as base:
            try:
                base.check()
            except IceError:
                return False
        return True

    def laser_ports(self) -> tuple[int, ...]:
        """The ports of the distance sensors' components, from left to right."""
        raise NotImplementedError

    # For EBO and RCIS.

    @classmethod
    def proxy(
        cls,
        identity: str,
        settings: RoboCompT,
        port: int,
        *,
        layout: Layout | None = None,
        timeout: float | None = None,
        clock: SteadyClock = MONOTONIC,
    ) -> Proxy:
        """A proxy for one of the components; it connects at the first call."""
        interface = interfaces(layout or cls.usual_layout)[identity]
        endpoint = Endpoint(settings.address, port, timeout or settings.patience, clock)
        return Proxy(interface, identity, endpoint)

    def component(self, identity: str, part: str, port: int) -> Component:
        """Connect to one of the components; it is closed with the robot."""
        proxy = self.proxy(
            identity, self.settings, port, layout=self.layout, clock=self.steady_clock
        )
        component = Component(self.name(), part, proxy, self.operations.note)
        self._ending.callback(component.close)
        component.check()
        return component

    def drive(self, adv: float, rot: float) -> None:
        """Drive at mm/s forward and degrees/s clockwise, the same directions as RoboComp's."""
        if drivetrain := self.drivetrain_for(self.settings):
            adv, rot = drivetrain.reachable(adv, rot)
        if adv or rot:
            self._guardian.check()
            self._stopped = False
        self._base.ask("setSpeedBase", adv, math.radians(rot))
        self._stopped = not (adv or rot)

    def pose(self) -> Pose:
        """The pose reported by the base."""
        return pose_of(self._base.ask("getBaseState"))

    def tilt(self, degrees: float) -> None:
        """Tilt the camera; up is positive."""
        goal = MotorGoalPosition(name=SERVO, position=degrees * self.servo_scale)
        self._joint.ask("setPosition", goal)

    def tilted(self) -> float:
        """The camera's angle in degrees."""
        return float(self._joint.ask("getMotorState", SERVO).pos / self.servo_scale)

    def _settle_layout(self) -> None:
        """Use the layout in the settings, or detect it."""
        layout = self.settings.layout
        self.layout = self._detected_layout() if layout == "auto" else Layout(layout)
        for component in (self._base, self._joint, *self.lasers):
            component.use_layout(self.layout)

    def _detected_layout(self) -> Layout:
        """The usual layout, unless the components turn out to use another one."""
        components = {
            "differentialrobot": self._base,
            "jointmotor": self._joint,
            "laser": self.lasers[0],
        }
        try:
            fitting = layouts_of(
                {name: component.endpoint for name, component in components.items()}
            )
        except IceError as error:
            raise self._base.error(error) from error
        if not fitting:
            raise RobotConnectionError(
                "robot-unknown-layout", robot=self.name(), address=self.settings.address
            )
        return self.usual_layout if self.usual_layout in fitting else fitting[0]

    def _end_guard(self) -> None:
        if self._stopped:
            self._guardian.dismiss()
        else:
            self._guardian.leave_in_charge()
