"""What all devices have in common."""

from collections.abc import Callable
from typing import Any, ClassVar, Generic, TypeVar

from learnblock.devices.readings import Form

Reading = TypeVar("Reading")
Function = Callable[..., Any]

#: The key of a robot's first device of a type.
DEFAULT_KEY = "ROBOT"
#: Asks for a robot's first device of a type, whatever its key is.
FIRST_KEY = "first"


class Device:
    """A device, built from functions; functions that a robot cannot offer are left out.

    Args:
        functions: the functions by name. They are stored in `functions` and called from there, so
            that another process can build the same device from remote calls, and a recorder can
            watch the commands.
    """

    def __init__(self, **functions: Function | None) -> None:
        self.functions: dict[str, Function] = {
            name: function for name, function in functions.items() if function is not None
        }

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {', '.join(self.functions)}>"

    def _do(self, name: str, *args: object) -> bool:
        """Call the function if the robot offers it, and return whether it does."""
        function = self.functions.get(name)
        if function is None:
            return False
        function(*args)
        return True


class Sensor(Device, Generic[Reading]):
    """A device with readings.

    Attributes:
        form: what its readings look like; None if they are not numbers.
    """

    form: ClassVar[Form | None] = None

    def __init__(self, read: Callable[[], Reading], **functions: Function | None) -> None:
        super().__init__(read=read, **functions)
        self.read = read
