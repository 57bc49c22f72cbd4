"""What robots made of RoboComp's components share: links, layouts, the base, the joint."""

import math
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, closing
from typing import Annotated, Any, ClassVar, Generic, Literal, TypeVar

from msgspec import Meta

from learnblock.devices import NOTHING_SEEN, Pose
from learnblock.errors import IceEncodingError, IceError, IceRefusedError, RobotConnectionError
from learnblock.ice.connection import Endpoint
from learnblock.ice.proxy import Proxy
from learnblock.ice.robocomp import BaseState, Layout, MotorGoalPosition, interfaces
from learnblock.robots import settings as user_settings
from learnblock.robots.guardian import Guardian
from learnblock.robots.real import RealRobot
from learnblock.robots.robocomp_layout import layouts_of
from learnblock.robots.settings import Address, Patience, Port, RobotSettings

LayoutChoice = Annotated[
    Literal["auto", "robot", "tool", "2020"],
    Meta(description="in which order its components write what they say; auto finds it out"),
]

#: The joint that tilts the camera, as the robots call it.
SERVO = "servo"
#: Ice's name of what a component says that cannot read what it was told.
_NOT_UNDERSTOOD = "UnknownLocalException"


class RoboCompSettings(RobotSettings, frozen=True):
    """What both have: where the base listens, and how its components speak."""

    address: Address = "localhost"
    base_port: Port = 10004
    joint_port: Port = 20000
    layout: LayoutChoice = "auto"
    patience: Patience = 2.0


RoboCompT = TypeVar("RoboCompT", bound=RoboCompSettings)


class Component:
    """One of a robot's components, which says who and where it is when something goes wrong.

    Args:
        robot: the robot's id.
        title: what it is, in words: ``base``.
        proxy: the way to it.
    """

    def __init__(self, robot: str, title: str, proxy: Proxy) -> None:
        self._proxy = proxy
        self._name = f"the {title} of the robot `{robot}` at {proxy.endpoint}"

    @property
    def endpoint(self) -> Endpoint:
        """Where it is."""
        return self._proxy.endpoint

    def ask(self, operation: str, *values: Any) -> Any:
        """Call an operation.

        Raises:
            RobotConnectionError: the component cannot be reached, or refuses.
        """
        try:
            return self._proxy.call(operation, *values)
        except IceError as error:
            raise self.told(error) from error

    def speak(self, layout: Layout) -> None:
        """Go on in another layout."""
        identity, endpoint = self._proxy.identity, self._proxy.endpoint
        self._proxy = Proxy(interfaces(layout)[identity], identity, endpoint)

    def can(self, operation: str) -> bool:
        """Whether its interface has the operation."""
        return any(one.name == operation for one in self._proxy.interface.operations)

    def check(self) -> None:
        """Make sure that it is there, and what it should be.

        Raises:
            RobotConnectionError: it is not.
        """
        try:
            self._proxy.check()
        except IceError as error:
            raise self.told(error) from error

    def ping(self) -> None:
        """Make sure that it is still there.

        Raises:
            RobotConnectionError: it is not.
        """
        self.ask("ice_ping")

    def close(self) -> None:
        """Let go of it; the second time does nothing."""
        self._proxy.close()

    def told(self, error: IceError) -> RobotConnectionError:
        """What went wrong, in words for the person at the robot."""
        refusal = error.kind if isinstance(error, IceRefusedError) else ""
        if isinstance(error, IceEncodingError) or refusal == _NOT_UNDERSTOOD:
            return RobotConnectionError(
                f"{self._name} speaks in another order: {error}; does it have another `layout`?"
                " Choose one in the robot's settings"
            )
        if refusal:
            return RobotConnectionError(f"{self._name} refuses: {error}")
        return RobotConnectionError(
            f"{self._name} cannot be reached: {error}; is the robot on, its components running,"
            " and this computer in its network?"
        )


class RoboCompRobot(RealRobot[RoboCompT], Generic[RoboCompT]):
    """A robot made of RoboComp's components; each of the two adds its own devices."""

    #: The layout that such a robot has where it cannot be found out.
    usual_layout: ClassVar[Layout]
    #: The servo's angle for one degree of ours, rad.
    servo_scale: ClassVar[float] = math.radians(1)

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
        if "_ending" in vars(self):
            self._ending.close()

    def check_link(self) -> None:
        self._base.ping()

    @classmethod
    def halt(cls, settings: RoboCompT) -> None:
        # A guardian has to be quick: it tries again if this was too short.
        endpoint = cls.proxy("differentialrobot", settings, settings.base_port, patience=0.5)
        with closing(Component(cls.name(), "base", endpoint)) as base:
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
        text = f"{identity}:tcp -h {settings.address} -p {port}"
        return Proxy.parse(text, interface, patience or settings.patience)

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


def pose_of(state: BaseState) -> Pose:
    """A base's state as a pose: RoboComp looks along z at alpha 0 and has x to its right."""
    return state.z, 0.0 - state.x, math.degrees(state.alpha)


def in_range(mm: float) -> float:
    """A ranger's distance; what it answers when it sees nothing, or fails, becomes 2000."""
    return mm if 0 < mm < NOTHING_SEEN else NOTHING_SEEN


def by_side(row: list[float]) -> dict[str, list[float]]:
    """A row of distances from left to right, by the sides to which they look."""
    return {"left": row[:2], "front": row[1:4], "right": row[3:]}
