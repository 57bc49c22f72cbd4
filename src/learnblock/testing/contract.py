"""Check the functions of a robot's devices one at a time, while their author writes them.

Nothing here makes a robot drive:

    >>> from learnblock.devices import Gyroscope
    >>> from learnblock.testing import FakeRobot, check_function, functions_of
    >>> robot = FakeRobot(only=[Gyroscope])
    >>> functions_of(robot)
    ('Gyroscope:Z_AXIS.read', 'Gyroscope:Z_AXIS.reset')
    >>> check_function(robot, "Gyroscope:Z_AXIS.read")
"""

from collections.abc import Mapping
from typing import Any

from learnblock.client import Client
from learnblock.devices import Base, Camera, Device, Sensor
from learnblock.devices.readings import is_number
from learnblock.errors import UnknownNameError
from learnblock.testing.conformance import NotConformingError
from learnblock.testing.forms import has_form, is_pose

#: The arguments of each command, chosen for the smallest effect.
_COMMANDS: Mapping[str, tuple[object, ...]] = {
    "Animator.play": ("Dances",),
    "Base.move": (0.0, 0.0),
    "Display.show_emotion": ("neutral",),
    "Gyroscope.reset": (),
    "Infrared.send": (1,),
    "JointMotor.move": (0.0,),
    "Led.set": (False,),
    "MP3.action": ("Pause",),
    "MP3.equalizer": ("NO",),
    "MP3.loop": ("Loop all",),
    "MP3.select": (1, 1),
    "MP3.volume": (0,),
    "Matrix.icon": ("heart", 0),
    "Matrix.number": (0.0, 0),
    "Matrix.text": ("", 0, 0),
    "Pen.clear": (),
    "Pen.set": (False,),
    "Pen.set_color": (0, 0, 0),
    "Pen.set_width": (6.0,),
    "RGBLed.set_color": (0, 0, 0),
    "Screen.show_text": ("",),
    "Speaker.play": ("beep",),
    "Speaker.say": ("",),
    "Speaker.tone": (440.0, 50.0),
}


def functions_of(robot: Client) -> tuple[str, ...]:
    """The functions that `check_function` can check, as ``Type:KEY.function``, sorted."""
    return tuple(
        sorted(
            f"{type(device).__name__}:{key}.{function}"
            for key, device in robot.devices()
            for function in device.functions
            if function == "read" or f"{type(device).__name__}.{function}" in _COMMANDS
        )
    )


def check_function(robot: Client, name: str) -> None:
    """Call a function of a device with harmless arguments, and check what it returns.

    Args:
        robot: a connected robot.
        name: as in `functions_of`, such as ``DistanceSensors:ROBOT.read``.

    Raises:
        UnknownNameError: the robot has no such function.
        NotConformingError: the value that it returns has the wrong form.
    """
    functions = functions_of(robot)
    if name not in functions:
        raise UnknownNameError("device-function", name, functions)
    whole, _, function = name.rpartition(".")
    device = {f"{type(device).__name__}:{key}": device for key, device in robot.devices()}[whole]
    arguments = () if function == "read" else _COMMANDS[f"{type(device).__name__}.{function}"]
    answer = device.functions[function](*arguments)
    if not _is_right(device, function, answer):
        raise NotConformingError(f"{name} returns {answer!r:.120}")


def _is_right(device: Device, function: str, answer: Any) -> bool:
    if function != "read":
        return answer is None
    if isinstance(device, Sensor):
        # A camera's first picture may still be on its way.
        return (answer is None and isinstance(device, Camera)) or has_form(device, answer)
    return is_pose(answer) if isinstance(device, Base) else is_number(answer)
