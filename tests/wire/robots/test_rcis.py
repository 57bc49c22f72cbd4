"""RCIS: on the real Ice, and on its emulator."""

import math
import threading
from contextlib import contextmanager

import cv2
import numpy as np
import pytest

from driven import assert_drives_like_its_twin, assert_told_when_gone
from emulated import LONG, quick, settle
from ice_runtime import components
from learnblock.devices import Base, Camera, Display, DistanceSensors, Emotion, JointMotor
from learnblock.emulators import emulate
from learnblock.emulators.rcis import Emulator
from learnblock.emulators.twin import Twin
from learnblock.errors import RobotConnectionError, SettingsError
from learnblock.ice.robocomp import Layout
from learnblock.robots.rcis import Robot
from learnblock.robots.rcis.camera import FrameConverter, shape_of
from learnblock.robots.rcis.face import draw_face, draw_text
from learnblock.testing import LINK_CLAIMS, Fault, Relay, check_robot
from runs import run_file
from twins import let_pass, pose, stands_after, x_of
from waiting import wait_for

STATE = {"isMoving": True, "x": 100.0, "z": -35.5, "alpha": math.pi / 2}
LASERS = [
    {"dist": [300.0, 250.5, 400.0], "driver": "Gazebo"},
    {"dist": [900.0]},
    {"dist": [3000.0, 8190.0]},
    {"dist": []},
    {"dist": [-1.0, 500.0]},
]
OBJECTS = (
    ("differentialrobot", {"state": STATE}),
    *(("laser", laser) for laser in LASERS),
    ("jointmotor", {"handler": "rcis", "stamp": "now"}),
    ("display", {}),
    ("rgbd", {}),
)


def settings_of(running):
    """The settings for reaching components that were started in the order of `OBJECTS`."""
    base, *lasers, joint, display, camera = running.ports
    return {
        "address": "127.0.0.1",
        "base_port": base,
        "laser_ports": lasers,
        "joint_port": joint,
        "display_port": display,
        "camera_port": camera,
    }


@pytest.fixture(scope="module", params=list(Layout))
def simulator(request, tmp_path_factory):
    """RCIS's components on the real Ice, and the settings for reaching them."""
    with components(tmp_path_factory.mktemp("rcis"), request.param, *OBJECTS) as running:
        yield request.param, running, settings_of(running)


@contextmanager
def robot_on(simulator):
    """The robot, which is stopped afterwards."""
    _, running, settings = simulator
    with Robot(**settings) as robot:
        yield robot, running
    assert running.told() == ["setSpeedBase", 0.0, 0.0]


def test_its_layout_is_detected(simulator):
    with robot_on(simulator) as (robot, _):
        assert robot.layout is simulator[0]


def test_it_drives_in_radians(simulator):
    with robot_on(simulator) as (robot, running):
        robot.device(Base).move(100, 90)
        assert running.told() == ["setSpeedBase", 100.0, pytest.approx(math.pi / 2)]


def test_its_pose_is_that_of_its_base(simulator):
    with robot_on(simulator) as (robot, _):
        assert robot.device(Base).functions["read"]() == pytest.approx((-35.5, -100, 90))


def test_its_servo_turns_the_other_way_round(simulator):
    with robot_on(simulator) as (robot, running):
        joint = robot.device(JointMotor, "CAMERA")
        joint.move(30)
        assert running.told() == ["setPosition", "servo", pytest.approx(-math.pi / 6), 0.0]
        assert joint.functions["read"]() == pytest.approx(30)


def test_the_smallest_value_of_each_laser_is_a_distance(simulator):
    with robot_on(simulator) as (robot, _):
        assert robot.read(DistanceSensors) == {
            "left": [250.5, 900],
            "front": [900, 2000, 2000],
            "right": [2000, 500],
        }


def test_its_pictures_have_the_right_rows_and_columns(simulator):
    with robot_on(simulator) as (robot, _):
        frame = robot.read(Camera)
        assert (frame.shape, frame.dtype) == ((240, 320, 3), np.uint8)
        # The real Ice sends row, column and 7 in each pixel.
        assert frame[239, 100].tolist() == [239, 100, 7]
        assert frame[5, 300].tolist() == [5, 300 % 256, 7]
        # The same picture is the same frame, so that it is not searched twice.
        assert robot.device(Camera).read() is robot.device(Camera).read()


@pytest.mark.parametrize("emotion", Emotion)
def test_its_screen_shows_our_face_for_each_emotion(simulator, emotion):
    with robot_on(simulator) as (robot, running):
        robot.device(Display).show_emotion(emotion)
        face = draw_face(emotion)
        assert running.told() == ["setImage", 480, 320, 3, face.nbytes, int(face.sum())]


def test_its_screen_shows_a_text_and_then_its_face_again(simulator):
    with robot_on(simulator) as (robot, running):
        robot.show_text("¡Hola!")
        text = draw_text("¡Hola!")
        assert running.told() == ["setImage", 480, 320, 3, text.nbytes, int(text.sum())]
        robot.clear_screen()
        face = draw_face("none")
        assert running.told() == ["setImage", 480, 320, 3, face.nbytes, int(face.sum())]


@pytest.mark.parametrize("text", ["a", "W" * 100, "word " * 20, "one\ntwo"])
def test_a_text_is_black_within_the_white_edge_of_the_screen(text):
    dark = draw_text(text).min(axis=2) < 128
    assert dark.any()
    assert not dark[[0, -1]].any()
    assert not dark[:, [0, -1]].any()


def test_every_emotion_has_its_own_symmetric_face():
    faces = {emotion: draw_face(emotion) for emotion in Emotion}
    pictures = {face.tobytes() for face in faces.values()}
    # None looks like neutral.
    assert len(pictures) == len(faces) - 1
    for face in faces.values():
        assert np.mean(cv2.absdiff(face, cv2.flip(face, 1))) < 2


@pytest.mark.parametrize(
    ("size", "shape"),
    [(230_400, (240, 320, 3)), (921_600, (480, 640, 3)), (36, (3, 4, 3))],
)
def test_the_size_of_a_picture_determines_its_shape(size, shape):
    assert shape_of(size) == shape


@pytest.mark.parametrize("size", [1, 35, 230_399, 320 * 200 * 3])
def test_bytes_that_are_not_a_picture_are_reported(size):
    with pytest.raises(RobotConnectionError, match=f"sent a picture of {size:,} bytes"):
        shape_of(size)


def test_without_bytes_there_is_no_picture_yet():
    assert FrameConverter().unpacked(b"") is None


@pytest.mark.parametrize("ports", [[1, 2, 3, 4], [1, 2, 3, 4, 0], 5])
def test_it_has_five_lasers(ports):
    with pytest.raises(SettingsError, match="laser_ports"):
        Robot(laser_ports=ports)


# The whole robot, through its wires.


@pytest.fixture
def emulation():
    with emulate("rcis", "empty") as emulation:
        emulation.settings = {**emulation.settings, "patience": LONG}
        yield emulation


def test_it_conforms(monkeypatch):
    with quick("rcis", monkeypatch) as emulation:
        certificate = check_robot(lambda: Robot(**emulation.settings))
    outcomes = {finding.claim: finding.outcome for finding in certificate.findings}
    assert [claim for claim, outcome in outcomes.items() if outcome != "holds"] == [
        "its accelerometer shows 1 g upwards at rest",
        "its gyroscope reads 0 after a reset",
        *LINK_CLAIMS,
    ]


def test_a_link_that_fails_is_reported_as_of_every_robot(emulation):
    with Relay(("127.0.0.1", emulation.settings["base_port"])) as relay:
        settings = {**emulation.settings, "base_port": relay.port, "patience": 1.0}
        assert check_robot(lambda: Robot(**settings), relay=relay, claims=LINK_CLAIMS).passed


@pytest.mark.parametrize(
    ("setting", "title", "use"),
    [
        ("laser_ports", "distance sensors", lambda robot: robot.device(DistanceSensors).read()),
        ("joint_port", "camera tilt", lambda robot: robot.device(JointMotor, "CAMERA").move(10)),
        ("display_port", "screen", lambda robot: robot.device(Display).show_emotion("joy")),
        ("camera_port", "camera", lambda robot: robot.device(Camera).read()),
    ],
)
@pytest.mark.parametrize("fault", [Fault.CUT, Fault.SILENT])
def test_each_missing_component_is_reported_by_name(emulation, setting, title, use, fault):
    sentence = f"Can't reach the {title} in RCIS at"
    assert_told_when_gone(
        Robot, emulation.settings, setting, sentence=sentence, fault=fault, use=use
    )


def test_a_wrong_port_is_reported(emulation):
    wrong = {**emulation.settings, "base_port": emulation.settings["display_port"]}
    with pytest.raises(
        RobotConnectionError,
        match=r"RCIS at .* can't do that \('differentialrobot' has no",
    ):
        Robot(**wrong)


def test_a_robot_at_the_address_of_the_settings_is_found(emulation):
    settle("rcis", emulation.settings)
    assert {"address": "127.0.0.1"} in list(Robot.scan(LONG))


def test_the_emulator_shows_the_emotion_of_the_face_it_is_sent(emulation):
    with Robot(**emulation.settings) as robot:
        for emotion in ("joy", "fear", "neutral"):
            robot.device(Display).show_emotion(emotion)
            with emulation.twin.body() as body:
                assert body.emotion == emotion


def test_its_pose_is_that_of_its_twin(emulation):
    with Robot(**emulation.settings) as robot:
        robot.device(Base).move(60, 40)
        robot.clock.sleep(1)
        robot.device(Base).stop()
        stands_after(emulation.twin)
        assert robot.device(Base).functions["read"]() == pytest.approx(pose(emulation.twin))


PROGRAM = """\
main:
    function.set_move(60, 0)
    function.sleep(30)
end
"""


def test_a_cut_link_ends_a_run_with_an_error_and_the_robot_stops_once_it_is_restored(
    emulation, tmp_path
):
    program = tmp_path / "drive.bt"
    program.write_text(PROGRAM)
    with Relay(("127.0.0.1", emulation.settings["base_port"])) as relay:
        settle("rcis", {**emulation.settings, "base_port": relay.port, "patience": 1.0})

        cutting = threading.Thread(target=cut_once_it_drives, args=(emulation.twin, relay))
        cutting.start()
        report = run_file(program, "rcis").report
        cutting.join()
        assert report.ended == "error"
        sentence = str(report.error["message"])
        assert "Can't reach the wheels in RCIS at 127.0.0.1" in sentence
        # No one could stop it: the guardian does so as soon as it can.
        assert is_driving(emulation.twin)
        relay.fault = Fault.NONE
        wait_for(lambda: not is_driving(emulation.twin), "it stands")


def cut_once_it_drives(twin, relay):
    start = x_of(twin)
    wait_for(lambda: x_of(twin) >= start + 10, "it drives")
    relay.fault = Fault.CUT


def is_driving(twin):
    before = pose(twin)
    let_pass(twin, 0.3)
    return math.dist(before[:2], pose(twin)[:2]) > 1


def test_it_follows_the_line_like_its_twin(monkeypatch):
    with Twin("sim-ebo", "line", speed=2) as twin:
        assert_drives_like_its_twin(
            "rcis", Emulator, twin, "line-ebo.bt", monkeypatch,
            until=lambda twin: pose(twin)[0] < -300,
            tolerance=20,
        )  # fmt: skip
