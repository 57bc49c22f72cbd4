"""One of the components a robot is made of."""

from typing import Any

from learnblock.errors import IceEncodingError, IceError, IceRefusedError, RobotConnectionError
from learnblock.ice.endpoint import Endpoint
from learnblock.ice.proxy import Proxy
from learnblock.ice.robocomp import Layout, interfaces

#: Ice's name of what a component says that cannot read what it was told.
_NOT_UNDERSTOOD = "UnknownLocalException"


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
