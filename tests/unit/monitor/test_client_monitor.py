"""The monitor of a real robot, which shows what its client polls."""

import numpy as np
import pytest

from learnblock.client import Client, RobotStatus
from learnblock.client.readings import WATCHED
from learnblock.devices import (
    Base,
    Camera,
    Display,
    DistanceSensors,
    Gyroscope,
    JointMotor,
    Led,
    RGBLed,
)
from learnblock.errors import LearnBlockError, RobotConnectionError
from learnblock.monitor import LinkState, make_monitor, monitor_of
from learnblock.monitor.client_monitor import WEAK_SILENCE, ClientMonitor
from learnblock.robots import find


class ManualClock:
    """A running clock whose speed the test sets."""

    instant = None

    def __init__(self):
        self.now = 0.0

    def time(self):
        return self.now

    def sleep(self, seconds):
        self.now += seconds

    def charge(self):
        pass


class Robot(Client):
    """A robot whose readings are polled when a test asks for it."""

    sensing_period = 3600
    has_extra_camera = False

    def __init__(self, *, odometry=None):
        self.reads = {"distance": 0, "gyroscope": 0}
        self.done = []
        self.odometry = odometry
        self.failure = self.cable = None
        self.reported = RobotStatus()
        self.frame = None
        super().__init__(clock=ManualClock())

    def connect(self):
        self.add(Base(lambda *speed: self.done.append(speed), read=self.odometry))
        self.add(DistanceSensors(self._distances))
        self.add(Gyroscope(read=self._turned, reset=lambda: None), "Z_AXIS")
        self.add(Display(show_emotion=self.done.append))
        self.add(Led(set=self.done.append), "TOP")
        self.add(RGBLed(set_color=lambda *colour: self.done.append(colour)), "Left")
        self.add(JointMotor(move=self.done.append, read=self._angle), "ARM")
        self.add(JointMotor(move=self.done.append), "CAMERA")
        self.add(Camera(read=self._see))

    def check_link(self):
        if self.failure:
            raise self.failure

    def status(self):
        return self.reported

    def _distances(self):
        self.reads["distance"] += 1
        if self.failure:
            raise self.failure
        return {"front": [100.0, 2000.0]}

    def _turned(self):
        self.reads["gyroscope"] += 1
        if self.failure or self.cable:
            raise self.failure or self.cable
        return 90.0

    def _angle(self):
        if self.failure:
            raise self.failure
        return 12.5

    def _see(self):
        if self.failure:
            raise self.failure
        return self.frame


@pytest.fixture
def robot():
    with Robot() as robot:
        yield robot


def look(robot, monitor):
    """Return the state after every watched sensor was polled once."""
    monitor.state()
    robot.readings.poll(WATCHED)
    return monitor.state()


def values(state):
    return {(one.device, one.key, one.place, one.number): one.value for one in state.sensors}


def test_sensors_that_the_program_does_not_use_are_shown(robot):
    assert values(look(robot, monitor_of(robot))) == {
        ("DistanceSensors", "ROBOT", "front", 1): 100.0,
        ("DistanceSensors", "ROBOT", "front", 2): 2000.0,
        ("Gyroscope", "Z_AXIS", "", 0): 90.0,
    }


def test_a_sensor_that_the_program_uses_is_not_read_for_the_page(robot):
    monitor = monitor_of(robot)
    robot.read(DistanceSensors)
    look(robot, monitor)
    assert robot.reads == {"distance": 1, "gyroscope": 1}
    assert values(monitor.state())["DistanceSensors", "ROBOT", "front", 1] == 100


def test_observing_reads_no_sensor(robot):
    monitor = monitor_of(robot)
    look(robot, monitor)
    before = dict(robot.reads)
    for _ in range(5):
        monitor.state()
        monitor.link()
    assert robot.reads == before


def test_sensors_remain_listed_while_they_have_no_value(robot):
    monitor = monitor_of(robot)
    look(robot, monitor)
    robot.forget_readings()
    assert set(values(monitor.state()).values()) == {None}
    assert len(values(monitor.state())) == 3


def test_commands_are_shown_and_reach_the_robot(robot):
    monitor = monitor_of(robot)
    robot.device(Base).move(40, -10)
    robot.device(Display).show_emotion("joy")
    robot.device(Led, "TOP").set(on=True)
    robot.device(RGBLed, "Left").set_color(1, 2, 3)
    robot.device(JointMotor, "CAMERA").move(20)
    shown = look(robot, monitor).robots[0]
    assert (shown.speed, shown.emotion) == ((40, -10), "joy")
    assert shown.leds == {"TOP": (255, 255, 255), "Left": (1, 2, 3)}
    # The arm reports its angle; the camera's angle is the commanded one.
    assert shown.joints == {"ARM": 12.5, "CAMERA": 20}
    assert robot.done == [(40, -10), "joy", True, (1, 2, 3), 20]


def test_the_pose_is_that_of_the_odometry_or_else_of_the_commands(robot):
    robot.device(Base).move(50, 0)
    robot.clock.sleep(2)
    assert look(robot, monitor_of(robot)).robots[0].pose == (100, 0, 0)
    with Robot(odometry=lambda: (10.0, 20.0, 30.0)) as other:
        assert look(other, monitor_of(other)).robots[0].pose == (10, 20, 30)


def test_the_last_state_remains_after_the_program(robot):
    monitor = monitor_of(robot)
    robot.clock.sleep(5)
    before = look(robot, monitor)
    robot.stop()
    robot.clock.sleep(5)
    assert monitor.state() == before
    assert before.time == 5


# The link.


def test_without_a_program_a_robot_is_not_connected(robot):
    assert ClientMonitor(Robot).link().state is LinkState.DISCONNECTED
    monitor = monitor_of(robot)
    assert monitor.link().state is LinkState.CONNECTED
    robot.stop()
    assert monitor.link().state is LinkState.DISCONNECTED


@pytest.mark.parametrize(
    ("reported", "state"),
    [
        (RobotStatus(battery=4.0, link_quality=0.9, silence=0.1), LinkState.CONNECTED),
        (RobotStatus(battery=4.0, link_quality=0.4, silence=0.1), LinkState.WEAK),
        (RobotStatus(battery=4.0, link_quality=0.9, silence=1.0), LinkState.WEAK),
    ],
)
def test_a_link_is_weak_when_messages_are_missing_or_late(robot, reported, state):
    robot.reported = reported
    link = monitor_of(robot).link()
    assert (link.state, link.battery, link.quality) == (state, 4.0, reported.link_quality)


def test_a_link_is_weak_if_no_reading_succeeds_for_a_while(robot):
    monitor = monitor_of(robot)
    look(robot, monitor)
    robot.clock.sleep(WEAK_SILENCE + 0.1)
    assert monitor.link().state is LinkState.WEAK
    robot.readings.poll(WATCHED)
    assert monitor.link().state is LinkState.CONNECTED


def test_a_link_that_the_driver_gives_up_is_lost(robot):
    monitor = monitor_of(robot)
    robot.failure = RobotConnectionError("gone")
    with pytest.raises(RobotConnectionError):
        robot.require_link()
    assert monitor.link().state is LinkState.LOST
    robot.stop()
    assert monitor.link().state is LinkState.LOST


def test_a_link_is_lost_when_a_run_ends_and_no_sensor_can_be_read(robot):
    monitor = monitor_of(robot)
    monitor.state()
    robot.failure = RobotConnectionError("gone")
    robot.readings.poll(WATCHED)
    robot.stop()
    assert monitor.link().state is LinkState.LOST


def test_an_unplugged_sensor_is_not_a_lost_link(robot):
    monitor = monitor_of(robot)
    robot.cable = RobotConnectionError("the cable is out")
    look(robot, monitor)
    robot.stop()
    assert monitor.link().state is LinkState.DISCONNECTED


# The camera.


def test_a_frame_is_developed_once(robot):
    monitor = monitor_of(robot)
    assert monitor.camera() is None
    robot.frame = np.zeros((240, 320, 3), np.uint8)
    picture = monitor.camera()
    assert (picture.width, picture.height) == (320, 240)
    assert picture.jpeg.startswith(b"\xff\xd8")
    assert monitor.camera() is picture
    robot.frame = robot.frame.copy()
    assert monitor.camera() is not picture


def test_a_failed_camera_keeps_its_last_picture(robot):
    monitor = monitor_of(robot)
    robot.frame = np.zeros((240, 320, 3), np.uint8)
    picture = monitor.camera()
    robot.failure = RobotConnectionError("gone")
    assert monitor.camera() is picture


# The stage.


@pytest.mark.parametrize(
    ("name", "look"),
    [("cozmo", "cozmo"), ("ebo", "ebo"), ("ev3", "ev3"), ("thymio", "thymio"), ("rcis", "ebo")],
)
def test_a_real_robot_is_drawn_as_itself_on_a_plain_floor(name, look):
    scene = make_monitor(find(name)).scene()
    assert (scene.real, scene.start, scene.lines) == (True, None, ())
    assert scene.robots[0][1]["name"] == look
    assert not any(scene.world[kind] for kind in ("box", "cylinder", "tag", "wall", "start"))


def test_a_robot_without_a_model_is_drawn_with_its_devices():
    class Lit(Robot):
        @classmethod
        def device_names(cls):
            return frozenset({"Base:ROBOT", "RGBLed:Left", "Display:ROBOT", "Camera:ROBOT"})

    scene = ClientMonitor(Lit).scene()
    look = scene.robots[0][1]
    assert [led["slot"] for led in look["led"]] == ["Left"]
    assert look["display"]
    assert scene.cameras == ("ROBOT",)


def test_a_real_robot_is_neither_placed_nor_driven_from_the_page(robot):
    monitor = monitor_of(robot)
    with pytest.raises(LearnBlockError) as refused:
        monitor.place(0, 0, 0)
    assert refused.value.phrase.code == "monitor-place-real"
    with pytest.raises(LearnBlockError) as refused:
        monitor.handle("shake")
    assert refused.value.phrase.code == "monitor-handle-real"
    with pytest.raises(LearnBlockError) as refused:
        monitor.drive(1, 0)
    assert refused.value.phrase.code == "monitor-drive-real"
