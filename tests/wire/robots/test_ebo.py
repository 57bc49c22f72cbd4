"""EBO: on the real Ice and the real mosquitto, and on its emulator."""

import math
import threading

import cv2
import numpy as np
import paho.mqtt.client as mqtt
import pytest

from driven import assert_drives_like_its_twin, assert_told_when_gone
from emulated import LONG, quick, settle
from ice_runtime import components
from learnblock.devices import Base, Camera, Display, DistanceSensors, Emotion, JointMotor
from learnblock.emulators import emulate
from learnblock.emulators.ebo import Emulator
from learnblock.emulators.ebo_camera import Broker, find_broker
from learnblock.emulators.twin import Twin
from learnblock.errors import RobotConnectionError, SettingsError
from learnblock.i18n import Phrase
from learnblock.ice.robocomp import Layout
from learnblock.robots.ebo import Robot, Settings
from learnblock.robots.ebo.camera import TOPIC, StreamedCamera
from learnblock.robots.settings import change
from learnblock.testing import CLAIMS, LINK_CLAIMS, Fault, Relay, check_robot
from twins import emotion, pose, x_of
from waiting import wait_for

OBJECTS = {
    "differentialrobot": {},
    "laser": {"dist": [100.0, 200.0, 300.0, 8190.0, -1.0], "silent": True},
    "jointmotor": {"silent": True},
    "emotionalmotor": {},
}
PORTS = ("base_port", "laser_port", "joint_port", "face_port")
NO_ODOMETRY = "EBO's components know neither its pose nor the angle of its head"


@pytest.fixture(scope="module")
def broker():
    program = find_broker()
    if program is None:
        pytest.skip("needs a broker of MQTT: apt-get install mosquitto")
    with Broker(program) as broker:
        yield broker


class Publisher:
    """EBO's camera: sends a picture repeatedly."""

    def __init__(self, port):
        self.picture = encoded(halves())
        self._client = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2)
        self._client.connect("127.0.0.1", port)
        self._client.loop_start()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._send, daemon=True)
        self._thread.start()

    def close(self):
        self._ended.set()
        self._thread.join()
        self._client.disconnect()
        self._client.loop_stop()

    def _send(self):
        while not self._ended.wait(0.05):
            self._client.publish(TOPIC, self.picture)


def halves():
    """Red on the left, blue on the right."""
    frame = np.zeros((240, 320, 3), np.uint8)
    frame[:, :160, 0] = frame[:, 160:, 2] = 255
    return frame


def encoded(frame):
    return cv2.imencode(".jpg", cv2.cvtColor(frame, cv2.COLOR_RGB2BGR))[1].tobytes()


@pytest.fixture
def publisher(broker):
    publisher = Publisher(broker.port)
    yield publisher
    publisher.close()


@pytest.fixture(scope="module", params=list(Layout))
def brain(request, tmp_path_factory):
    """EBO's components on the real Ice, and the settings for reaching them."""
    layout = request.param
    with components(tmp_path_factory.mktemp("ebo"), layout, *OBJECTS.items()) as running:
        ports = dict(zip(PORTS, running.ports, strict=True))
        # Without a camera, unless the test asks for one.
        yield layout, running, {"address": "127.0.0.1", "camera_port": 0, **ports}


def test_it_drives_in_radians(brain):
    _, running, settings = brain
    with Robot(**settings) as robot:
        robot.device(Base).move(100, 90)
        assert running.told() == ["setSpeedBase", 100.0, pytest.approx(math.pi / 2)]
        robot.device(Base).move(-20.5, -45)
        assert running.told() == ["setSpeedBase", -20.5, pytest.approx(-math.pi / 4)]
    assert running.told() == ["setSpeedBase", 0.0, 0.0]


def test_its_servo_looks_up_at_positive_angles(brain):
    _, running, settings = brain
    with Robot(**settings) as robot:
        robot.device(JointMotor, "CAMERA").move(30)
        assert running.told() == ["setPosition", "servo", pytest.approx(math.pi / 6), 0.0]
    running.told()


def test_it_reads_five_distances_from_left_to_right(brain):
    _, running, settings = brain
    with Robot(**settings) as robot:
        assert robot.read(DistanceSensors) == {
            "left": [100, 200],
            "front": [200, 300, 2000],
            "right": [2000, 2000],
        }
    running.told()


@pytest.mark.parametrize("emotion", Emotion)
def test_its_face_shows_every_emotion_that_it_has(brain, emotion):
    layout, running, settings = brain
    with Robot(**settings, **known_layout(layout)) as robot:
        robot.device(Display).show_emotion(emotion)
        shown = "neutral" if emotion is Emotion.NONE else emotion
        if shown != "neutral" or layout is not Layout.SINCE_2020:
            assert running.told() == [f"express{shown.capitalize()}"]
    assert running.told() == ["setSpeedBase", 0.0, 0.0]


def known_layout(layout):
    """The layout that EBO's silent components do not reveal."""
    return {"layout": layout} if layout is Layout.SINCE_2020 else {}


def test_its_layout_is_detected_unless_it_is_set(brain):
    layout, running, settings = brain
    with Robot(**settings) as robot:
        assert robot.layout is (Layout.ROBOT if layout is Layout.ROBOT else Layout.TOOL)
    with Robot(**settings, layout="2020") as robot:
        assert robot.layout is Layout.SINCE_2020
    assert [running.told(), running.told()] == [["setSpeedBase", 0.0, 0.0]] * 2


def test_a_wrong_layout_is_reported_by_the_first_goal(brain):
    layout, running, settings = brain
    wrong = "tool" if layout is Layout.ROBOT else "robot"
    with (
        Robot(**settings, layout=wrong) as robot,
        pytest.raises(RobotConnectionError, match=r"EBO at .* uses a different message layout"),
    ):
        robot.device(JointMotor, "CAMERA").move(30)
    assert running.told() == ["setSpeedBase", 0.0, 0.0]


def test_an_unknown_layout_is_rejected():
    with pytest.raises(SettingsError, match=r"(?s)layout.*2019"):
        Robot(layout="2019")


def test_a_base_with_failing_hardware_is_reported(tmp_path):
    broken = {**OBJECTS, "differentialrobot": {"broken": True}}
    with components(tmp_path, "robot", *broken.items()) as running:
        ports = dict(zip(PORTS, running.ports, strict=True))
        robot = Robot(address="127.0.0.1", camera_port=0, **ports)
        sentence = r"EBO at .* can't do that \(the battery is empty\)"
        with pytest.raises(RobotConnectionError, match=sentence):
            robot.device(Base).move(10, 0)
        with pytest.raises(RobotConnectionError, match=sentence):
            robot.stop()
        assert robot.stopped


# Its camera.


def test_a_picture_arrives_in_red_green_and_blue(broker, publisher):
    camera = StreamedCamera("127.0.0.1", broker.port, timeout=LONG)
    camera.open()
    frame = camera.read()
    assert (frame.shape, frame.dtype) == ((240, 320, 3), np.uint8)
    assert frame[:, :150].mean(axis=(0, 1)) == pytest.approx([255, 0, 0], abs=4)
    assert frame[:, 170:].mean(axis=(0, 1)) == pytest.approx([0, 0, 255], abs=4)
    camera.close()
    camera.close()


@pytest.mark.parametrize("nonsense", [b"", b"\xff\xd8 no picture"])
def test_a_damaged_picture_is_skipped(broker, publisher, nonsense):
    camera = StreamedCamera("127.0.0.1", broker.port, timeout=LONG)
    camera.open()
    frame = camera.read()
    publisher.picture = nonsense
    wait_for(lambda: camera._latest == nonsense, "the damaged picture")
    assert camera.read() is frame
    camera.close()


def test_a_camera_without_a_broker_is_reported(broker):
    camera = StreamedCamera("127.0.0.1", 1, timeout=1)
    with pytest.raises(RobotConnectionError) as caught:
        camera.open()
    assert caught.value.phrase == Phrase("ebo-camera-unreachable", place="127.0.0.1:1")
    camera.close()


def test_a_camera_that_sends_nothing_is_reported(broker):
    camera = StreamedCamera("127.0.0.1", broker.port, timeout=0.3)
    with pytest.raises(RobotConnectionError, match=r"has sent no picture for 0\.3 seconds"):
        camera.open()
    camera.close()


@pytest.mark.parametrize("fault", [Fault.CUT, Fault.SILENT, Fault.GARBAGE])
def test_a_stream_that_ends_is_reported(broker, publisher, fault):
    with Relay(("127.0.0.1", broker.port)) as relay:
        camera = StreamedCamera("127.0.0.1", relay.port, timeout=0.5)
        camera.open()
        relay.fault = fault
        with pytest.raises(RobotConnectionError, match=r"has sent no picture for 0\.5 seconds"):
            wait_for(camera.check, "an error")
        camera.close()


# The whole robot, through its wires.


@pytest.fixture
def emulation():
    if find_broker() is None:
        pytest.skip("needs a broker of MQTT: apt-get install mosquitto")
    with emulate("ebo", "empty") as emulation:
        emulation.settings = {**emulation.settings, "patience": LONG}
        yield emulation


def test_it_conforms(monkeypatch):
    with quick("ebo", monkeypatch) as emulation:
        certificate = check_robot(lambda: Robot(**emulation.settings))
    outcomes = {finding.claim: finding.outcome for finding in certificate.findings}
    assert list(outcomes) == list(CLAIMS)
    skipped = {claim for claim, outcome in outcomes.items() if outcome == "skipped"}
    assert skipped == {
        "its accelerometer shows 1 g upwards at rest",
        "positive speed is forward",
        "positive rotation is to the right",
        "its gyroscope reads 0 after a reset",
        *LINK_CLAIMS,
    }, NO_ODOMETRY


def test_a_link_that_fails_is_reported_as_of_every_robot(emulation):
    with Relay(("127.0.0.1", emulation.settings["base_port"])) as relay:
        settings = {**emulation.settings, "base_port": relay.port, "patience": 1.0}
        assert check_robot(lambda: Robot(**settings), relay=relay, claims=LINK_CLAIMS).passed


def test_positive_speeds_are_forward_and_to_the_right(emulation):
    twin = emulation.twin
    with Robot(**emulation.settings) as robot:
        start = pose(twin)
        robot.device(Base).move(50, 30)
        wait_for(lambda: pose(twin)[2] > start[2] + 20, "it turns")
        robot.check_link()
    x, y, _ = pose(twin)
    assert x > start[0] + 10
    assert y < start[1]


@pytest.mark.parametrize(
    ("setting", "title"),
    [("base_port", "base"), ("laser_port", "laser"), ("joint_port", "joint"),
     ("face_port", "face")],
)  # fmt: skip
@pytest.mark.parametrize("fault", [Fault.CUT, Fault.SILENT])
def test_each_missing_component_is_reported_by_name(emulation, setting, title, fault):
    use = {
        "base": lambda robot: robot.check_link(),
        "laser": lambda robot: robot.device(DistanceSensors).read(),
        "joint": lambda robot: robot.device(JointMotor, "CAMERA").move(10),
        "face": lambda robot: robot.device(Display).show_emotion("joy"),
    }[title]
    part = {"base": "wheels", "laser": "distance sensors", "joint": "camera tilt"}.get(title, title)
    sentence = f"Can't reach EBO's {part} at"
    assert_told_when_gone(
        Robot, emulation.settings, setting, sentence=sentence, fault=fault, use=use
    )


def test_without_a_camera_none_is_announced(own_home, emulation):
    assert "Camera:ROBOT" in Robot.device_names()
    change("ebo", Settings, "camera_port", "0")
    assert "Camera:ROBOT" not in Robot.device_names()
    with Robot(**{**emulation.settings, "camera_port": 0}) as robot:
        found = {f"{type(device).__name__}:{key}" for key, device in robot.devices()}
    assert found == Robot.device_names()


def test_a_robot_without_a_camera_has_no_camera_device(emulation):
    with Robot(**{**emulation.settings, "camera_port": 0}) as robot:
        assert robot.device(Camera) is None


def test_two_programs_can_drive_it_and_the_last_command_applies(emulation):
    with Robot(**emulation.settings) as one, Robot(**emulation.settings) as another:
        one.device(Base).move(50, 0)
        another.device(Base).move(-50, 0)
        start = x_of(emulation.twin)
        wait_for(lambda: x_of(emulation.twin) < start - 20, "it drives backwards")
        one.check_link()
        another.check_link()


def test_a_robot_at_the_address_of_the_settings_is_found(emulation):
    settle("ebo", emulation.settings)
    assert list(Robot.scan(LONG)) == [{"address": "127.0.0.1"}]


def test_a_scan_without_robots_finds_nothing(own_home):
    settle("ebo", {"address": "127.0.0.1", "base_port": 1})
    assert list(Robot.scan(0.4)) == []


# The paper's programs, unchanged. The worlds may run faster than real time, but the wire has no
# time of its own; so the program is slower to react, and the tolerances allow for it.


def test_it_follows_the_line_into_its_curve_like_its_twin(monkeypatch):
    # Not faster: in a curve, a picture that a busy machine brings late costs most.
    with Twin("sim-ebo", "line") as twin:
        assert_drives_like_its_twin(
            "ebo", Emulator, twin, "line-ebo.bt", monkeypatch,
            until=lambda twin: pose(twin)[1] > -400,
            tolerance=20,
        )  # fmt: skip


def test_it_visits_a_tag_and_looks_happy_like_its_twin(monkeypatch):
    with Twin("sim-ebo", "tags", speed=2) as twin:
        emotions = assert_drives_like_its_twin(
            "ebo", Emulator, twin, "tags.bt", monkeypatch,
            until=lambda twin: emotion(twin) == "joy",
            tolerance=80,
        )  # fmt: skip
        assert emotions == ("neutral", "joy")
        assert twin.goals()["tag 1"]


@pytest.mark.parametrize("speed", [200, 1000, -1000])
def test_its_pose_is_reckoned_with_what_its_wheels_can_do(speed):
    with Twin("sim-ebo", "empty") as twin:
        emulator = Emulator(twin)
        start = pose(twin)
        with Robot(**emulator.settings, patience=LONG) as robot:
            robot.move_straight(speed)
            robot.sleep(1)
            robot.stop_bot()
            robot.sleep(1)
            reckoned = robot.get_pose()
        driven = pose(twin)[0] - start[0]
        emulator.close()

    # A command takes a moment on its way, on a busy machine a quarter of a second at the 300 mm/s
    # of its wheels; reckoned by what was commanded, it would be 700 mm off.
    assert reckoned[0] == pytest.approx(driven, abs=75)
