"""The camera that the user adds to every robot: the webcam, or a video instead."""

import pytest

from learnblock import running
from learnblock.client import Client
from learnblock.devices import Base, Camera
from learnblock.errors import RobotConnectionError, SettingsError
from learnblock.perception.sources import TABLE
from learnblock.robots import connect, find
from learnblock.storage.settings import file
from learnblock.testing import FakeRobot, VirtualClock
from runs import run_file
from shown_pictures import a_face, a_tag, blank
from videos import record


class Blind(Client):
    """A robot without a camera."""

    def connect(self):
        self.add(Base(lambda adv, rot: None))


class Sighted(Client):
    """A robot with a camera."""

    def connect(self):
        self.add(Camera(blank))


@pytest.fixture
def video(tmp_path):
    """One second without a tag, and one with a tag."""
    path = record(tmp_path / "tags.avi", [blank()] * 10 + [a_tag(8)] * 10)
    TABLE.change("video", str(path))
    return path


def test_without_a_setting_no_robot_gets_a_camera():
    with Blind() as robot:
        assert [key for key, device in robot.devices() if isinstance(device, Camera)] == []
    assert find("thymio").load().known_devices() == find("thymio").load().device_names()


def test_an_added_camera_is_the_default_camera_of_a_robot_without_one(video):
    with Blind(clock=VirtualClock()) as robot:
        assert not robot.is_any_tag()
        robot.sleep(1.05)
        assert robot.is_tag(8)
        assert robot.get_image().shape == (240, 320, 3)


def test_an_added_camera_does_not_replace_a_built_in_one(video):
    with Sighted(clock=VirtualClock()) as robot:
        robot.sleep(1.05)
        assert not robot.is_any_tag()
        (tag,) = robot.detect("tags", "webcam")
        assert tag.id == 8


def test_the_check_knows_the_added_camera(video):
    robot = find("sim-thymio").load()
    assert robot.known_devices() - robot.device_names() == {"Camera:ROBOT", "Camera:webcam"}
    ebo = find("sim-ebo").load()
    assert ebo.known_devices() - ebo.device_names() == {"Camera:webcam"}


def test_a_program_sees_the_video_on_a_simulated_robot_the_same_in_every_run(video, tmp_path):
    program = tmp_path / "wait.py"
    program.write_text(
        "from learnblock.robots.sim_thymio import Robot\n\nrobot = Robot()\n\n"
        "while not robot.is_tag(8):\n    robot.sleep(0.1)\n"
        "print(round(robot.time(), 3))\n"
    )
    runs = [run_file(program, "sim-thymio") for _ in range(2)]
    assert [run.report.ended for run in runs] == ["finished"] * 2
    assert runs[0].report.trace_sha256 == runs[1].report.trace_sha256
    assert 1.0 <= runs[0].report.time < 1.3


def test_emotions_in_a_video_are_not_recognised(tmp_path):
    TABLE.change("video", str(record(tmp_path / "face.avi", [a_face("joy")] * 3)))
    with Blind(clock=VirtualClock()) as robot:
        assert robot.is_there_face()
        assert not robot.is_any_face_happy()
    TABLE.change("emotions_on_cameras", "true")
    with Blind(clock=VirtualClock()) as robot:
        assert robot.is_any_face_happy()


def test_a_relative_video_path_is_in_the_users_folder(own_home):
    record(own_home / "tag.avi", [a_tag(8)] * 3)
    TABLE.change("video", "tag.avi")
    with Blind(clock=VirtualClock()) as robot:
        assert robot.is_tag(8)


def test_a_missing_camera_raises_only_when_a_program_uses_it(tmp_path):
    TABLE.change("video", str(tmp_path / "none.avi"))
    with Blind(clock=VirtualClock()) as robot:
        robot.stop_bot()
        with pytest.raises(RobotConnectionError, match="There is no video"):
            robot.is_any_tag()


def test_it_is_closed_with_its_robot(video):
    with Blind(clock=VirtualClock()) as robot:
        robot.is_any_tag()
        recording = robot.device(Camera).read.__self__
        assert recording._capture is not None
    assert recording._capture is None


def test_the_webcam_is_added_by_its_number():
    TABLE.change("webcam", "3")
    with Blind(clock=VirtualClock()) as robot:
        assert robot.device(Camera, "webcam").read.__self__._source == 3


def test_a_fake_robot_gets_no_added_camera(video):
    with FakeRobot() as robot:
        assert robot.device(Camera, "webcam") is None


def test_invalid_settings_are_reported_by_every_robot():
    file().write_text('[perception]\nwebcam = "front"\n')
    with pytest.raises(SettingsError, match=r"'perception\.webcam' is \"front\""):
        connect("sim-ebo")
    # The robot's devices are still available.
    assert find("sim-ebo").load().known_devices()


def test_using_the_webcam_is_not_a_mistake(video, tmp_path):
    program = tmp_path / "look.bt"
    program.write_text("main:\n    print(function.is_any_tag())\nend\n")
    source = running.read(program)
    assert running.check(source, find("sim-thymio")) == []
    TABLE.change("video", None)
    assert [one.code for one in running.check(source, find("sim-thymio"))] == ["missing-device"]
