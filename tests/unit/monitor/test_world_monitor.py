"""The monitor of a simulated robot."""

import threading

import cv2
import msgspec
import numpy as np
import pytest

from learnblock import robots
from learnblock.devices import Base, Speaker
from learnblock.errors import DeviceValueError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.monitor import make_monitor, manual_drive
from learnblock.monitor.sensors import QUANTITIES, Quantity
from learnblock.monitor.world_monitor import WorldMonitor
from learnblock.perception import detect
from learnblock.robots.sim_cozmo import Robot as Cozmo
from learnblock.robots.sim_ebo import Robot as Ebo
from learnblock.server import messages
from learnblock.server.runs import telemetry
from runs import TWINS, run_example

pytestmark = pytest.mark.realtime


@pytest.fixture
def watch():
    """Return a function that creates the monitor of a robot."""
    monitors = []

    def watch(name="sim-ebo", world="tags", start=None):
        monitors.append(make_monitor(robots.find(name), world, start))
        return monitors[-1]

    yield watch
    for one in monitors:
        one.close()


@pytest.fixture
def drive(monkeypatch):
    """Return a function that drives a robot by hand, and returns the thread of its world."""

    def drive(monitor, advance, rotation):
        simulation = monitor._simulation
        # A busy machine keeps the world behind the wall clock.
        monkeypatch.setattr(manual_drive, "monotonic", lambda: simulation.world.time)
        # With the lock, the thread cannot end before it is found.
        with simulation.lock:
            monitor.drive(advance, rotation)
            (hand,) = (thread for thread in threading.enumerate() if thread.name == "hand")
        return hand

    return drive


def pose(monitor):
    return monitor.state().robots[0].pose


@pytest.mark.parametrize("name", TWINS)
def test_the_monitor_answers_messages_of_the_page(watch, name):
    monitor = watch(name, "line-and-box")
    scene, told = telemetry.scene(monitor), telemetry.telemetry(monitor)
    assert msgspec.json.decode(msgspec.json.encode(scene), type=messages.Scene).name == scene.name
    assert len(told.pushed) == sum(
        thing["mass"] is not None for thing in scene.world["box"] + scene.world["cylinder"]
    )
    assert scene.robots[0][1]["title"]
    assert len(scene.lines) == len(scene.world["line"])
    assert telemetry.link(monitor).state == "simulated"


def test_a_scene_does_not_reveal_the_folders_of_its_files(watch):
    assert {"folder", "name"}.isdisjoint(watch().scene().world)


def test_each_sensor_has_its_identity(watch):
    sensors = watch("sim-thymio", "line").state().sensors
    assert [(one.device, one.place, one.number) for one in sensors] == [
        ("DistanceSensors", "front", 1),
        ("DistanceSensors", "front", 2),
        ("DistanceSensors", "front", 3),
        ("DistanceSensors", "left", 1),
        ("DistanceSensors", "left", 2),
        ("DistanceSensors", "right", 1),
        ("DistanceSensors", "right", 2),
        ("DistanceSensors", "back", 1),
        ("DistanceSensors", "back", 2),
        ("GroundSensors", "left", 0),
        ("GroundSensors", "right", 0),
        ("Accelerometer", "forward", 0),
        ("Accelerometer", "left", 0),
        ("Accelerometer", "up", 0),
    ]


def test_each_sensor_has_its_unit_and_range(watch):
    sensors = watch("sim-ev3").state().sensors
    assert {one.device: (one.key, QUANTITIES[one.device]) for one in sensors} == {
        "DistanceSensors": ("ROBOT", Quantity("mm", 0, 2000, 0)),
        "GroundSensors": ("ROBOT", Quantity("%", 0, 100, 0)),
        "Gyroscope": ("Z_AXIS", Quantity("°", -360, 360, 1)),
        "Bumper": ("ROBOT", Quantity("", 0, 1, 1)),
    }


def test_the_speed_of_the_wheels_is_shown():
    with Ebo(world="empty") as robot:
        robot.device(Base).move(50, 20)
        robot.sleep(1)
        assert WorldMonitor.of(robot).state().robots[0].speed == pytest.approx((50, 20))


def test_a_robot_is_placed_elsewhere_and_starts_there(watch):
    monitor = watch()
    monitor.place(100, -200, 90)
    assert pose(monitor) == (100, -200, 90)
    assert monitor.start == monitor.scene().start == (100, -200, 90)


def test_a_robot_starts_at_the_given_pose(watch):
    monitor = watch(start=(50.0, 60.0, -90.0))
    assert pose(monitor) == monitor.start == (50, 60, -90)


def test_a_robot_driven_by_hand_stops_half_a_second_after_the_last_command(watch, drive):
    monitor = watch("sim-cozmo", "empty")
    hand = drive(monitor, 0.5, 0)
    hand.join(20)
    state = monitor.state()
    fastest = Cozmo.description().wheels.maximum_speed
    assert not hand.is_alive()
    # Half of its top speed for half a second, plus the distance to accelerate and to stop.
    assert 0.8 < (state.robots[0].pose[0] - monitor.scene().start[0]) / (0.25 * fastest) < 1.3
    assert 0.5 < state.time < 1.5


def test_a_turn_by_hand_is_clockwise_when_positive_and_ends_with_the_monitor(watch, drive):
    monitor = watch("sim-cozmo", "empty")
    heading = pose(monitor)[2]
    hand = drive(monitor, 0, 0.2)
    while pose(monitor)[2] - heading < 1:
        assert hand.is_alive()
    monitor.close()
    assert not hand.is_alive()


def test_driving_by_hand_is_refused_while_a_program_runs(watch):
    with Ebo(world="empty") as robot:
        monitor = WorldMonitor.of(robot)
        with pytest.raises(LearnBlockError) as error:
            monitor.drive(1, 0)
        assert error.value.phrase.code == "monitor-program-running"
    monitor.drive(0, 0)
    monitor.close()


def test_the_camera_picture_is_marked_with_the_tags_in_it(watch):
    monitor = watch()
    tag = monitor.scene().world["tag"][0]
    monitor.place(*_before(tag, 400))
    picture = monitor.camera()
    frame = cv2.imdecode(np.frombuffer(picture.jpeg, np.uint8), cv2.IMREAD_COLOR)
    assert frame.shape == (picture.height, picture.width, 3) == (240, 320, 3)
    (found,) = (seen for seen in picture.seen if seen.sort == "tag")
    assert found.label == str(tag["id"])
    assert len(found.corners) == 4
    (again,) = detect("tags", cv2.cvtColor(frame, cv2.COLOR_BGR2RGB))
    assert again.center == pytest.approx(np.mean(found.corners, axis=0), abs=3)


def test_a_face_in_the_picture_is_labelled_with_its_emotion(watch):
    monitor = watch("sim-cozmo", "faces")
    face = monitor.scene().world["face"][0]
    monitor.place(*_before(face, 450))
    labels = [seen.label for seen in monitor.camera().seen if seen.sort == "face"]
    assert labels == [face["emotion"]]


def _before(board, distance):
    """Return the pose from which a robot sees a board's front at this distance in mm."""
    radians = np.radians(board["heading"])
    x, y = board["x"] + distance * np.cos(radians), board["y"] - distance * np.sin(radians)
    return float(x), float(y), (board["heading"] + 360) % 360 - 180


def test_a_line_in_the_picture_is_labelled_with_colour_and_side(watch):
    seen = watch("sim-cozmo", "line").camera().seen
    assert [one.label for one in seen if one.sort == "line"] == ["black center"]


def test_what_the_program_itself_has_asked_for_in_the_picture_is_found():
    with Ebo(world="tags") as robot:
        monitor = WorldMonitor.of(robot)
        tag = monitor.scene().world["tag"][0]
        monitor.place(*_before(tag, 400))
        monitor.camera()
        assert monitor.found() is None
        assert robot.is_tag(tag["id"])
        assert [(one.sort, one.label) for one in monitor.found()] == [("tag", str(tag["id"]))]


def test_a_face_is_found_without_an_emotion_until_the_program_asks_for_one():
    with Ebo(world="faces") as robot:
        monitor = WorldMonitor.of(robot)
        face = monitor.scene().world["face"][0]
        monitor.place(*_before(face, 450))
        assert robot.is_there_face()
        assert [one.label for one in monitor.found()] == [""]
        robot.is_any_face_happy()
        assert [one.label for one in monitor.found()] == [face["emotion"]]


def test_a_robot_without_a_camera_has_no_picture(watch):
    assert watch("sim-thymio", "empty").camera() is None


def test_a_twin_measures_the_distance_to_a_tag_by_its_lens():
    with Ebo(world="tags") as robot:
        monitor = WorldMonitor.of(robot)
        tag = monitor.scene().world["tag"][0]
        monitor.place(*_before(tag, 400))
        # EBO's lens is 55 mm ahead of its middle.
        assert robot.get_tag_distance(tag["id"]) == pytest.approx(345, rel=0.02)


def test_watching_takes_no_frame_from_the_program():
    with Ebo(world="tags") as robot:
        monitor = WorldMonitor.of(robot)
        frame = robot.body.frame()
        robot.simulation.advance(1)
        monitor.camera()
        assert robot.body.frame() is frame
        robot.simulation.advance(3)
        looked = monitor.camera()
        robot.body.drive(0, 90)
        robot.simulation.advance(4)
        monitor.camera()
        robot.simulation.advance(7)
        assert robot.body.frame() is not frame
        assert looked is not monitor.camera()


def test_a_world_at_rest_is_drawn_once(watch):
    monitor = watch()
    assert monitor.camera() is monitor.camera()


def test_a_sound_is_reported_once():
    with Cozmo(world="empty") as robot:
        monitor = WorldMonitor.of(robot)
        robot.device(Speaker).say("hello")
        assert [entry[1:] for entry in monitor.sounds()] == [("Speaker", "say", ("hello",))]
        assert list(monitor.sounds()) == []


@pytest.mark.certain
def test_a_run_starts_at_the_given_pose_and_its_trace_records_it():
    there = run_example("square.bt", "sim-ebo", start=(100, 200, 90), seconds=1)
    default = run_example("square.bt", "sim-ebo", seconds=1)
    assert there.recorder.path[0][1] == (100, 200, 90)
    assert there.entries("run")[0]["run"]["start"] == [100.0, 200.0, 90.0]
    assert "start" not in default.entries("run")[0]["run"]


@pytest.mark.parametrize("start", [(1, 2), ("a", 0, 0), (0, 0, float("nan")), 7])
def test_an_invalid_start_is_refused(start):
    with pytest.raises(DeviceValueError) as refused:
        Ebo.check_wishes({"world": "empty", "start": start})
    assert refused.value.phrase == Phrase("world-bad-start", start=str(start))


@pytest.mark.certain
def test_placing_the_robot_during_a_run_is_recorded_in_the_trace():
    with Ebo(world="empty") as robot:
        told = []
        robot.simulation.witnesses["robot"] = type(
            "Witness",
            (),
            {"placed": lambda _, *what: told.append(what), "pose": lambda _, *what: None},
        )()
        WorldMonitor.of(robot).place(1, 2, 3)
        robot.simulation.advance(1)
    assert told == [(0.0, (1, 2, 3))]
