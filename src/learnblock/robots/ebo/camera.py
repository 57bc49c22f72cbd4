"""EBO's camera: 20 JPEG pictures per second, sent by an MQTT broker."""

import threading
from typing import TYPE_CHECKING, Any

from learnblock.errors import RobotConnectionError
from learnblock.robots.real import require
from learnblock.timing import MONOTONIC, SteadyClock

if TYPE_CHECKING:
    from learnblock.devices import Frame

#: The topic under which EBO publishes the pictures.
TOPIC = "camara"


class StreamedCamera:
    """Receives a stream of pictures and keeps the newest one.

    Args:
        address: the broker's address.
        port: the broker's port.
        timeout: how long to wait for the broker's answer and for a picture, in seconds.
        clock: the clock of the wait for a picture.
    """

    def __init__(
        self, address: str, port: int, timeout: float, clock: SteadyClock = MONOTONIC
    ) -> None:
        self._place = address, port
        self._timeout = timeout
        self._clock = clock
        self._seen = threading.Event()
        self._came = clock.now()
        self._latest: bytes | None = None
        self._shown: bytes | None = None
        self._frame: Frame | None = None
        mqtt = require("paho.mqtt.client", "ebo")
        self._client: Any = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2)
        self._client.connect_timeout = timeout
        self._client.on_connect = self._subscribe
        self._client.on_message = self._receive

    def open(self) -> None:
        """Subscribe to the stream, and wait for its first picture.

        Raises:
            RobotConnectionError: there is no broker, or it sends no pictures.
        """
        address, port = self._place
        try:
            self._client.connect(address, port)
        except OSError as error:
            raise RobotConnectionError(
                "ebo-camera-unreachable", place=f"{address}:{port}"
            ) from error
        self._client.loop_start()
        if not self._clock.wait(self._seen, self._timeout):
            raise self._silent()

    def read(self) -> "Frame | None":
        """The newest picture; None before the first readable one.

        Raises:
            RobotConnectionError: no picture has arrived for too long.
        """
        self.check()
        latest = self._latest
        if latest is not None and latest is not self._shown:
            self._shown = latest
            # A damaged picture is skipped.
            frame = decoded(latest)
            self._frame = self._frame if frame is None else frame
        return self._frame

    def check(self) -> None:
        """Check that pictures arrive.

        Raises:
            RobotConnectionError: they do not arrive.
        """
        if self._clock.now() - self._came > self._timeout:
            raise self._silent()

    def close(self) -> None:
        """Disconnect from the broker; calling it twice is harmless."""
        self._client.disconnect()
        self._client.loop_stop()

    def _subscribe(self, *_: Any) -> None:
        # Needed again whenever the client reconnects, which it does on its own.
        self._client.subscribe(TOPIC)

    def _receive(self, _client: Any, _data: Any, message: Any) -> None:
        self._latest, self._came = message.payload, self._clock.now()
        self._seen.set()

    def _silent(self) -> RobotConnectionError:
        address, port = self._place
        return RobotConnectionError(
            "ebo-camera-silent", place=f"{address}:{port}", seconds=self._timeout
        )


def decoded(picture: bytes) -> "Frame | None":
    """A picture as a frame; None if it cannot be decoded."""
    # OpenCV is loaded with the first picture.
    import cv2  # noqa: PLC0415
    import numpy as np  # noqa: PLC0415

    try:
        frame = cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_COLOR)
    except cv2.error:
        # An empty picture, or one with an impossible size.
        return None
    return None if frame is None else np.asarray(cv2.cvtColor(frame, cv2.COLOR_BGR2RGB), np.uint8)
