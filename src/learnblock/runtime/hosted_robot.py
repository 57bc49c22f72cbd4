"""The robot of one program, on the host's side: the calls that arrive, and their recording."""

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

from learnblock.client import Client
from learnblock.devices import Base, Device, Sensor
from learnblock.errors import LearnBlockError, RobotConnectionError, RobotStoppedError
from learnblock.i18n import Phrase
from learnblock.runtime import messages
from learnblock.runtime.recorder import Recorder
from learnblock.runtime.world import ProgramWorld

MakeRobot = Callable[[str, dict[str, Any]], Client]
MakeRecorder = Callable[[Client], Recorder]


class HostedRobot:
    """The robot of one program.

    Args:
        make_robot: creates the robot of a module with the program's arguments.
        make_recorder: creates the recorder, which watches the robot, once there is one.
        world: the robot's world if it is simulated.
    """

    def __init__(
        self, make_robot: MakeRobot, make_recorder: MakeRecorder, world: ProgramWorld
    ) -> None:
        #: None before the program has created its robot.
        self.client: Client | None = None
        self.recorder: Recorder | None = None
        self.world = world
        #: The message that the robot could not be stopped; None if it was.
        self.stop_failure: Phrase | None = None
        self._make_robot = make_robot
        self._make_recorder = make_recorder
        self._functions: list[dict[str, Callable[..., Any]]] = []

    @property
    def active_recorder(self) -> Recorder | None:
        """The recorder while there is a robot that provides the time for its lines."""
        return None if self.client is None or self.client.stopped else self.recorder

    def connect(self, message: messages.Connect) -> messages.Connected | messages.Failed:
        """Create the robot, and return the answer for the program.

        Raises:
            LearnBlockError: the program already has a robot.
        """
        if self.client and not self.client.stopped:
            raise LearnBlockError("run-second-robot")
        try:
            self.client = self._make_robot(message.module, message.arguments)
        except Exception as error:  # noqa: BLE001 - a driver may raise any exception
            if isinstance(error, LearnBlockError):
                return failure(error)
            return failure(RobotConnectionError("run-robot-not-created", reason=_reason(error)))
        self.world.enter(self.client)
        self.recorder = self._make_recorder(self.client)
        # Only now: the recorder has put itself between the devices and their functions.
        self._functions = [
            _functions(self.client, key, device) for key, device in self.client.devices()
        ]
        return self._offer(self.client)

    def offers(self, device: int, function: str) -> bool:
        """Whether the robot has a device of this number with this function."""
        return 0 <= device < len(self._functions) and function in self._functions[device]

    def call(self, device: int, function: str, args: tuple[Any, ...]) -> Any:
        """Call a function of a device.

        Raises:
            LearnBlockError: the robot has been stopped, or the call failed.
        """
        if self.client and self.client.stopped:
            # Only through a device that the program has kept: the child's client refuses the rest.
            raise RobotStoppedError("run-robot-stopped")
        try:
            with self.world.exclusive:
                return self._functions[device][function](*args)
        except LearnBlockError:
            raise
        except Exception as error:
            # A driver is third-party code: any exception from it becomes a message for the pupil.
            raise RobotConnectionError(
                "run-call-failed", function=function, reason=_reason(error)
            ) from error

    def answer_on_waking(self, reads: Iterable[int]) -> messages.Answer | messages.Failed:
        """What a program is answered that wakes now, with the readings of these devices."""
        assert self.world.simulation is not None  # noqa: S101 - only a simulated program sleeps
        try:
            readings = [self.call(index, "read", ()) for index in reads]
        except LearnBlockError as error:
            return failure(error)
        return messages.Answer((self.world.simulation.steps, readings))

    def check_link(self) -> None:
        """Check that a real robot can still be reached.

        Raises:
            RobotConnectionError: the robot cannot be reached.
        """
        if self.client and not self.client.stopped:
            self.client.require_link()

    def stop(self) -> None:
        """Stop the robot; a failure to do so is kept in `stop_failure`."""
        if self.client:
            try:
                with self.world.exclusive:
                    self.client.stop()
            except Exception as error:  # noqa: BLE001 - a driver may raise any exception
                self.stop_failure = Phrase("run-robot-not-stopped", reason=_reason(error))

    def _offer(self, client: Client) -> messages.Connected:
        devices = tuple(
            messages.DeviceOffer(
                type(device).__name__,
                key,
                tuple(device.functions),
                device.drivetrain if isinstance(device, Base) else None,
            )
            for key, device in client.devices()
        )
        simulation = self.world.simulation
        if simulation is None:
            return messages.Connected(devices, client.equipment, None, 0.0, None)
        return messages.Connected(
            devices, client.equipment, simulation.steps, simulation.dt, simulation.seed
        )


def failure(error: LearnBlockError) -> messages.Failed:
    """The message that raises `error` in the program."""
    return messages.Failed(type(error).__name__, error.phrase)


def _reason(error: Exception) -> Phrase:
    """An error's message; for a driver's exception with the class, as its text may say little."""
    if isinstance(error, LearnBlockError):
        return error.phrase
    reason = Phrase(f"{type(error).__name__}: {error}")
    # Its author may not know of the fence: see `containment.driver`.
    return (
        Phrase("run-driver-refused", reason=reason)
        if isinstance(error, PermissionError)
        else reason
    )


def _functions(client: Client, key: str, device: Device) -> dict[str, Callable[..., Any]]:
    """The functions a child may call. Sensors are read through the client, which polls them."""
    if not isinstance(device, Sensor):
        return device.functions
    functions: dict[str, Callable[..., Any]] = {
        name: partial(_change, client, function) for name, function in device.functions.items()
    }
    functions["read"] = partial(client.read, type(device), key)
    if "detect" in functions:
        functions["detect"] = partial(client.detect, key=key)
    return functions


def _change(client: Client, function: Callable[..., Any], *args: Any) -> Any:
    """Change a sensor, for example its zero, which makes its last reading out of date."""
    try:
        return function(*args)
    finally:
        client.forget_readings()
