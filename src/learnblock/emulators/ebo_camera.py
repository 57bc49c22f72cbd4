"""EBO's camera: an MQTT broker, and the pictures published on it."""

import shutil
import socket
import subprocess
import tempfile
import threading
from contextlib import ExitStack
from pathlib import Path
from time import monotonic
from typing import Self

import cv2

from learnblock.emulators.twin import Twin
from learnblock.errors import EmulatorError
from learnblock.robots.real import require

#: The values of EBO's own program.
TOPIC, FRAMES_PER_SECOND = "camara", 20
#: The maximum number of seconds until the broker listens.
TIMEOUT = 5.0
#: Debian installs servers in folders that are only on root's path.
_FOLDERS = ("/usr/sbin", "/usr/local/sbin")


def find_broker() -> str | None:
    """The path of the program mosquitto; None if it is not installed."""
    paths = (shutil.which("mosquitto", path=folder) for folder in (None, *_FOLDERS))
    return next((path for path in paths if path), None)


class Broker:
    """A running mosquitto; a context manager.

    Args:
        program: the path of mosquitto.
        host: the local address on which it listens.

    Attributes:
        port: its port, chosen from the free ones.

    Raises:
        EmulatorError: it does not start listening.
    """

    def __init__(self, program: str, host: str = "127.0.0.1") -> None:
        self._ending = ExitStack()
        folder = Path(self._ending.enter_context(tempfile.TemporaryDirectory()))
        self.port = _free_port(host)
        configuration = folder / "mosquitto.conf"
        configuration.write_text(f"listener {self.port} {host}\nallow_anonymous true\nuser root\n")
        self._process = subprocess.Popen(  # noqa: S603 - the program that was found
            [program, "-c", str(configuration)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        self._ending.callback(self._process.wait)
        self._ending.callback(self._process.kill)
        try:
            self._await(host)
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """End it; calling it twice is harmless."""
        self._ending.close()

    def _await(self, host: str) -> None:
        deadline = monotonic() + TIMEOUT
        while self._process.poll() is None and monotonic() < deadline:
            try:
                socket.create_connection((host, self.port), TIMEOUT).close()
            except ConnectionRefusedError:
                threading.Event().wait(0.01)
            else:
                return
        raise EmulatorError("emulator-broker-silent", place=f"{host}:{self.port}")


class CameraStream:
    """A thread that publishes the pictures of a twin's camera.

    Args:
        twin: the robot.
        host: the broker's address.
        port: the broker's port.
    """

    def __init__(self, twin: Twin, host: str, port: int) -> None:
        self._twin = twin
        mqtt = require("paho.mqtt.client", "ebo")
        self._client = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2)
        self._client.connect(host, port)
        self._client.loop_start()
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._publish, name="camera", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stop publishing."""
        self._closed.set()
        self._thread.join()
        self._client.disconnect()
        self._client.loop_stop()

    def _publish(self) -> None:
        while not self._closed.wait(1 / FRAMES_PER_SECOND):
            with self._twin.body() as body:
                view = body.view()
            frame = cv2.cvtColor(view.picture(), cv2.COLOR_RGB2BGR)
            _, picture = cv2.imencode(".jpg", frame)
            self._client.publish(TOPIC, picture.tobytes())


def _free_port(host: str) -> int:
    with socket.socket() as probe:
        probe.bind((host, 0))
        port: int = probe.getsockname()[1]
        return port
