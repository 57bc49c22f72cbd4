"""EBO's camera: JPEG pictures that a broker of MQTT passes on, 20 a second."""

import threading
from time import monotonic
from typing import TYPE_CHECKING, Any

from learnblock.errors import RobotConnectionError
from learnblock.robots.real import require

if TYPE_CHECKING:
    from learnblock.devices import Frame

#: Under this name EBO publishes them.
TOPIC = "camara"


class StreamedCamera:
    """The newest picture of a stream.

    Args:
        address: where the broker is.
        port: of it.
        patience: seconds within which it must answer, and a picture must come.
    """

    def __init__(self, address: str, port: int, patience: float) -> None:
        self._place = address, port
        self._patience = patience
        self._seen = threading.Event()
        self._came = monotonic()
        self._latest: bytes | None = None
        self._shown: bytes | None = None
        self._frame: Frame | None = None
        mqtt = require("paho.mqtt.client", "ebo")
        self._client: Any = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2)
        self._client.connect_timeout = patience
        self._client.on_connect = self._subscribe
        self._client.on_message = self._receive

    def open(self) -> None:
        """Subscribe to the stream, and wait for its first picture.

        Raises:
            RobotConnectionError: there is no broker, or nobody who sends pictures.
        """
        try:
            self._client.connect(*self._place)
        except OSError as error:
            raise self._told(f"cannot be reached: {error}") from error
        self._client.loop_start()
        if not self._seen.wait(self._patience):
            raise self._told(f"has sent no picture for {self._patience:g} s")

    def read(self) -> "Frame | None":
        """The newest picture; None while none could be read.

        Raises:
            RobotConnectionError: none has come for too long.
        """
        self.check()
        latest = self._latest
        if latest is not None and latest is not self._shown:
            self._shown = latest
            # A picture that arrives broken is left out.
            frame = decoded(latest)
            self._frame = self._frame if frame is None else frame
        return self._frame

    def check(self) -> None:
        """Make sure that pictures come.

        Raises:
            RobotConnectionError: they do not.
        """
        if monotonic() - self._came > self._patience:
            raise self._told(f"has sent no picture for {self._patience:g} s")

    def close(self) -> None:
        """Let go of the broker; the second time does nothing."""
        self._client.disconnect()
        self._client.loop_stop()

    def _subscribe(self, *_: Any) -> None:
        # Again whenever the connection is made anew, as the client does by itself.
        self._client.subscribe(TOPIC)

    def _receive(self, _client: Any, _data: Any, message: Any) -> None:
        self._latest, self._came = message.payload, monotonic()
        self._seen.set()

    def _told(self, trouble: str) -> RobotConnectionError:
        address, port = self._place
        return RobotConnectionError(
            f"the camera of the robot `ebo` at {address}:{port} {trouble}; is its camera running?"
            " Without one, set `camera_port` to 0"
        )


def decoded(picture: bytes) -> "Frame | None":
    """A picture as a frame; None where it is none."""
    # OpenCV is loaded with the first picture.
    import cv2  # noqa: PLC0415
    import numpy as np  # noqa: PLC0415

    try:
        frame = cv2.imdecode(np.frombuffer(picture, np.uint8), cv2.IMREAD_COLOR)
    except cv2.error:
        # Of no bytes at all, or of a size that no picture has.
        return None
    return None if frame is None else np.asarray(cv2.cvtColor(frame, cv2.COLOR_BGR2RGB), np.uint8)
