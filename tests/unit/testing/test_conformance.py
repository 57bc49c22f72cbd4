"""The rules for every robot, checked on good clients and on ones that break each rule."""

from itertools import cycle

import pytest

from learnblock import robots
from learnblock.client import Client
from learnblock.devices import Base, DistanceSensors, Gyroscope
from learnblock.testing import (
    CLAIMS,
    LINK_CLAIMS,
    FakeRobot,
    NotConformingError,
    VirtualClock,
    check_robot,
    device_claims,
)

#: A fake robot's camera sees what a test gives it, by default nothing.
NO_FRAME = {"its readings have the form and range of their device": "no frame is set"}


@pytest.mark.parametrize("name", ["sim-ebo", "sim-thymio", "sim-ev3", "sim-cozmo"])
def test_every_twin_conforms(name):
    certificate = check_robot(robots.find(name).load())
    assert certificate.passed
    assert str(certificate).startswith(f"{name.replace('-', '_')} conforms")


def test_the_fake_robot_conforms():
    certificate = check_robot(FakeRobot, excused=NO_FRAME)
    outcomes = {finding.claim: finding.outcome for finding in certificate.findings}
    assert list(outcomes) == list(CLAIMS)
    assert outcomes["positive rotation is to the right"] == "holds"
    assert outcomes[next(iter(NO_FRAME))] == "excused"


class Broken(FakeRobot):
    """Each subclass breaks one rule."""

    def __init__(self):
        super().__init__(only=[Base, Gyroscope, DistanceSensors])


class Backwards(Broken):
    def connect(self):
        super().connect()
        base = self.device(Base)
        move = base.functions["move"]
        base.functions["move"] = lambda adv, rot: move(-adv, rot)


class LeftHanded(Broken):
    def connect(self):
        super().connect()
        base = self.device(Base)
        move = base.functions["move"]
        base.functions["move"] = lambda adv, rot: move(adv, -rot)


class InCentimetres(Broken):
    def connect(self):
        super().connect()
        self.set_reading(DistanceSensors, {"front": [-1.0]})


class Liar(Broken):
    @classmethod
    def device_names(cls):
        return frozenset({"Base:ROBOT", "Camera:ROBOT"})


class Immortal(Broken):
    def stop(self):
        """Nothing stops it."""


class Careless(Client):
    def connect(self):
        self.add(Gyroscope(read=lambda: 90.0, reset=lambda: None), "Z_AXIS")


@pytest.mark.parametrize(
    ("robot", "claim"),
    [
        (Backwards, "positive speed is forward"),
        (LeftHanded, "positive rotation is to the right"),
        (InCentimetres, "its readings have the form and range of their device"),
        (Liar, "it has the devices it announces"),
        (Immortal, "its motors stop however the program ends"),
        (Careless, "its gyroscope reads 0 after a reset"),
    ],
)
def test_a_client_that_breaks_a_rule_is_told_which_rule(robot, claim):
    with pytest.raises(NotConformingError, match=f"broken   {claim}"):
        check_robot(robot)


def delayed(monkeypatch, seconds):
    """Return a class of robots whose sensor takes these times by turns."""
    clock = VirtualClock()
    monkeypatch.setattr(device_claims, "monotonic", clock.time)
    delays = cycle(seconds)

    class Delayed(Broken):
        def connect(self):
            super().connect()
            sensor = self.device(DistanceSensors)
            read = sensor.read
            sensor.read = lambda: clock.sleep(next(delays)) or read()

    return Delayed


def test_a_sensor_that_is_delayed_now_and_then_can_be_read_often_enough(monkeypatch):
    assert check_robot(delayed(monkeypatch, [2.0, 0.1, 0.1])).passed


def test_a_sensor_that_is_usually_slow_is_told(monkeypatch):
    sentence = "less than 5 readings a second: DistanceSensors:ROBOT"
    with pytest.raises(NotConformingError, match=sentence):
        check_robot(delayed(monkeypatch, [0.3, 0.3, 0.1]))


def test_without_a_link_that_can_fail_no_robot_is_connected_for_the_claims_about_it():
    made = []

    def make():
        made.append(FakeRobot())
        return made[-1]

    certificate = check_robot(make, claims=LINK_CLAIMS)
    assert {finding.outcome for finding in certificate.findings} == {"skipped"}
    assert [finding.claim for finding in certificate.findings] == list(LINK_CLAIMS)
    # One tells its name.
    assert len(made) == 1
