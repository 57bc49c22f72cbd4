"""A robot made of RoboComp's components: its links, its layout, its base, its joint."""

import math
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, closing
from typing import Annotated, Any, ClassVar, Generic, Literal, TypeVar

from msgspec import Meta

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

LayoutChoice = Annotated[
    Literal["auto", "robot", "tool", "2020"],
    Meta(description="in which order its components write what they say; auto finds it out"),
]

#: The joint that tilts the camera, as the robots call it.
SERVO = "servo"


class RoboCompSettings(RobotSettings, frozen=True):
    """What both have: where the base listens, and how its components speak."""

    address: Address = "localhost"
    base_port: Port = 10004
    joint_port: Port = 20000
    layout: LayoutChoice = "auto"
    patience: Patience = 2.0


RoboCompT = TypeVar("RoboCompT", bound=RoboCompSettings)


class RoboCompRobot(RealRobot[RoboCompT], Generic[RoboCompT]):
    """A robot made of RoboComp's components; each of the two adds its own devices."""

    #: The layout that such a robot has where it cannot be found out.
    usual_layout: ClassVar[Layout]
    #: The servo's angle for one degree of ours, rad.
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

    def connect(self) -> None:
        self._ending = ExitStack()
        self._stands = True
        self.layout = self.usual_layout
        self._base = self.component("differentialrobot", "base", self.settings.base_port)
        self._guardian = Guardian(type(self), self.settings)
        self._ending.callback(self._end_guard)
        self._joint = self.component("jointmotor", "joint", self.settings.joint_port)
        self.lasers = [
            self.component("laser", title, port) for title, port in self.laser_places().items()
        ]
        self._settle_layout()

    def disconnect(self) -> None:
        self._ending.close()

    def check_link(self) -> None:
        self._base.ping()

    @classmethod
    def halt(cls, settings: RoboCompT) -> None:
        # A guardian has to be quick: it tries again if this was too short.
        proxy = cls.proxy("differentialrobot", settings, settings.base_port, patience=0.5)
        with closing(Component(cls.name(), "base", proxy)) as base:
            base.ask("setSpeedBase", 0.0, 0.0)

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        """Ask at the address in the user's settings and at the usual one."""
        saved = user_settings.load(cls.name(), cls.settings_type)
        usual = cls.settings_type()
        addresses = dict.fromkeys((saved.address, usual.address))
        for address in addresses:
            tried = cls.settings_type(address=address, base_port=saved.base_port)
            if cls.answers(tried, seconds / len(addresses)):
                yield {"address": address}

    @classmethod
    def answers(cls, settings: RoboCompT, seconds: float) -> bool:
        """Whether such a robot answers there, in no more than so many seconds."""
        with closing(
            cls.proxy("differentialrobot", settings, settings.base_port, patience=seconds)
        ) as base:
            try:
                base.check()
            except IceError:
                return False
        return True

    def laser_places(self) -> Mapping[str, int]:
        """Its lasers in words, from left to right, and the ports where they listen."""
        raise NotImplementedError

    # For the two.

    @classmethod
    def proxy(
        cls,
        identity: str,
        settings: RoboCompT,
        port: int,
        *,
        layout: Layout | None = None,
        patience: float | None = None,
    ) -> Proxy:
        """The way to one of the components; nothing is asked yet."""
        interface = interfaces(layout or cls.usual_layout)[identity]
        endpoint = Endpoint(settings.address, port, patience or settings.patience)
        return Proxy(interface, identity, endpoint)

    def component(self, identity: str, title: str, port: int) -> Component:
        """One of the components, which is there; it is let go of when the robot is."""
        proxy = self.proxy(identity, self.settings, port, layout=self.layout)
        component = Component(self.name(), title, proxy)
        self._ending.callback(component.close)
        component.check()
        return component

    def drive(self, adv: float, rot: float) -> None:
        """Drive at mm/s forward and degrees/s clockwise, which RoboComp counts alike."""
        if adv or rot:
            self._stands = False
        self._base.ask("setSpeedBase", adv, math.radians(rot))
        self._stands = not (adv or rot)

    def pose(self) -> Pose:
        """Where its base says it is."""
        return pose_of(self._base.ask("getBaseState"))

    def tilt(self, degrees: float) -> None:
        """Tilt the camera, up positive."""
        goal = MotorGoalPosition(name=SERVO, position=degrees * self.servo_scale)
        self._joint.ask("setPosition", goal)

    def tilted(self) -> float:
        """The camera's angle, degrees."""
        return float(self._joint.ask("getMotorState", SERVO).pos / self.servo_scale)

    def _settle_layout(self) -> None:
        """Speak in the layout of the settings, or in the one that the components show."""
        chosen = self.settings.layout
        self.layout = self._found_layout() if chosen == "auto" else Layout(chosen)
        for component in (self._base, self._joint, *self.lasers):
            component.speak(self.layout)

    def _found_layout(self) -> Layout:
        """The usual layout, unless the components show that they have another one."""
        components = {
            "differentialrobot": self._base,
            "jointmotor": self._joint,
            "laser": self.lasers[0],
        }
        try:
            fitting = layouts_of({name: one.endpoint for name, one in components.items()})
        except IceError as error:
            raise self._base.told(error) from error
        if not fitting:
            raise RobotConnectionError(
                f"the components of the robot `{self.name()}` at {self.settings.address} answer in"
                " an order of their own: none of the known layouts fits"
            )
        return self.usual_layout if self.usual_layout in fitting else fitting[0]

    def _end_guard(self) -> None:
        if self._stands:
            self._guardian.dismiss()
        else:
            self._guardian.leave_in_charge()
