"""CoppeliaSim through the vendor's client: three scenes, the paper's programs, and broken wires."""

import math
import re
import signal
import socket
import subprocess
import sys
import threading
from contextlib import closing, contextmanager

import pytest

import twins
from driven import run_until
from emulated import LONG, settle
from learnblock.devices import Base, Camera, Display, DistanceSensors, GroundSensors, Gyroscope
from learnblock.emulators.coppeliasim import Emulator
from learnblock.emulators.twin import Twin
from learnblock.errors import LearnBlockError, RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.installation import add_on
from learnblock.robots import settings as user_settings
from learnblock.robots.coppeliasim import Robot, Settings
from learnblock.robots.coppeliasim.named_parts import Axle
from learnblock.robots.coppeliasim.readings import Turning
from learnblock.storage.home import home
from learnblock.testing import LINK_CLAIMS, Fault, Relay, check_robot
from places import ROOT
from ports import mute_server
from processes import wait_until_gone
from runs import run_example, run_file
from twins import furthest, let_pass, stands_after
from waiting import wait_for

#: Seconds for a robot that does not answer, short so that it does not delay the tests.
TIMEOUT = 1.0


class Place:
    """CoppeliaSim with a twin in it, and the settings for reaching it."""

    def __init__(self, twin, emulator):
        self.scene = emulator.scene
        self.twin = twin
        self.port = emulator.settings["port"]

    def settings(self, scene="script", **others):
        named = dict(self.scene.parts) if scene == "names" else {"scene": scene}
        return {"port": self.port, "patience": LONG, **named, **others}

    def robot(self, scene="script", **others):
        return Robot(**self.settings(scene, **others))

    def save_settings(self, scene):
        settle("coppeliasim", self.settings(scene))

    @property
    def pose(self):
        return twins.pose(self.twin)

    def speed(self):
        return twins.speed(self.twin)


@contextmanager
def coppeliasim(robot="sim-ev3", world="empty", start=None):
    with Twin(robot, world, start=start) as twin, closing(Emulator(twin)) as emulator:
        yield Place(twin, emulator)


@pytest.fixture
def place():
    with coppeliasim() as there:
        yield there


# What every robot promises.


def test_our_scene_script_conforms(place):
    certificate = check_robot(place.robot)
    broken = [one.claim for one in certificate.findings if one.outcome != "holds"]
    assert broken == [
        "its accelerometer shows 1 g upwards at rest",
        "its joints move to the commanded angle",
        *LINK_CLAIMS,
    ]


def test_a_link_that_fails_is_reported_as_of_every_robot(place):
    with Relay(("127.0.0.1", place.port)) as relay:
        relay.delay = 0.1
        certificate = check_robot(
            lambda: place.robot(port=relay.port, patience=TIMEOUT),
            relay=relay,
            claims=LINK_CLAIMS,
        )
    assert {one.outcome for one in certificate.findings} == {"holds"}


@pytest.mark.parametrize("scene", ["paper", "names"])
def test_the_other_scenes_conform(place, scene, own_home):
    place.save_settings(scene)
    assert check_robot(Robot).passed


# Units and signs.


@pytest.mark.parametrize("scene", ["script", "paper", "names"])
def test_forward_and_right_are_as_for_every_robot(place, scene):
    with place.robot(scene) as robot:
        robot.device(Base).move(100, 0)
        wait_for(lambda: place.pose[0] > 40, "it drives")
        robot.device(Base).move(0, 90)
        wait_for(lambda: place.pose[2] > 20, "it turns")
        turned = robot.device(Gyroscope, "Z_AXIS").read()
        assert place.pose[2] == pytest.approx(turned, abs=6)


@pytest.mark.parametrize("scene", ["script", "names"])
def test_the_pose_is_the_robots_position(place, scene):
    with place.robot(scene) as robot:
        robot.device(Base).move(60, 40)
        wait_for(lambda: place.pose[2] > 50, "it turns")
        robot.device(Base).stop()
        wait_for(lambda: place.speed() < 0.1, "it stands")
        assert robot.device(Base).functions["read"]() == pytest.approx(place.pose, abs=0.01)


@pytest.mark.parametrize("scene", ["script", "paper", "names"])
def test_the_distance_to_a_wall_is_correct(scene):
    with coppeliasim(world="obstacles") as there, there.robot(scene) as robot:
        with there.twin.body() as body:
            expected = body.distances()["front"]
        assert robot.device(DistanceSensors).read()["front"] == pytest.approx(expected, rel=0.1)


@pytest.mark.parametrize("scene", ["script", "paper", "names"])
def test_nothing_in_front_reads_as_nothing_seen(scene):
    with coppeliasim(world="tags") as there:
        with there.twin.body() as body:
            body.distances = lambda: {"front": [2000.0], "left": [], "right": [], "back": []}
        with there.robot(scene) as robot:
            assert robot.device(DistanceSensors).read()["front"] == [2000.0]


@pytest.mark.parametrize("scene", ["script", "paper", "names"])
def test_the_brightness_of_the_floor_is_correct(place, scene):
    with place.robot(scene) as robot:
        with place.twin.body() as body:
            expected = body.ground()["central"]
        read = robot.device(GroundSensors).read()
        assert read["central"] == pytest.approx(expected, abs=5)
        assert (read["left"], read["right"]) == (None, None)


@pytest.mark.parametrize("scene", ["script", "names"])
def test_the_cameras_picture_is_upright(scene):
    with coppeliasim("sim-ebo", "tags") as there, there.robot(scene) as robot:
        with there.twin.body() as body:
            body.place(0, -144, 180)
            expected = body.frame()
        assert (robot.device(Camera).read() == expected).all()
        assert robot.device(Camera).detect("tags") != ()


def test_our_script_shows_emotions():
    with coppeliasim("sim-ebo") as there, there.robot() as robot:
        robot.device(Display).show_emotion("joy")
        with there.twin.body() as body:
            assert body.emotion == "joy"


def test_a_gyroscope_follows_full_turns_and_can_be_reset():
    headings = iter([170, -170, -10, 90, -100, -100, 5])
    turning = Turning(lambda: next(headings), lambda: None)
    assert [turning.read() for _ in range(4)] == [20, 180, 280, 450]
    turning.reset()
    assert turning.read() == 105


def matrix(x, y, axis):
    """A joint at (x, y) in m whose z axis points along `axis`."""
    return (0, 0, axis[0], x, 0, 0, axis[1], y, 0, 0, 0, 0.03)


@pytest.mark.parametrize(
    ("left", "right", "heading"),
    [
        ((0, 0.05), (0, -0.05), 0),
        ((0.05, 0), (-0.05, 0), 90),
        ((-0.05, 0), (0.05, 0), -90),
        ((0, -0.05), (0, 0.05), 180),
    ],
)
def test_a_robot_faces_a_quarter_turn_to_the_right_of_its_left_wheel(left, right, heading):
    axle = Axle(matrix(*left, (0, 1)), matrix(*right, (0, 1)))
    assert axle.pose == pytest.approx((0, 0, heading))
    assert axle.track == pytest.approx(100)


def test_a_joint_whose_axis_points_to_the_left_rolls_forward():
    axle = Axle(matrix(0, 0.05, (0, 1)), matrix(0, -0.05, (0, -1)))
    assert axle.direction(axle.left) == 1
    assert axle.direction(axle.right) == -1


# Programs.


def path_of(points):
    """The positions of a path, from where it starts to move."""
    places = [(x, y) for x, y, _ in points]
    begun = next(i for i, place in enumerate(places) if math.dist(place, places[0]) > 2)
    return places[max(0, begun - 1) :]


@pytest.mark.parametrize(
    ("example", "scene", "world", "seconds"),
    [("square.bt", "script", "empty", 8), ("avoid.bt", "names", "obstacles", 4)],
)
def test_a_program_drives_like_the_twin(example, scene, world, seconds, own_home):
    with coppeliasim(world=world) as there:
        there.save_settings(scene)
        finished = run_example(example, "coppeliasim", seconds=seconds)
        driven = path_of(pose for _, pose in there.twin.path)
    assert finished.report.error is None
    own = run_example(example, "sim-ev3", world=world, seconds=seconds + 2)
    expected = path_of(pose for _, pose in own.recorder.path)
    assert math.dist(driven[0], driven[-1]) > 100
    assert furthest(driven, expected) < 15


def test_the_papers_tags_are_visited_with_the_twins_emotions(own_home):
    start = (215.0, -84.2, 60.0)
    with coppeliasim("sim-ebo", "tags", start) as there:
        there.save_settings("script")

        def is_happy_there():
            return twins.emotion(there.twin) == "joy" and there.twin.goals()["tag 1"]

        report = run_until(is_happy_there, "coppeliasim", "tags.bt")
    own = run_example("tags.bt", "sim-ebo", world="tags", start=start, seconds=4)
    assert report.ended == "stopped"
    assert report.emotions == own.report.emotions == ("neutral", "joy")


# Safety and broken wires.

DRIVE = """
from learnblock.robots.coppeliasim import Robot

robot = Robot()
robot.move_straight(100)
print(robot._guardian._process.pid if robot._guardian else "", flush=True)
input()
"""


@pytest.mark.parametrize("scene", ["script", "paper", "names"])
def test_the_motors_stop_in_time_at_the_end_of_a_program(place, scene):
    robot = place.robot(scene)
    robot.device(Base).move(100, 0)
    wait_for(lambda: place.speed() > 80, "it drives")
    robot.stop()
    assert stands_after(place.twin) < 0.5


def test_our_script_stops_the_motors_while_the_program_sends_nothing(place):
    with place.robot() as robot:
        robot.device(Base).move(100, 0)
        wait_for(lambda: place.speed() > 80, "it drives")
        robot._heartbeat.stop()
        wait_for(lambda: place.speed() < 1, "it stands")
        robot.device(DistanceSensors).read()
        wait_for(lambda: place.speed() > 20, "it drives on")


def test_a_program_that_only_sleeps_keeps_driving(place):
    with place.robot() as robot:
        begun = place.pose[0]
        robot.device(Base).move(50, 0)
        # Without a sign of life, the script would stop it after 18 mm.
        wait_for(lambda: place.pose[0] > begun + 75, "it drives on")


@pytest.mark.parametrize("scene", ["script", "paper", "names"])
@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGSTOP], ids=["killed", "frozen"])
def test_the_motors_stop_in_time_when_a_program_is(place, scene, number, tmp_path, own_home):
    place.save_settings(scene)
    program = tmp_path / "drive.py"
    program.write_text(DRIVE)
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with subprocess.Popen([sys.executable, program], text=True, **pipes) as process:
        guardian = process.stdout.readline().strip()
        wait_for(lambda: place.speed() > 80, "it drives")
        process.send_signal(number)
        left_to_it = place.twin.time
        if guardian:
            # It acts after half a second of its own clock: tests/unit/robots/test_guardian.py.
            wait_until_gone(int(guardian))
            in_time = place.twin.time
        else:
            # The script's watchdog goes by the time of the scene.
            in_time = left_to_it + 0.5
        let_pass(place.twin, 1.5)
        process.kill()
    # Wheels need some time to stop.
    after = [pose for time, pose in place.twin.path if time >= in_time + 0.5]
    assert math.dist(after[0][:2], after[-1][:2]) < 2


def test_a_short_interruption_of_the_link_has_no_effect(place):
    relay = Relay(("127.0.0.1", place.port))
    with relay, place.robot(port=relay.port, patience=6.0) as robot:
        for _ in range(3):
            relay.fault = Fault.CUT
            relay.fault = Fault.NONE
            assert robot.device(DistanceSensors).read()["front"]
            robot.check_link()


def test_a_cut_link_ends_the_run_with_an_error(place, tmp_path):
    program = tmp_path / "drive.bt"
    program.write_text("main:\n    function.move_straight(50)\n    function.sleep(30)\nend\n")
    with Relay(("127.0.0.1", place.port)) as relay:
        user_settings.change("coppeliasim", Settings, "port", str(relay.port))
        user_settings.change("coppeliasim", Settings, "patience", "1.0")

        def cut():
            wait_for(lambda: place.speed() > 40, "it drives")
            relay.fault = Fault.CUT

        cutter = threading.Thread(target=cut)
        cutter.start()
        finished = run_file(program, "coppeliasim")
        cutter.join()
    assert finished.report.ended == "error"
    assert "CoppeliaSim at 127.0.0.1" in str(finished.report.error["message"])
    wait_for(lambda: place.speed() < 1, "it stands")


def test_a_stopped_simulation_is_reported(place):
    with place.robot("names") as robot:
        place.scene.functions["stopSimulation"]()
        with pytest.raises(RobotConnectionError, match=r"The simulation in .* was stopped"):
            wait_for(robot.check_link, "an error")


def test_only_the_program_that_started_a_simulation_stops_it(place):
    state = place.scene.functions["getSimulationState"]
    with place.robot():
        assert state() == 17
        with place.robot():
            pass
        assert state() == 17
    assert state() == 0


def test_two_programs_share_a_robot_without_hanging(place):
    with place.robot() as first, place.robot("names") as second:
        for _ in range(20):
            first.device(Base).move(50, 0)
            second.device(Base).move(-50, 0)
            assert first.device(DistanceSensors).read().keys() == {"front", "left", "right", "back"}


def test_a_missing_coppeliasim_is_reported():
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        port = taken.getsockname()[1]
        with pytest.raises(RobotConnectionError, match=f"Can't reach CoppeliaSim at .*:{port}"):
            Robot(port=port, patience=TIMEOUT)


def test_another_server_at_the_port_is_reported():
    refused = pytest.raises(RobotConnectionError, match="Can't reach CoppeliaSim")
    with mute_server() as port, refused:
        Robot(port=port, patience=TIMEOUT)


@pytest.mark.parametrize(
    ("chosen", "sentence"),
    [
        (
            {"script": "/Robby"},
            "no object /Robby with LearnBlock's script. .* robots setup coppeli",
        ),
        ({"scene": "paper", "script": "/Robby"}, "no object /Robby .* Open the paper's scene"),
        (
            {"scene": "names", "left_wheel": "/wheel"},
            "no object /wheel. .* setting 'left_wheel'",
        ),
    ],
)
def test_a_missing_object_of_the_scene_is_reported_by_name(place, chosen, sentence):
    with pytest.raises(RobotConnectionError, match=sentence):
        Robot(port=place.port, patience=LONG, **chosen)


def test_a_connection_leaves_the_names_of_the_users_program_alone(place, monkeypatch):
    monkeypatch.setattr(sys.modules["__main__"], "require", "mine", raising=False)
    with place.robot():
        assert sys.modules["__main__"].require == "mine"


def test_without_the_vendors_client_the_error_names_the_package(monkeypatch):
    monkeypatch.setitem(sys.modules, "coppeliasim_zmqremoteapi_client", None)
    with pytest.raises(LearnBlockError, match="needs an add-on") as caught:
        Robot()
    assert str(caught.value).endswith(add_on("coppeliasim"))


# The command line.


def test_devices_are_known_beforehand_if_the_settings_name_them(own_home):
    assert Robot.device_names() is None
    user_settings.change("coppeliasim", Settings, "scene", "names")
    user_settings.change("coppeliasim", Settings, "front", '["/sonar"]')
    user_settings.change("coppeliasim", Settings, "camera", "/eye")
    expected = {"Base:ROBOT", "Gyroscope:Z_AXIS", "DistanceSensors:ROBOT", "Camera:ROBOT"}
    assert Robot.device_names() == expected


def test_set_up_copies_the_script_and_explains_how_to_load_it(own_home):
    steps = []
    Robot.set_up(Settings(), steps.append)
    script = home() / "coppeliasim" / "scene.lua"
    assert "function drive(adv, rot)" in script.read_text()
    assert steps == [Phrase("coppeliasim-setup-done", path=str(script))]


def test_a_scan_finds_it_at_the_address_of_the_settings(place, own_home):
    user_settings.change("coppeliasim", Settings, "port", str(place.port))
    assert list(Robot.scan(LONG)) == [{"address": "127.0.0.1", "port": place.port}]


def test_a_scan_without_robots_ends(own_home):
    user_settings.change("coppeliasim", Settings, "port", "9")
    assert list(Robot.scan(0.5)) == []


# Its page.

PAGE = ROOT / "docs" / "robots" / "coppeliasim.md"


def test_the_pages_example_is_a_file_of_settings(own_home):
    (own_home / "settings.toml").write_text(
        re.search("```toml\n(.*?)```", PAGE.read_text(), re.S)[1]
    )
    settings = user_settings.load("coppeliasim", Settings)
    assert (settings.scene, settings.wheel_radius, len(settings.front)) == ("names", 97.5, 2)


def test_the_page_names_every_setting_with_its_default():
    rows = re.findall(r"^\| (`\w+`(?:, `\w+`)*) \| (.*?) \|", PAGE.read_text(), re.M)
    told = {name: default for names, default in rows for name in re.findall(r"`(\w+)`", names)}
    fields = {one.name: one.default for one in user_settings.describe("coppeliasim", Settings)}
    assert fields.keys() <= told.keys()
    for name in ("port", "patience", "wheel_radius"):
        assert float(told[name]) == fields[name]
