"""The connection to a brick with LEGO's own firmware, over Wi-Fi, Bluetooth or USB."""

import math
from collections.abc import Callable, Sequence

from learnblock.errors import RobotConnectionError, RobotNotFoundError
from learnblock.robots.ev3 import direct
from learnblock.robots.ev3.brick import Drive, Say, Show, State, Tone, Word
from learnblock.robots.ev3.direct import Question
from learnblock.robots.ev3.link import BrickLink
from learnblock.robots.ev3.screen import laid_out
from learnblock.robots.ev3.settings import Settings
from learnblock.robots.ev3.wires import open_wire
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: Milliseconds that a motor runs without a new command: the firmware has no watchdog, but it has
#: timed commands.
RUN = 300
#: For each kind of sensor: its type, its mode, and the factor of its value.
KINDS = {
    "ultrasonic": (30, 0, 10.0),
    "colour": (29, 0, 1.0),
    "gyroscope": (32, 0, 1.0),
    "touch": (16, 0, 1.0),
}
#: The types of an EV3's two motors.
MOTORS = (7, 8)
#: The number of the first motor port in queries for the plugged-in devices.
FIRST_MOTOR = 16


class DirectLink(BrickLink):
    """Direct commands; each one drives, plays sounds and reads all sensors at once.

    Args:
        settings: the robot's settings.
        on_state: called with each new state.
        clock: the clock of its periods and limits.

    Raises:
        RobotNotFoundError: no such firmware answers.
        RobotConnectionError: a motor or sensor is missing at its port in the settings.
    """

    shows = True

    def __init__(
        self,
        settings: Settings,
        on_state: Callable[[State], None],
        clock: SteadyClock = MONOTONIC,
    ) -> None:
        place = settings.device or f"{settings.address}:{settings.direct_port}"
        super().__init__(place, on_state, clock)
        self._timeout = settings.patience
        self._counter = 0
        self._motors = [DirectMotor("ABCD".index(port)) for port in (settings.left, settings.right)]
        self._per_percent = settings.full_speed / 100
        self._factors: dict[str, float] = {}
        self._wire = open_wire(
            settings.device, settings.address, settings.direct_port, settings.patience, clock
        )
        try:
            self._question = self._find_plugged(settings)
        except (OSError, ValueError) as error:
            self._wire.close()
            if isinstance(error, RobotConnectionError):
                raise
            raise RobotNotFoundError("ev3-device-silent", place=self.place) from error
        except BaseException:
            self._wire.close()
            raise

    def exchange(self, word: Word) -> State:
        left, right, *readings = self._asked(self._orders(word), self._question)
        sensors = {
            kind: None if math.isnan(reading) else reading * factor
            for (kind, factor), reading in zip(self._factors.items(), readings, strict=True)
        }
        return State(left=left, right=right, **sensors)

    def hang_up(self) -> None:
        self._wire.close()

    def _orders(self, word: Word) -> bytes:
        match word:
            case Drive():
                return b"".join(
                    motor.turn(speed / self._per_percent)
                    for motor, speed in zip(self._motors, word, strict=True)
                )
            case Tone(hertz, milliseconds):
                # The firmware's limits: audible tones of at most half a minute.
                return direct.tone(
                    round(min(max(hertz, 250), 10000)), round(min(max(milliseconds, 0), 32767))
                )
            case Show(text):
                return direct.show(*laid_out(text))
            case Say():
                raise RobotConnectionError("ev3-no-speech", place=self.place)
        return b""

    def _find_plugged(self, settings: Settings) -> Question:
        """The query for all motor positions and sensor readings."""
        ports = [*range(4), *(FIRST_MOTOR + motor.port for motor in self._motors)]
        types = self._asked(b"", Question([direct.kind_of(port) for port in ports]))[::2]
        for there, name in zip(types[4:], (settings.left, settings.right), strict=True):
            if there not in MOTORS:
                raise RobotConnectionError("ev3-no-motor", place=self.place, port=name)
        queries = [direct.turned(motor.port) for motor in self._motors]
        for kind, wished in settings.sensors.items():
            number, mode, factor = KINDS[kind]
            port = self._port_of(kind, number, wished, types[:4])
            if port is not None:
                queries.append(direct.reading(port, mode))
                self._factors[kind] = factor
        return Question(queries)

    def _port_of(self, kind: str, number: int, wished: str, types: Sequence[float]) -> int | None:
        for port, there in enumerate(types):
            if there == number and wished in {"", str(port + 1)}:
                return port
        if wished:
            raise RobotConnectionError("ev3-no-sensor", place=self.place, sensor=kind, port=wished)
        return None

    def _asked(self, orders: bytes, question: Question) -> tuple[float, ...]:
        self._counter = (self._counter + 1) % 0x10000
        self._wire.send(direct.command(self._counter, orders, question))
        deadline = Deadline.after(self._timeout, self._clock)
        while True:
            reply = self._wire.receive(deadline.left)
            try:
                results = direct.answered(reply, self._counter, question)
            except direct.CommandFailedError:
                raise RobotConnectionError("ev3-command-refused", place=self.place) from None
            if results is not None:
                return results


class DirectMotor:
    """A motor whose speed is set in whole percents of its full speed.

    The next command makes up for the rounding, so that the average speed is correct: one percent is
    5 mm/s.

    Args:
        port: 0 is port A.
    """

    def __init__(self, port: int) -> None:
        self.port = port
        self._owed = 0.0

    def turn(self, speed: float) -> bytes:
        """Turn the motor for a moment at a speed in percent, with fractions."""
        if not speed:
            self._owed = 0.0
            return direct.stop(self.port)
        target = min(max(speed, -100.0), 100.0) + self._owed
        percent = min(max(round(target), -100), 100)
        self._owed = min(max(target - percent, -0.5), 0.5)
        return direct.turn(self.port, percent, RUN) if percent else direct.stop(self.port)
