"""A component of a RoboComp robot."""

from collections.abc import Callable
from typing import Any

from learnblock.errors import IceEncodingError, IceError, IceRefusedError, RobotConnectionError
from learnblock.ice.endpoint import Endpoint
from learnblock.ice.proxy import Proxy
from learnblock.ice.robocomp import Layout, interfaces

#: Ice's name for the answer of a component that cannot read a message.
_NOT_UNDERSTOOD = "UnknownLocalException"


class Component:
    """A component of a robot; its errors name the robot, the part and the address.

    Args:
        robot: the robot's id.
        part: base, joint, laser, face, screen or camera.
        proxy: calls the component.
        note: called with the name of each operation that is called.
    """

    def __init__(
        self, robot: str, part: str, proxy: Proxy, note: Callable[[str], object] = str
    ) -> None:
        self._proxy = proxy
        self._note = note
        self._robot = robot
        self._part = part

    @property
    def endpoint(self) -> Endpoint:
        """The component's address."""
        return self._proxy.endpoint

    def ask(self, operation: str, *values: Any) -> Any:
        """Call an operation.

        Raises:
            RobotConnectionError: the component cannot be reached, or refuses the call.
        """
        self._note(f"{self._proxy.identity}.{operation}")
        try:
            return self._proxy.call(operation, *values)
        except IceError as error:
            raise self.error(error) from error

    def use_layout(self, layout: Layout) -> None:
        """Switch to another message layout."""
        identity, endpoint = self._proxy.identity, self._proxy.endpoint
        self._proxy = Proxy(interfaces(layout)[identity], identity, endpoint)

    def can(self, operation: str) -> bool:
        """Whether its interface has the operation."""
        return any(offered.name == operation for offered in self._proxy.interface.operations)

    def check(self) -> None:
        """Check that the component answers and has the expected interface.

        Raises:
            RobotConnectionError: it does not.
        """
        try:
            self._proxy.check()
        except IceError as error:
            raise self.error(error) from error

    def ping(self) -> None:
        """Check that the component still answers.

        Raises:
            RobotConnectionError: it does not.
        """
        self.ask("ice_ping")

    def close(self) -> None:
        """Close the connection; calling it twice is harmless."""
        self._proxy.close()

    def error(self, error: IceError) -> RobotConnectionError:
        """The error to raise for an Ice error."""
        robot, place = self._robot, str(self.endpoint)
        refusal = error.kind if isinstance(error, IceRefusedError) else ""
        if isinstance(error, IceEncodingError) or refusal == _NOT_UNDERSTOOD:
            return RobotConnectionError("robot-part-layout", robot=robot, place=place)
        if refusal:
            return RobotConnectionError(
                "robot-part-refused", robot=robot, place=place, reason=error.phrase
            )
        return RobotConnectionError(
            "robot-part-unreachable", robot=robot, part=self._part, place=place
        )
