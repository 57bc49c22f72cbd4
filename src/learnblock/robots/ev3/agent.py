#!/usr/bin/env python3
"""LearnBlock's agent: it runs on an EV3 with ev3dev, and executes a remote program's commands.

``learnblock robots setup ev3`` copies this file to the brick and starts it. After a restart of the
brick it can also be started from the brick's file browser.

It is one file, and longer than others, because it is copied to the brick. It uses only the
kernel's files under /sys/class and the standard library of Python 3.5, which is part of the ev3dev
image: python-ev3dev2 takes seconds to import on the brick, and its version varies. `Motor` and
`Sensor` have the properties of python-ev3dev2 that `Brick` needs, so that it works with either:
over rpyc, the client executes `serve` on the brick with python-ev3dev2.

The protocol is lines of JSON over TCP. The agent starts with a nonce. The client answers with its
HMAC-SHA256, made with the shared secret, and with the ports of motors and sensors:

    {"learnblock": 1, "nonce": "9f..."}
    {"proof": "3a...", "motors": ["B", "D"], "sensors": {"touch": "", "gyroscope": "2"}}
    {"state": {"left": 0, "right": 0, "touch": false, "gyroscope": -3}, "speaks": true}

Then each command of the client is answered with the brick's state, or with an error: a code and the
values of its message.

    {"drive": [143, 143]}       degrees/s of the left and the right wheel
    {"tone": [440, 500]}        hertz, milliseconds
    {"say": "hello"}
    {}                          only requests the state

The motors stop if the client sends nothing for 0.3 s, until its next drive command, and at the
end of the connection.
"""

import argparse
import binascii
import hashlib
import hmac
import json
import os
import re
import select
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple

SYSFS = "/sys/class"
PORT = 18813
#: The maximum number of bytes of a line.
LONGEST_LINE = 4096
#: Seconds of silence until the motors stop, until a client may be replaced by another, and until an
#: unidentified client must have proved that it knows the secret.
SILENCE, ABSENCE, INTRODUCTION = 0.3, 1.5, 3.0
#: Seconds between two readings of the battery, which changes slowly.
BATTERY_PERIOD = 5.0
#: The maximum number of connections; all but one are unidentified.
MOST_CLIENTS = 8
#: The answer to a second client.
TAKEN = {"error": "ev3-taken", "taken": True}
#: For each kind of sensor: its drivers, its mode, and the factor of its value.
KINDS = {
    "ultrasonic": (("lego-ev3-us", "lego-nxt-us"), "US-DIST-CM", 10.0),
    "colour": (("lego-ev3-color",), "COL-REFLECT", 1.0),
    "gyroscope": (("lego-ev3-gyro",), "GYRO-ANG", 1.0),
    "touch": (("lego-ev3-touch", "lego-nxt-touch"), "TOUCH", 1.0),
}


class BrickError(Exception):
    """An error that is reported to the client: the code of a message, and its values."""

    def __init__(self, code: str, values: Dict[str, str]) -> None:
        Exception.__init__(self, code)
        self.code = code
        self.values = values

    def answer(self) -> str:
        """The line that reports it."""
        return json.dumps({"error": self.code, "values": self.values})


class BrickClock:
    """The brick's clock; tests use one that they set."""

    def now(self) -> float:
        """Seconds since some moment in the past."""
        return time.monotonic()

    def wait(self, event: threading.Event, seconds: float) -> bool:
        """Wait until the event is set, or seconds have passed; return whether it is set."""
        return event.wait(seconds)


class Device:
    """A folder of the kernel whose files are the attributes of a motor or sensor."""

    def __init__(self, folder: str) -> None:
        self._folder = folder
        self._files = {}  # type: Dict[Tuple[str, str], Any]

    def _get(self, name: str) -> str:
        file = self._file(name, "rb")
        # Only the first line: the rest is left over from a longer value.
        return str(file.read(256).decode().partition("\n")[0].strip())

    def _set(self, name: str, value: object) -> None:
        self._file(name, "wb").write("{}\n".format(value).encode())

    def _file(self, name: str, mode: str) -> Any:
        """The open file, at position 0, where the kernel reads and writes a whole value."""
        if (name, mode) not in self._files:
            self._files[name, mode] = open(  # noqa: SIM115 - kept
                os.path.join(self._folder, name), mode, buffering=0
            )
        file = self._files[name, mode]
        file.seek(0)
        return file


class Motor(Device):
    """The motor with an address such as outB."""

    def __init__(self, address: str) -> None:
        for folder in folders("tacho-motor"):
            Device.__init__(self, folder)
            if self._get("address").endswith(address):
                return
        raise LookupError(address)

    position = property(lambda self: int(self._get("position")))
    max_speed = property(lambda self: int(self._get("max_speed")))
    speed_sp = property(None, lambda self, value: self._set("speed_sp", value))
    stop_action = property(None, lambda self, value: self._set("stop_action", value))
    command = property(None, lambda self, value: self._set("command", value))


class Sensor(Device):
    """The sensor with this folder."""

    address = property(lambda self: self._get("address"))
    driver_name = property(lambda self: self._get("driver_name"))
    decimals = property(lambda self: int(self._get("decimals")))
    mode = property(lambda self: self._get("mode"), lambda self, value: self._set("mode", value))

    def value(self) -> int:
        return int(self._get("value0"))


class Battery:
    """The brick's battery, read occasionally."""

    def __init__(self, clock: BrickClock) -> None:
        self._clock = clock
        self._read = None  # type: Optional[float]
        self._volts = None  # type: Optional[float]

    def volts(self) -> Optional[float]:
        """Its voltage; None if the kernel does not report it."""
        now = self._clock.now()
        if self._read is None or now - self._read > BATTERY_PERIOD:
            self._read, self._volts = now, self._measure()
        return self._volts

    def _measure(self) -> Optional[float]:
        for folder in folders("power_supply"):
            try:
                with open(os.path.join(folder, "voltage_now")) as file:
                    return int(file.readline()) / 1e6
            except (OSError, ValueError):
                # Not every power supply reports a voltage.
                continue
        return None


def list_sensors() -> Iterator[Sensor]:
    """Every sensor that is plugged in."""
    return (Sensor(folder) for folder in folders("lego-sensor"))


def folders(kind: str) -> List[str]:
    """The folders of all devices of a kernel class."""
    path = os.path.join(SYSFS, kind)
    names = sorted(os.listdir(path)) if os.path.isdir(path) else []
    return [os.path.join(path, name) for name in names]


class Brick:
    """The motors and sensors that a client uses.

    Args:
        wish: the requested ports of the motors, left and right, and of each sensor; "" is any port.
        motor: creates the motor with an address.
        sensors: lists the sensors.
        clock: the brick's clock.
    """

    def __init__(
        self,
        wish: Dict[str, Any],
        motor: Callable[..., Any],
        sensors: Callable[[], Any],
        clock: BrickClock,
    ) -> None:
        self._motors = [open_motor(motor, port) for port in wish["motors"]]
        self._fastest = [motor.max_speed for motor in self._motors]
        self._battery = Battery(clock)
        self._sensors = {}  # type: Dict[str, Tuple[Any, float]]
        plugged = list(sensors())
        for kind, port in sorted(wish["sensors"].items()):
            sensor = find_sensor(plugged, kind, port)
            if sensor:
                self._sensors[kind] = sensor
        self._sounds = []  # type: List[Any]

    def state(self) -> Dict[str, Any]:
        """Degrees that the wheels have turned, and sensor readings; None for a lost sensor."""
        state = dict(zip(("left", "right"), self._positions()))  # type: Dict[str, Any]
        for kind, (sensor, factor) in self._sensors.items():
            state[kind] = reading(sensor, factor)
        state["battery"] = self._battery.volts()
        return state

    def drive(self, speeds: List[float]) -> None:
        """Turn the wheels at these speeds in degrees/s, limited to their maximum."""
        for motor, fastest, speed in zip(self._motors, self._fastest, speeds):
            target = round(min(max(speed, -fastest), fastest))
            with cable():
                if target:
                    motor.speed_sp = target
                    motor.command = "run-forever"
                else:
                    motor.stop_action = "brake"
                    motor.command = "stop"

    def tone(self, sound: List[float]) -> None:
        """Play a tone: hertz, milliseconds."""
        hertz, milliseconds = sound
        self._sound(["beep", "-f", str(hertz), "-l", str(int(milliseconds))])

    def say(self, text: str) -> None:
        """Speak a text."""
        speech = self._sound(["espeak", "-a", "200", "-s", "130", "--stdout", "--", text])
        if speech:
            self._sound(["aplay", "-q"], speech.stdout)
            speech.stdout.close()

    def hush(self) -> None:
        """Stop all sounds."""
        for sound in self._sounds:
            if sound.poll() is None:
                sound.terminate()
            sound.wait()

    def _positions(self) -> List[int]:
        with cable():
            return [motor.position for motor in self._motors]

    def _sound(self, command: List[str], source: Any = None) -> Any:
        self._sounds = [sound for sound in self._sounds if sound.poll() is None]
        out = subprocess.PIPE if "--stdout" in command else subprocess.DEVNULL
        try:
            process = subprocess.Popen(  # noqa: S603 - no shell
                command, stdin=source or subprocess.DEVNULL, stdout=out, stderr=subprocess.DEVNULL
            )
        except OSError:
            # On a brick without that program there is no sound.
            return None
        self._sounds.append(process)
        return process


def open_motor(motor: Callable[..., Any], port: str) -> Any:
    """The motor at a port."""
    try:
        return motor(address="out" + port)
    except Exception:  # noqa: BLE001 - our motor and python-ev3dev2's raise different errors
        raise BrickError("ev3-no-motor", {"port": port}) from None


def find_sensor(plugged: List[Any], kind: str, port: str) -> Optional[Tuple[Any, float]]:
    """A sensor of this kind, set to its mode, with the factor of its values."""
    drivers, mode, factor = KINDS[kind]
    for sensor in plugged:
        where = re.search("in([1-4])", sensor.address)
        if sensor.driver_name in drivers and (not port or (where and where.group(1) == port)):
            if sensor.mode != mode:
                sensor.mode = mode
            return sensor, factor / 10**sensor.decimals
    if port:
        raise BrickError("ev3-no-sensor", {"sensor": kind, "port": port})
    return None


def reading(sensor: Any, factor: float) -> Optional[float]:
    """A sensor's reading; None if its cable is unplugged."""
    try:
        return float(sensor.value() * factor)
    except Exception:  # noqa: BLE001 - different errors, as above
        return None


class cable:  # noqa: N801 - used like a function
    """Reports a motor's error as an unplugged cable."""

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: object, error: object, traceback: object) -> None:
        if isinstance(error, Exception):
            raise BrickError("ev3-motor-lost", {}) from error


class Guard:
    """Answers the commands of one client, and stops the motors if it sends nothing.

    Args:
        brick: the brick.
        at_end: called when the client is gone.
        clock: the brick's clock.
    """

    def __init__(self, brick: Brick, at_end: Callable[[], object], clock: BrickClock) -> None:
        self._brick = brick
        self._clock = clock
        self._at_end = at_end
        self._lock = threading.Lock()
        self._moves = False
        self._closed = threading.Event()
        self.heard = self._clock.now()
        self._thread = threading.Thread(target=self._watch, name="guard", daemon=True)
        self._thread.start()

    def answer(self, line: str) -> str:
        """The answer to a line, as a line."""
        try:
            return json.dumps(self._answered(parsed(line)))
        except BrickError as error:
            return error.answer()

    def close(self) -> None:
        """Stop the motors and end the watchdog."""
        self._closed.set()
        with self._lock:
            self._stop()
            self._brick.hush()
            self._at_end()

    def _answered(self, word: Dict[str, Any]) -> Dict[str, Any]:
        with self._lock:
            if self._closed.is_set():
                raise BrickError("ev3-timed-out", {})
            self.heard = self._clock.now()
            if "drive" in word:
                speeds = numbers(word["drive"])
                self._moves = any(speeds)
                self._brick.drive(speeds)
            if "tone" in word:
                self._brick.tone(numbers(word["tone"]))
            if "say" in word:
                self._brick.say(str(word["say"]))
            return {"state": self._brick.state(), "speaks": bool(shutil.which("espeak"))}

    def _watch(self) -> None:
        while not self._clock.wait(self._closed, self.look(self._clock.now())):
            continue

    def look(self, now: float) -> float:
        """Stop what has to be stopped by now; return the seconds until the next look.

        At most `SILENCE`: the silence after a word that arrives until then isn't over before it.
        """
        with self._lock:
            silence, absence = self.heard + SILENCE, self.heard + ABSENCE
            if self._moves and now >= silence:
                self._stop()
        if now >= absence:
            # A client that returns later gets an error.
            self.close()
        return max(0.0, min(SILENCE, (silence if now < silence else absence) - now))

    def _stop(self) -> None:
        self._moves = False
        try:
            self._brick.drive([0, 0])
        except BrickError:
            # An unplugged motor does not turn anyway.
            return


def parsed(line: str) -> Dict[str, Any]:
    """Parse a line of the client."""
    try:
        word = json.loads(line)
    except (ValueError, RecursionError):
        word = None
    if not isinstance(word, dict):
        raise BrickError("ev3-not-understood", {})
    return word


def numbers(pair: Any) -> List[float]:
    """Two finite numbers."""
    try:
        first, second = (float(number) for number in pair)
    except (TypeError, ValueError, OverflowError):
        raise BrickError("ev3-not-understood", {}) from None
    if not abs(first) + abs(second) < 1e9:
        raise BrickError("ev3-not-understood", {})
    return [first, second]


def wished(word: Dict[str, Any]) -> Dict[str, Any]:
    """The ports that a client requests."""
    motors, sensors = word.get("motors"), word.get("sensors")
    right = (
        isinstance(motors, list)
        and len(motors) == 2
        and all(port in ("A", "B", "C", "D") for port in motors)
        and isinstance(sensors, dict)
        and all(kind in KINDS for kind in sensors)
        and all(port in ("", "1", "2", "3", "4") for port in sensors.values())
    )
    if not right:
        raise BrickError("ev3-not-understood", {})
    return {"motors": motors, "sensors": sensors}


def serve(
    line: str,
    motor: Callable[..., Any],
    sensors: Callable[[], Any],
    at_end: Callable[[], object] = lambda: None,
    clock: Optional[BrickClock] = None,
) -> Guard:
    """Start answering a client; its first line names the ports of motors and sensors."""
    clock = clock or BrickClock()
    return Guard(Brick(wished(parsed(line)), motor, sensors, clock), at_end, clock)


class Conversation:
    """A connection from a client.

    The client is unidentified until it has proved that it knows the secret.

    Args:
        connection: the client's socket.
        since: when it came, by the brick's clock.
    """

    def __init__(self, connection: socket.socket, since: float) -> None:
        connection.settimeout(0)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.connection = connection
        self.guard = None  # type: Optional[Guard]
        self.since = since
        self.nonce = binascii.hexlify(os.urandom(16)).decode()
        self._begun = b""
        self.put(json.dumps({"learnblock": 1, "nonce": self.nonce}))

    def put(self, line: str) -> None:
        """Send a line.

        Raises:
            OSError: the client does not read.
        """
        self.connection.sendall(line.encode() + b"\n")

    def lines(self) -> List[str]:
        """The complete lines that have arrived."""
        data = self.connection.recv(LONGEST_LINE)
        if not data:
            raise OSError("closed")
        *complete, self._begun = (self._begun + data).split(b"\n")
        if len(self._begun) > LONGEST_LINE:
            raise OSError("too long")
        return [line.decode("utf-8", "replace") for line in complete]

    def close(self) -> None:
        if self.guard:
            self.guard.close()
        self.connection.close()


class Agent:
    """Serves one client at a time.

    Args:
        listener: a socket that listens.
        token: the secret shared with the client.
        clock: the brick's clock.
    """

    def __init__(
        self, listener: socket.socket, token: str, clock: Optional[BrickClock] = None
    ) -> None:
        self._clock = clock or BrickClock()
        self._listener = listener
        self._token = token.encode()
        self._clients = {}  # type: Dict[socket.socket, Conversation]

    def run(self) -> None:
        """Serve until it is interrupted."""
        try:
            while True:
                self.turn()
        finally:
            for client in self._clients.values():
                client.close()

    def turn(self) -> None:
        """Wait for clients, and serve those that say something; at most half a second."""
        remaining = self.left(self._clock.now())
        ready, _, _ = select.select([self._listener, *self._clients], [], [], remaining)
        for connection in ready:
            if connection is self._listener:
                self._welcome()
            else:
                self._hear(self._clients[connection])
        for client in self.overdue(self._clock.now()):
            self._dismiss(client)

    def left(self, now: float) -> float:
        """Seconds until a client is overdue; at most half a second."""
        came = [client.since for client in self._clients.values() if not client.guard]
        return max(0.0, min([0.5] + [since + INTRODUCTION - now for since in came]))

    def overdue(self, now: float) -> List[Conversation]:
        """The clients that should have proved by now that they know the secret."""
        strangers = [client for client in self._clients.values() if not client.guard]
        return [client for client in strangers if now >= client.since + INTRODUCTION]

    def _welcome(self) -> None:
        connection, _ = self._listener.accept()
        if len(self._clients) >= MOST_CLIENTS:
            # The unidentified client that has waited longest is dropped.
            strangers = [client for client in self._clients.values() if not client.guard]
            self._dismiss(min(strangers, key=lambda client: client.since))
        try:
            self._clients[connection] = Conversation(connection, self._clock.now())
        except OSError:
            connection.close()

    def _hear(self, client: Conversation) -> None:
        try:
            for line in client.lines():
                if client.guard:
                    client.put(client.guard.answer(line))
                else:
                    client.put(self._introduced(client, line))
                    if not client.guard:
                        raise OSError("refused")
        except OSError:
            self._dismiss(client)

    def _introduced(self, client: Conversation, line: str) -> str:
        """The answer to an unidentified client, which becomes the client if it is accepted."""
        try:
            self._check(client, parsed(line))
            if self._is_taken():
                return json.dumps(TAKEN)
            client.guard = serve(line, Motor, list_sensors, clock=self._clock)
        except BrickError as error:
            return error.answer()
        return client.guard.answer("{}")

    def _check(self, client: Conversation, word: Dict[str, Any]) -> None:
        proof = hmac.new(self._token, client.nonce.encode(), hashlib.sha256).hexdigest()
        if not hmac.compare_digest(proof.encode(), str(word.get("proof")).encode()):
            raise BrickError("ev3-unknown-token", {})

    def _is_taken(self) -> bool:
        """Whether there is a client; one that has been silent for too long is closed."""
        for other in list(self._clients.values()):
            if other.guard:
                if self._clock.now() - other.guard.heard < ABSENCE:
                    return True
                self._dismiss(other)
        return False

    def _dismiss(self, client: Conversation) -> None:
        self._clients.pop(client.connection, None)
        client.close()


def listen(address: str, port: int) -> socket.socket:
    """A socket that listens."""
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    listener.bind((address, port))
    listener.listen(MOST_CLIENTS)
    return listener


def main() -> None:
    """Run on the brick."""
    global SYSFS  # noqa: PLW0603 - set once, before everything else
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description="LearnBlock's agent on an EV3.")
    parser.add_argument("--address", default="", help="where to listen; everywhere by default")
    parser.add_argument("--port", type=int, default=PORT)
    parser.add_argument("--token", default=os.path.join(here, ".learnblock-token"))
    parser.add_argument("--sysfs", default=SYSFS)
    options = parser.parse_args()
    SYSFS = options.sysfs
    with open(options.token) as file:
        token = file.read().strip()
    # The next setup needs it to end this agent.
    with open(os.path.join(os.path.dirname(options.token), ".learnblock-pid"), "w") as file:
        file.write(str(os.getpid()))
    for name in ("SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        # A signal that nohup ignores stays ignored.
        if number and signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, lambda *_: sys.exit(0))
    with listen(options.address, options.port) as listener:
        print("listening at port", listener.getsockname()[1], flush=True)  # noqa: T201 - for setup
        try:
            Agent(listener, token).run()
        except KeyboardInterrupt:
            return


if __name__ == "__main__":
    main()
