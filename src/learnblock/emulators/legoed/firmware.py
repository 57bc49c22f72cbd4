"""What all emulated devices of LEGO Education have in common."""

import re
import struct
import threading
import time
from collections.abc import Callable, Mapping
from typing import Any

from learnblock.emulators.gatt import NOT_SUPPORTED, GattError, Notify, Services
from learnblock.robots.legoed import messages
from learnblock.robots.legoed.messages import Product
from learnblock.robots.legoed.nearby import NAMES
from learnblock.robots.real import require

#: The largest message in bytes, and the battery in %.
LARGEST, BATTERY = 244, 80
#: The software of the device and of its bootloader, as (major, minor, build).
FIRMWARE, BOOTLOADER = (1, 4, 0), (1, 0, 0)
#: How a command that moves something has ended.
COMPLETED, INTERRUPTED, REFUSED = 0, 1, 2

#: Takes a command's message, and the function that reports its end. Returns whether it has ended.
Action = Callable[[Any, Callable[[int], None]], bool]


class DeviceFirmware:
    """A device as seen by Bluetooth.

    Args:
        product: its kind.

    Attributes:
        package: the messages of LEGO's package.
        version: the version of its messages; a test lets it have another one.
        sounds: the tones that it has played, in hertz.
        lamp: the number of the light's colour, and its intensity in %.

    Raises:
        MissingPackageError: LEGO's package is not installed.
    """

    largest = LARGEST
    services: Services = {  # noqa: RUF012 - never changed
        messages.SERVICE: {
            messages.COMMANDS: ["write-without-response"],
            messages.EVENTS: ["notify"],
        }
    }

    def __init__(self, product: Product) -> None:
        self.package = require("legoeducation.rpc_message", "legoed")
        self.name = NAMES[product]
        self.product = product
        #: Its kind, and no connection card.
        self.manufacturer: Mapping[int, bytes] = {
            messages.COMPANY: product.to_bytes(2, "big") + bytes(3)
        }
        self.version = messages.version()
        self.sounds: list[int] = []
        self.lamp = (-1, 0)
        self.lock = threading.RLock()
        self._kinds = _commands(self.package)
        self._actions: dict[str, Action] = {
            "InfoRequest": self._tell,
            "DeviceNotificationRequest": self._report_every,
            "LightColorCommand": self._light,
            "PlayBeepCommand": self._beep,
            "StopSoundCommand": _nothing,
            **self.actions(),
        }
        self._notify: Notify | None = None
        self._interval = 0.0
        self._next = 0.0

    def actions(self) -> Mapping[str, Action]:
        """What its kind does, by the name of the message."""
        return {}

    def items(self) -> list[Any]:
        """What its kind reports."""
        return []

    def move(self) -> None:
        """Look at its motors, a hundred times a second."""

    def connected(self, notify: Notify) -> None:
        self._notify = notify

    def heard(self, uuid: str) -> None:
        """Begin to notify; it reports only when it is asked to."""

    def disconnected(self) -> None:
        """Let the client go; a command that has not ended goes on."""
        self._notify, self._interval = None, 0.0

    def read(self, uuid: str) -> bytes:
        del uuid
        raise GattError(NOT_SUPPORTED)

    def write(self, uuid: str, value: bytes) -> None:
        if uuid != messages.COMMANDS or not value or len(value) > LARGEST:
            raise GattError(NOT_SUPPORTED)
        while value:
            if value[0] not in self._kinds:
                return
            kind = self._kinds[value[0]]
            size = 1 + struct.calcsize(getattr(kind, "FormatString", ""))
            frame, value = value[:size], value[size:]
            if len(frame) < size:
                return
            self._take(kind, frame)

    def tick(self) -> None:
        """Move, and report if it is time to."""
        with self.lock:
            self.move()
        now = time.monotonic()
        if self._interval and now >= self._next:
            self._next = now + self._interval
            self._send(self._report())

    def _take(self, kind: type, frame: bytes) -> None:
        message = kind.Deserialize(frame[1:]) if hasattr(kind, "Deserialize") else None
        action = self._actions.get(kind.__name__)

        def end(status: int) -> None:
            self._send(self._result(kind, frame, status))

        with self.lock:
            if action is None:
                end(REFUSED)
            elif action(message, end):
                end(COMPLETED)

    def _result(self, kind: type, frame: bytes, status: int) -> bytes:
        """The result of a command; that of a motor's names the motor, too."""
        name = re.sub("Command$", "Result", re.sub("Request$", "Response", kind.__name__))
        fields = getattr(getattr(self.package, name, None), "FormatString", "<B")
        motor = frame[1:2] if fields == "<BB" else b""
        return bytes([frame[0] + 1]) + motor + bytes([status])

    def _report(self) -> bytes:
        package = self.package
        items = [
            package.InfoDeviceNotification(BATTERY, package.USB_POWER_STATE_USB_NOT_CONNECTED),
            package.CardNotification(-1, 0),
            package.ButtonStateNotification(package.BUTTON_STATE_RELEASED),
            *self.items(),
        ]
        data = b"".join(bytes(item.Serialize()) for item in items)
        return bytes(package.DeviceNotification(len(data), data).Serialize())

    def _tell(self, message: Any, end: Callable[[int], None]) -> bool:
        del message, end
        answer = self.package.InfoResponse(
            *self.version, *FIRMWARE, *BOOTLOADER, LARGEST, self.product
        )
        self._send(bytes(answer.Serialize()))
        return False

    def _report_every(self, message: Any, end: Callable[[int], None]) -> bool:
        del end
        self._interval, self._next = message.delay / 1000, 0.0
        return True

    def _light(self, message: Any, end: Callable[[int], None]) -> bool:
        del end
        self.lamp = (message.color, message.intensity)
        self.shine()
        return True

    def shine(self) -> None:
        """Show the light."""

    def _beep(self, message: Any, end: Callable[[int], None]) -> bool:
        del end
        self.sounds.append(message.frequency)
        self.sound()
        return True

    def sound(self) -> None:
        """Play the last tone."""

    def _send(self, message: bytes) -> None:
        notify = self._notify
        if notify:
            notify(messages.EVENTS, message)


def _nothing(message: Any, end: Callable[[int], None]) -> bool:
    del message, end
    return True


def accepted(*names: str) -> dict[str, Action]:
    """Commands that a twin has no use for."""
    return dict.fromkeys(names, _nothing)


def _commands(package: Any) -> dict[int, type]:
    """The classes of what a client sends, by number."""
    numbers = {
        name: number
        for name, number in vars(package).items()
        if re.fullmatch("[A-Z_]+_(COMMAND|REQUEST)", name)
    }
    return {number: getattr(package, _class_name(name)) for name, number in numbers.items()}


def _class_name(name: str) -> str:
    return name.title().replace("_", "")
