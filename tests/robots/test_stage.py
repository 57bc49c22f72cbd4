"""A robot in its world as the page shows it."""

import threading

import cv2
import msgspec
import numpy as np
import pytest

from learnblock import robots
from learnblock.devices import Speaker
from learnblock.errors import DeviceValueError, LearnBlockError
from learnblock.perception import detect
from learnblock.robots.sim_cozmo import Robot as Cozmo
from learnblock.robots.sim_ebo import Robot as Ebo
from learnblock.robots.stage import Stage, make_stage
from learnblock.server import messages
from runs import TWINS, run_example


@pytest.fixture
def stage():
    """A function that puts a robot on a stage."""
    stages = []

    def stage(name="sim-ebo", world="tags", start=None):
        stages.append(make_stage(robots.find(name), world, start))
        return stages[-1]

    yield stage
    for one in stages:
        one.close()


def pose(stage):
    robot = stage.state().robots[0]
    return robot.x, robot.y, robot.heading


@pytest.mark.parametrize("name", TWINS)
def test_what_a_stage_shows_are_messages_of_the_page(stage, name):
    shown = stage(name, "line-and-box")
    scene = msgspec.convert(shown.scene(), messages.Scene, from_attributes=True)
    telemetry = msgspec.convert(shown.state(), messages.Telemetry, from_attributes=True)
    assert msgspec.json.decode(msgspec.json.encode(scene), type=messages.Scene).name == scene.name
    assert len(telemetry.pushed) == sum(
        thing["mass"] is not None for thing in scene.world["box"] + scene.world["cylinder"]
    )
    assert scene.robots[0][1]["title"]
    assert len(scene.lines) == len(scene.world["line"])


def test_a_scene_does_not_say_where_its_files_lie(stage):
    assert {"folder", "name"}.isdisjoint(stage().scene().world)


def test_sensors_are_told_by_name_as_the_robot_reads_them(stage):
    assert list(stage("sim-thymio", "line").state().sensors) == [
        "Distance front 1",
        "Distance front 2",
        "Distance front 3",
        "Distance left 1",
        "Distance left 2",
        "Distance right 1",
        "Distance right 2",
        "Distance back 1",
        "Distance back 2",
        "Ground left",
        "Ground right",
        "Accelerometer forward",
        "Accelerometer left",
        "Accelerometer up",
    ]


def test_a_robot_that_is_not_simulated_has_no_stage(own_home):
    (own_home / "robots").mkdir()
    (own_home / "robots" / "mine.py").write_text(
        "from learnblock.client import Client\nclass Robot(Client):\n    pass\n"
    )
    entry = robots.find("mine")
    assert make_stage(entry) is None
    with entry.load()() as robot:
        assert Stage.of(robot) is None


def test_a_robot_is_set_down_elsewhere_and_starts_there(stage):
    shown = stage()
    shown.place(100, -200, 90)
    assert pose(shown) == (100, -200, 90)
    assert shown.start == shown.scene().start == (100, -200, 90)


def test_a_robot_begins_where_it_is_wanted(stage):
    shown = stage(start=(50.0, 60.0, -90.0))
    assert pose(shown) == shown.start == (50, 60, -90)


def test_a_reset_puts_all_back_to_where_it_was_at_first(stage):
    shown = stage(world="line-and-box")
    before = shown.state()
    shown.place(300, 300, 45)
    shown.reset()
    assert shown.state() == before
    assert shown.start is None


def test_a_robot_driven_by_hand_goes_on_for_half_a_second_and_comes_to_rest(stage):
    shown = stage("sim-cozmo", "empty")
    shown.drive(0.5, 0)
    (hand,) = (thread for thread in threading.enumerate() if thread.name == "hand")
    hand.join(5)
    state = shown.state()
    fastest = Cozmo.description().wheels.maximum_speed
    assert not hand.is_alive()
    # Half of its fastest for half a second, and the way to gather speed and to stop.
    assert 0.8 < (state.robots[0].x - shown.scene().start[0]) / (0.25 * fastest) < 1.3
    assert 0.5 < state.time < 1.5


def test_a_turn_by_hand_is_clockwise_when_positive_and_stops_when_the_stage_is_closed(stage):
    shown = stage("sim-cozmo", "empty")
    heading = pose(shown)[2]
    shown.drive(0, 0.2)
    (hand,) = (thread for thread in threading.enumerate() if thread.name == "hand")
    while pose(shown)[2] - heading < 1:
        assert hand.is_alive()
    shown.close()
    assert not hand.is_alive()


def test_nobody_drives_or_resets_beside_a_program(stage):
    with Ebo(world="empty") as robot:
        shown = Stage.of(robot)
        with pytest.raises(LearnBlockError, match="stop it first to drive the robot"):
            shown.drive(1, 0)
        with pytest.raises(LearnBlockError, match="stop it first to put the world back"):
            shown.reset()
    shown.drive(0, 0)
    shown.reset()
    shown.close()


def test_the_camera_shows_what_the_robot_sees_and_what_is_found_in_it(stage):
    shown = stage()
    tag = shown.scene().world["tag"][0]
    shown.place(*_before(tag, 400))
    picture = shown.camera()
    frame = cv2.imdecode(np.frombuffer(picture.jpeg, np.uint8), cv2.IMREAD_COLOR)
    assert frame.shape == (picture.height, picture.width, 3) == (240, 320, 3)
    (found,) = (seen for seen in picture.seen if seen.sort == "tag")
    assert found.label == str(tag["id"])
    assert len(found.corners) == 4
    (again,) = detect("tags", cv2.cvtColor(frame, cv2.COLOR_BGR2RGB))
    assert again.center == pytest.approx(np.mean(found.corners, axis=0), abs=3)


def test_a_face_before_the_camera_is_told_with_what_it_expresses(stage):
    shown = stage("sim-cozmo", "faces")
    face = shown.scene().world["face"][0]
    shown.place(*_before(face, 450))
    labels = [seen.label for seen in shown.camera().seen if seen.sort == "face"]
    assert labels == [face["emotion"]]


def _before(board, distance):
    """Where a robot looks at a board's front from so many mm."""
    radians = np.radians(board["heading"])
    x, y = board["x"] + distance * np.cos(radians), board["y"] - distance * np.sin(radians)
    return float(x), float(y), (board["heading"] + 360) % 360 - 180


def test_a_line_before_the_camera_is_told_by_colour_and_side(stage):
    seen = stage("sim-cozmo", "line").camera().seen
    assert [one.label for one in seen if one.sort == "line"] == ["black center"]


def test_a_robot_without_a_camera_shows_no_picture(stage):
    assert stage("sim-thymio", "empty").camera() is None


def test_a_twin_knows_its_lens_and_so_how_far_a_tag_is():
    with Ebo(world="tags") as robot:
        shown = Stage.of(robot)
        tag = shown.scene().world["tag"][0]
        shown.place(*_before(tag, 400))
        # EBO's lens is 55 mm ahead of its middle.
        assert robot.get_tag_distance(tag["id"]) == pytest.approx(345, rel=0.02)


def test_who_looks_takes_no_frame():
    with Ebo(world="tags") as robot:
        shown = Stage.of(robot)
        frame = robot.body.frame()
        robot.simulation.advance(1)
        shown.camera()
        assert robot.body.frame() is frame
        robot.simulation.advance(3)
        looked = shown.camera()
        robot.body.drive(0, 90)
        robot.simulation.advance(4)
        shown.camera()
        robot.simulation.advance(7)
        assert robot.body.frame() is not frame
        assert looked is not shown.camera()


def test_a_world_that_stands_still_is_drawn_once(stage):
    shown = stage()
    assert shown.camera() is shown.camera()


def test_a_sound_is_told_once():
    with Cozmo(world="empty") as robot:
        shown = Stage.of(robot)
        robot.device(Speaker).say("hello")
        assert [entry[1:] for entry in shown.sounds()] == [("Speaker", "say", ("hello",))]
        assert list(shown.sounds()) == []


def test_a_run_begins_where_it_is_told_and_its_trace_says_so():
    there = run_example("square.bt", "sim-ebo", start=(100, 200, 90), seconds=1)
    default = run_example("square.bt", "sim-ebo", seconds=1)
    assert there.recorder.path[0][1] == (100, 200, 90)
    assert there.entries("run")[0]["run"]["start"] == [100.0, 200.0, 90.0]
    assert "start" not in default.entries("run")[0]["run"]


@pytest.mark.parametrize("start", [(1, 2), ("a", 0, 0), (0, 0, float("nan")), 7])
def test_a_start_that_is_no_place_is_refused(start):
    with pytest.raises(DeviceValueError, match="`start` must be"):
        Ebo.check_wishes({"world": "empty", "start": start})


def test_a_robot_lifted_during_a_run_is_told_in_the_trace():
    with Ebo(world="empty") as robot:
        told = []
        robot.simulation.witnesses["robot"] = type(
            "Witness",
            (),
            {"placed": lambda _, *what: told.append(what), "pose": lambda _, *what: None},
        )()
        Stage.of(robot).place(1, 2, 3)
        robot.simulation.advance(1)
    assert told == [(0.0, (1, 2, 3))]
