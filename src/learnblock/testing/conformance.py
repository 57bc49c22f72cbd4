"""Does a client keep what every robot promises? `check_robot` asks it, and writes a certificate.

    >>> from learnblock.devices import Base
    >>> from learnblock.testing import FakeRobot, check_robot
    >>> certificate = check_robot(lambda: FakeRobot(only=[Base]))
    >>> certificate.passed
    True

For a robot of one's own, with a wire that can be made to fail between the client and the robot:

    with Relay((address, port)) as relay:
        print(check_robot(lambda: Robot(address="127.0.0.1", port=relay.port), relay=relay))
"""

import math
import re
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from time import monotonic
from typing import Any

from learnblock.blocks import all_configurations
from learnblock.client import Client
from learnblock.devices import (
    DEVICE_TYPES,
    Accelerometer,
    Base,
    Camera,
    Gyroscope,
    JointMotor,
    Pose,
    Sensor,
)
from learnblock.errors import DeviceValueError, RobotConnectionError, RobotStoppedError
from learnblock.testing.forms import has_form
from learnblock.testing.relay import Fault, Relay

Make = Callable[[], Client]

#: Seconds within which the motors stand still once a robot is told to stop.
STOPPING = 0.5


class NotConformingError(AssertionError):
    """A client does not keep what every robot promises; the certificate says where."""


@dataclass(frozen=True, slots=True)
class Finding:
    """What came of one claim.

    Args:
        claim: one sentence.
        outcome: ``holds``, ``broken``, ``excused``, or ``silent`` where the robot lacks what it
            speaks of.
        detail: what was measured, or why it is broken or excused.
    """

    claim: str
    outcome: str
    detail: str = ""


@dataclass(frozen=True, slots=True)
class Certificate:
    """What came of all claims; as text it is a table for people."""

    robot: str
    findings: tuple[Finding, ...]

    @property
    def passed(self) -> bool:
        return not any(finding.outcome == "broken" for finding in self.findings)

    def __str__(self) -> str:
        verdict = "conforms" if self.passed else "does not conform"
        lines = [f"{one.outcome:<8} {one.claim:<58} {one.detail}" for one in self.findings]
        return "\n".join([f"{self.robot} {verdict}", *(line.rstrip() for line in lines)])


def check_robot(
    make_robot: Make,
    *,
    relay: Relay | None = None,
    excused: Mapping[str, str] | None = None,
    patience: float = 5.0,
) -> Certificate:
    """Ask a client for everything that a robot promises.

    It drives: forward for a second at 50 mm/s and to the right by 45 degrees, several times.

    Args:
        make_robot: makes the client, connected; called many times, never while another one lives
            except to see what a second client meets.
        relay: the wire between client and robot, for what happens when it fails; None leaves these
            claims out.
        excused: claims that need not hold, with the reason.
        patience: seconds in which it connects, notices that its link is gone, and lets go.

    Raises:
        NotConformingError: a claim is broken.
    """
    bench = _Bench(make_robot, relay, patience)
    with bench.robot() as robot:
        name = re.sub(r".*\.(\w+)\.\w+$", r"\1", f"{type(robot).__module__}.{type(robot).__name__}")
    findings = [_finding(bench, claim, check, excused or {}) for claim, check in _CLAIMS.items()]
    certificate = Certificate(name, tuple(findings))
    if not certificate.passed:
        raise NotConformingError(str(certificate))
    return certificate


def _finding(
    bench: "_Bench", claim: str, check: Callable[["_Bench"], str], excused: Mapping[str, str]
) -> Finding:
    if claim in excused:
        return Finding(claim, "excused", excused[claim])
    try:
        return Finding(claim, "holds", check(bench))
    except _Silent as reason:
        return Finding(claim, "silent", str(reason))
    except Exception as error:  # noqa: BLE001 - a stranger's client may raise whatever it likes
        kind = "" if isinstance(error, _Broken) else f"{type(error).__name__}: "
        return Finding(claim, "broken", f"{kind}{error}")


class _Broken(Exception):  # noqa: N818 - a verdict
    """The claim does not hold."""


class _Silent(Exception):  # noqa: N818 - a verdict
    """The robot lacks what the claim speaks of."""


@dataclass
class _Bench:
    """Where a client is tried."""

    make: Make
    relay: Relay | None
    patience: float

    @contextmanager
    def robot(self) -> Iterator[Client]:
        """A client, which is let go of afterwards."""
        robot = self.make()
        try:
            yield robot
        finally:
            robot.stop()

    @contextmanager
    def fault(self, fault: Fault) -> Iterator[None]:
        """A wire that fails."""
        if self.relay is None:
            raise _Silent("no relay was given")
        self.relay.fault = fault
        try:
            yield
        finally:
            self.relay.fault = Fault.NONE

    @contextmanager
    def in_time(self, what: str, seconds: float | None = None) -> Iterator[None]:
        """Within it no more than the bench's patience may pass."""
        allowed = self.patience if seconds is None else seconds
        began = monotonic()
        yield
        took = monotonic() - began
        if took > allowed:
            raise _Broken(f"{what} took {took:.1f} s, {allowed:g} s are allowed")


def _require(holds: bool, sentence: str) -> None:  # noqa: FBT001 - it holds or it does not
    if not holds:
        raise _Broken(sentence)


# Devices.


def _connects(bench: _Bench) -> str:
    began = monotonic()
    with bench.in_time("connecting"):
        robot = bench.make()
    robot.stop()
    return f"{monotonic() - began:.2f} s"


def _announces(bench: _Bench) -> str:
    with bench.robot() as robot:
        found = {f"{type(device).__name__}:{key}" for key, device in robot.devices()}
        announced = robot.known_devices()
    _require(bool(found), "it has no device")
    _require(announced is None or announced == found, f"{announced} are announced, not {found}")
    return ", ".join(sorted(found))


def _has_usual_keys(bench: _Bench) -> str:
    with bench.robot() as robot:
        keys = {(type(device), key) for key, device in robot.devices()}
    wrong = [key for _, key in keys if not re.fullmatch(r"\w[\w ]*", key)]
    _require(not wrong, f"{wrong} are no words")
    gyroscopes = {key for kind, key in keys if kind is Gyroscope}
    _require(not gyroscopes or "Z_AXIS" in gyroscopes, "no gyroscope has the key Z_AXIS")
    return ""


def _reads(bench: _Bench) -> str:
    with bench.robot() as robot:
        sensors = _sensors(robot)
        for name, sensor in sensors.items():
            _check_reading(bench, name, sensor)
    return f"{len(sensors)} sensors"


def _sensors(robot: Client) -> dict[str, Sensor[Any]]:
    """Its sensors as ``Type:KEY``."""
    devices = [(f"{type(device).__name__}:{key}", device) for key, device in robot.devices()]
    sensors = {name: device for name, device in devices if isinstance(device, Sensor)}
    if not sensors:
        raise _Silent("it has no sensor")
    return sensors


def _check_reading(bench: _Bench, name: str, sensor: Sensor[Any]) -> None:
    reading = sensor.read()
    if isinstance(sensor, Camera):
        until = monotonic() + bench.patience
        while reading is None and monotonic() < until:
            reading = sensor.read()
    _require(has_form(sensor, reading), f"{name} reads {reading!r:.120}")


def _weighs(bench: _Bench) -> str:
    with bench.robot() as robot:
        sensor = robot.device(Accelerometer)
        if sensor is None:
            raise _Silent("it has no accelerometer")
        x, y, z = sensor.read()
    _require(7 < z < 12.5 and abs(x) < 4 and abs(y) < 4, f"it reads {(x, y, z)} at rest")
    return f"{z:.2f} m/s2 upwards"


def _reads_often(bench: _Bench) -> str:
    with bench.robot() as robot:
        rates = {name: _rate(sensor) for name, sensor in _sensors(robot).items()}
    slow = [name for name, rate in rates.items() if rate < 5]
    _require(not slow, f"{', '.join(slow)} are read less than 5 times a second")
    return ", ".join(f"{name} {min(rate, 9999):.0f}/s" for name, rate in sorted(rates.items()))


def _rate(sensor: Sensor[Any]) -> float:
    """Readings a second, over 0.2 s, or over fifty where these take less."""
    # The first one may have to open what it reads.
    sensor.read()
    began, count = monotonic(), 0
    while monotonic() - began < 0.2 and count < 50:
        sensor.read()
        count += 1
    return count / (monotonic() - began)


def _lacks_quietly(bench: _Bench) -> str:
    count = 0
    with bench.robot() as robot:
        present = frozenset(f"{type(one).__name__}:{key}" for key, one in robot.devices())
        for kind in DEVICE_TYPES.values():
            missing = f"{kind.__name__}:NONE"
            _require(robot.device(kind, "NONE") is None, f"{missing} is there")
        for skill in all_configurations().values():
            required = any(parameter.required for parameter in skill.parameters)
            if required or not skill.lacks(present):
                continue
            answer = getattr(robot, skill.name)()
            _require(answer is None or not answer, f"{skill.name} answers {answer!r}")
            count += 1
    return f"{count} skills"


# Driving.


def _base(robot: Client) -> Base:
    base = robot.device(Base)
    if base is None:
        raise _Silent("it has no base")
    return base


def _drives_forward(bench: _Bench) -> str:
    with bench.robot() as robot:
        base = _base(robot)
        before = _pose(base)
        base.move(50, 0)
        robot.clock.sleep(1)
        base.stop()
        after = _pose(base)
    heading = math.radians(before[2])
    ahead = (after[0] - before[0]) * math.cos(heading) - (after[1] - before[1]) * math.sin(heading)
    _require(25 < ahead < 90, f"50 mm/s for 1 s took it {ahead:.0f} mm forward")
    return f"{ahead:.0f} mm"


def _pose(base: Base) -> Pose:
    read = base.functions.get("read")
    if read is None:
        raise _Silent("its base has no odometry")
    x, y, heading = read()
    return float(x), float(y), float(heading)


def _turns_right(bench: _Bench) -> str:
    with bench.robot() as robot:
        base, gyroscope = _base(robot), robot.device(Gyroscope, "Z_AXIS")
        read = gyroscope.read if gyroscope else lambda: _pose(base)[2]
        before = read()
        base.move(0, 45)
        robot.clock.sleep(1)
        base.stop()
        turned = (read() - before + 180) % 360 - 180
    _require(20 < turned < 80, f"45 degrees/s for 1 s turned it by {turned:.0f} degrees")
    return f"{turned:.0f} degrees"


def _zeroes(bench: _Bench) -> str:
    with bench.robot() as robot:
        gyroscope = robot.device(Gyroscope, "Z_AXIS")
        if gyroscope is None:
            raise _Silent("it has no gyroscope")
        gyroscope.reset()
        reading = gyroscope.read()
    _require(abs(reading) < 3, f"it reads {reading} after its reset")
    return ""


def _bends(bench: _Bench) -> str:
    with bench.robot() as robot:
        joints = [(key, one) for key, one in robot.devices() if isinstance(one, JointMotor)]
        if not joints:
            raise _Silent("it has no joint")
        for key, joint in joints:
            joint.move(10)
            read = joint.functions.get("read")
            if read is None:
                continue
            until = monotonic() + bench.patience
            while abs(read() - 10) > 3 and monotonic() < until:
                robot.clock.sleep(0.05)
            _require(abs(read() - 10) <= 3, f"{key} is at {read():.1f} after move(10)")
    return ", ".join(key for key, _ in joints)


def _refuses(bench: _Bench) -> str:
    with bench.robot() as robot:
        base = _base(robot)
        for value in (math.nan, math.inf, "fast", None):
            try:
                base.move(value, 0)  # type: ignore[arg-type] # that is the point
            except DeviceValueError:
                continue
            raise _Broken(f"move({value!r}, 0) is accepted")
    return ""


# Endings.


def _stops(bench: _Bench) -> str:
    for end in (_by_stop, _by_leaving, _by_error):
        robot = bench.make()
        if base := robot.device(Base):
            base.move(50, 20)
        with bench.in_time("stopping", STOPPING):
            end(robot)
        _require(robot.stopped, f"it lives on after its end {end.__name__.replace('_', ' ')}")
        _require_mute(robot)
        _require_rest(bench)
    return "by stop, by leaving `with`, by an error"


def _by_stop(robot: Client) -> None:
    robot.stop()


def _by_leaving(robot: Client) -> None:
    with robot:
        pass


def _by_error(robot: Client) -> None:
    try:
        with robot:
            raise ZeroDivisionError
    except ZeroDivisionError:
        return


def _require_mute(robot: Client) -> None:
    try:
        robot.device(Base)
    except RobotStoppedError:
        return
    raise _Broken("it can be asked for devices after it was stopped")


def _require_rest(bench: _Bench) -> None:
    """Whoever comes next finds it standing."""
    with bench.robot() as robot:
        base = robot.device(Base)
        if base is None or "read" not in base.functions:
            return
        before = _pose(base)
        robot.clock.sleep(0.5)
        after = _pose(base)
    moved = math.dist(before[:2], after[:2])
    _require(moved < 10, f"it moved on by {moved:.0f} mm after its end")


def _closes_twice(bench: _Bench) -> str:
    robot = bench.make()
    robot.stop()
    robot.stop()
    return ""


def _comes_again(bench: _Bench) -> str:
    for _ in range(3):
        with bench.robot() as robot, bench.in_time("a reading"):
            for _, device in robot.devices():
                if isinstance(device, Sensor):
                    device.read()
    return "three times"


def _shares(bench: _Bench) -> str:
    with bench.robot():
        try:
            with bench.in_time("a second client"):
                bench.make().stop()
        except RobotConnectionError as refusal:
            return f"a second one is refused: {refusal}"
    return "a second one is served"


# A wire that fails.


def _notices_silence(bench: _Bench) -> str:
    return _notices(bench, Fault.SILENT)


def _notices_cut(bench: _Bench) -> str:
    return _notices(bench, Fault.CUT)


def _notices_garbage(bench: _Bench) -> str:
    return _notices(bench, Fault.GARBAGE)


def _notices(bench: _Bench, fault: Fault) -> str:
    robot = bench.make()
    try:
        with bench.fault(fault):
            sentence, took = _wait_for_loss(bench, robot)
            with bench.in_time("letting go"):
                _let_go(robot)
    finally:
        _let_go(robot)
    _connects(bench)
    return f"after {took:.1f} s: {sentence}"


def _wait_for_loss(bench: _Bench, robot: Client) -> tuple[str, float]:
    began = monotonic()
    while monotonic() - began < bench.patience:
        try:
            _use(robot)
        except RobotConnectionError as error:
            return str(error), monotonic() - began
        robot.clock.sleep(0.02)
    raise _Broken(f"nothing was said for {bench.patience:g} s")


def _use(robot: Client) -> None:
    for _, device in robot.devices():
        if isinstance(device, Sensor):
            device.read()
        elif isinstance(device, Base):
            device.move(10, 0)
    robot.check_link()


def _let_go(robot: Client) -> None:
    try:
        robot.stop()
    except RobotConnectionError:
        # It could not be told, and says so: fair enough on a link that is gone.
        return


def _bears_slowness(bench: _Bench) -> str:
    with bench.fault(Fault.SLOW), bench.in_time("connecting", 2 * bench.patience):
        try:
            with bench.robot() as robot:
                _use(robot)
        except RobotConnectionError as error:
            return f"says: {error}"
    return "goes on"


def _is_not_there(bench: _Bench) -> str:
    sentences = []
    for fault in (Fault.CUT, Fault.SILENT):
        with bench.fault(fault), bench.in_time("being refused"):
            try:
                bench.make().stop()
            except RobotConnectionError as error:
                sentences.append(str(error))
            else:
                raise _Broken(f"it connects to a robot whose wire is {fault.name.lower()}")
    return sentences[0]


_CLAIMS: Mapping[str, Callable[[_Bench], str]] = {
    "it connects in time": _connects,
    "it has the devices it announces": _announces,
    "its devices have words as keys": _has_usual_keys,
    "its readings have the form and range of their device": _reads,
    "its accelerometer shows 1 g upwards at rest": _weighs,
    "its sensors are read at least 5 times a second": _reads_often,
    "what it lacks has no effect": _lacks_quietly,
    "positive speed is forward": _drives_forward,
    "positive rotation is to the right": _turns_right,
    "its gyroscope reads 0 after a reset": _zeroes,
    "its joints go where they are told": _bends,
    "values that are no numbers are refused": _refuses,
    "its motors stop however it ends": _stops,
    "it can be stopped twice": _closes_twice,
    "it can be connected again": _comes_again,
    "a second client at the same time does not hang": _shares,
    "a robot that is not there is told in time": _is_not_there,
    "a wire that falls silent is told in time": _notices_silence,
    "a wire that is cut is told in time": _notices_cut,
    "a wire that brings nonsense is told in time": _notices_garbage,
    "a slow wire is borne, or told": _bears_slowness,
}

#: The claims, for those who excuse one.
CLAIMS: Collection[str] = tuple(_CLAIMS)
