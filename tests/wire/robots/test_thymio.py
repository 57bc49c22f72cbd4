"""A Thymio in Aseba's playground, which is not our simulator, through the real driver and wire."""

import math
import os
import select
import socket
import subprocess
import sys
import threading
from contextlib import closing, contextmanager, suppress
from pathlib import Path

import pytest

from emulated import LONG, settle
from learnblock.devices import (
    Accelerometer,
    Base,
    Controller,
    DistanceSensors,
    Emotion,
    GroundSensors,
    RGBLed,
)
from learnblock.emulators.thymio import Emulator
from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots.thymio import Robot
from learnblock.robots.thymio.equipment import EMOTIONS
from learnblock.robots.thymio.frames import Frames
from learnblock.robots.thymio.program import DONE, LEFT, RIGHT, SOUND, TONE, TOP
from learnblock.robots.thymio.units import level
from learnblock.simulator.geometry import Pose
from learnblock.simulator.goal import RobotState
from learnblock.simulator.goals import goals
from learnblock.testing import LINK_CLAIMS, Fault, Relay, check_robot
from playground import Playground, missing
from ports import free_port, mute_server
from runs import run_example
from twins import off
from waiting import wait_for

#: Seconds within which the motors must stop, and the mm that count as standing still.
STOPPING, STILL = 0.5, 1.0
#: The accelerometer is always 0 there.
EXCUSED = {"its accelerometer shows 1 g upwards at rest": "the playground simulates none"}
SMALL_ROUND = """
floor = { size = [1200, 1200] }
start = [{ x = -60, y = -150, heading = 180 }]

[[line]]
width = 60
start = [-100, -150, 180]
closed = true
path = [
    { turn = 180, radius = 150 }, { forward = 100 },
    { turn = 180, radius = 150 }, { forward = 100 },
]

[[goal.follow]]
name = "a fifth of a lap"
fraction = 0.2
"""


@pytest.fixture(scope="module")
def shared():
    """A playground with an empty floor, 2 by 2 m, for all tests that leave it unchanged."""
    with closing(Playground("empty")) as ground:
        ground.settings = {**ground.settings, "patience": LONG}
        yield ground


@pytest.fixture
def ground(shared):
    shared.pose = Pose(0, 0, 0)
    return shared


@pytest.fixture
def robot(ground):
    with Robot(**ground.settings) as robot:
        yield robot


@contextmanager
def switched(world):
    """A playground behind Aseba's switch, which connects many clients to one robot.

    The switch survives broken connections, and the playground alone does not.
    """
    with closing(Playground(world)) as ground:
        port = free_port()
        target = f"tcp:host=127.0.0.1;port={ground.settings['port']}"
        process = subprocess.Popen(
            ["asebaswitch", "-p", str(port), target], stderr=subprocess.DEVNULL
        )
        wait_for(lambda: listens(port), "the switch listens")
        ground.settings = {**ground.settings, "port": port, "patience": LONG}
        yield ground
        process.kill()
        process.wait()


@pytest.fixture(scope="module")
def shared_hub():
    with switched("empty") as ground:
        yield ground


@pytest.fixture
def hub(shared_hub):
    """A playground behind a switch."""
    shared_hub.pose = Pose(0, 0, 0)
    return shared_hub


@pytest.fixture
def relay(hub):
    """A wire to it that can fail."""
    with Relay(("127.0.0.1", hub.settings["port"])) as relay:
        yield relay


def listens(port):
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


# What every robot promises.


def test_it_conforms(hub):
    assert check_robot(lambda: Robot(**hub.settings), excused=EXCUSED).passed


def test_a_link_that_fails_is_reported_as_of_every_robot(hub, relay):
    chosen = {**hub.settings, "port": relay.port, "patience": 1.0}
    assert check_robot(
        lambda: Robot(**chosen), relay=relay, claims=LINK_CLAIMS, patience=3.5
    ).passed


# Devices, compared with the robot's true pose.


def test_speeds_are_true_mm_and_degrees_per_second(ground, robot):
    robot.set_move(60, 45)
    with ground.watching() as path:
        wait_for(lambda: path and path[-1][0] > 1.5, "one and a half seconds of its way")
    robot.stop_bot()
    (begin, first), (end, last) = path[5], path[-1]
    turned = math.radians(last.heading - first.heading)
    radius = math.dist((last.x, last.y), (first.x, first.y)) / (2 * math.sin(turned / 2))
    assert radius == pytest.approx(60 / math.radians(45), rel=0.05)
    # On a busy machine, the playground's time lags behind ours.
    assert 30 < math.degrees(turned) / (end - begin) < 48


def test_its_odometry_follows_its_true_way(ground, robot):
    with ground.watching() as path:
        for command in ((80, 0), (40, 45), (0, -60)):
            robot.set_move(*command)
            robot.sleep(1)
        robot.stop_bot()
        robot.sleep(0.5)
    first, last = path[0][1], path[-1][1]
    x, y, heading = robot.get_pose()
    turned = math.radians(first.heading)
    east, north = last.x - first.x, last.y - first.y
    ahead = east * math.cos(turned) - north * math.sin(turned)
    left = east * math.sin(turned) + north * math.cos(turned)
    assert math.dist((x, y), (ahead, left)) < 12
    assert (heading - (last.heading - first.heading) + 180) % 360 - 180 == pytest.approx(0, abs=6)


@pytest.mark.parametrize("mm", [20, 60, 110])
def test_the_distance_to_a_wall_in_front_is_correct(ground, robot, mm):
    # The front sensor is 79.5 mm in front of the middle, and the border is at 1 m.
    ground.pose = Pose(1000 - 79.5 - mm, 0, 0)
    wait_for(lambda: abs(front(robot) - mm) < 3, f"a wall at {mm} mm")


def front(robot):
    return robot.device(DistanceSensors).read()["front"][1]


def test_a_wall_on_the_right_is_seen_only_on_the_right(ground, robot):
    ground.pose = Pose(0, -1000 + 100, 0)
    sensors = robot.device(DistanceSensors)
    wait_for(lambda: min(sensors.read()["right"]) < 2000, "a wall on the right")
    assert min(sensors.read()["left"]) == 2000


def test_a_wall_behind_is_seen_only_behind(ground, robot):
    ground.pose = Pose(-1000 + 70, 0, 0)
    sensors = robot.device(DistanceSensors)
    wait_for(lambda: min(sensors.read()["back"]) < 60, "a wall behind")
    assert min(sensors.read()["front"]) == 2000


def test_a_white_floor_is_bright_under_both_sensors(robot):
    reading = robot.device(GroundSensors).read()
    assert reading["central"] is None
    assert min(reading["left"], reading["right"]) > 80


def test_its_arrows_are_those_of_a_controllers_left_half(ground, robot):
    controller = robot.device(Controller)
    for number, button in enumerate(("lDown", "lLeft", None, "lUp", "lRight")):
        ground.press(number, down=True)
        expected = {name: name == button for name in controller.read()}
        wait_for(lambda expected=expected: controller.read() == expected, f"{button}")
        ground.press(number, down=False)


def test_the_playground_has_no_accelerometer(robot):
    assert robot.device(Accelerometer).read() == (0.0, 0.0, 0.0)


# Lamps and sounds, as reported by the robot itself.


class Tap(Relay):
    """A wire that records what the robot reports."""

    def __init__(self, target):
        super().__init__(target)
        self._heard = b""

    def _damaged(self, data):
        self._heard += data
        return super()._damaged(data)

    @property
    def done(self):
        """(event's number, its numbers...) of everything that the robot has shown and played."""
        messages = list(Frames().feed(self._heard))
        return [tuple(one.user_event_arg) for one in messages if one.id == DONE.number]


def colours(emotion):
    shown = tuple(map(level, EMOTIONS[emotion]))
    return [(lamp.number, *shown) for lamp in (TOP, LEFT, RIGHT)]


def test_lamps_and_sounds_reach_the_robots_own_functions(hub):
    with (
        Tap(("127.0.0.1", hub.settings["port"])) as tap,
        Robot(**{**hub.settings, "port": tap.port}) as robot,
    ):
        robot.device(RGBLed, "Left").set_color(255, 128, 0)
        robot.expressAnger()
        robot.play_frequency(440, 500)
        robot.play_audio("friendly")
        expected = [
            (LEFT.number, 32, 16, 0),
            *colours(Emotion.ANGER),
            (TONE.number, 440, 30),
            (SOUND.number, 6),
        ]
        wait_for(lambda: len(tap.done) == len(expected), "all are shown and played")
    numbers = [one[: len(wanted)] for one, wanted in zip(tap.done, expected, strict=True)]
    assert numbers == expected


# Programs in their own runs.


def reach(place, **others):
    """Point the user's settings to this robot."""
    settle("thymio", {**place, **others})


def test_the_papers_program_follows_a_line(tmp_path):
    world = tmp_path / "round.toml"
    world.write_text(SMALL_ROUND)
    with (
        switched(str(world)) as ground,
        Tap(("127.0.0.1", ground.settings["port"])) as tap,
        ground.watching() as path,
    ):
        reach(ground.settings, port=tap.port)
        finished = run_example("line-thymio.bt", "thymio", seconds=12)
    (goal,) = goals(ground.world)
    for time, pose in path:
        goal.look(time, [RobotState("robot", time, pose)])
    assert (finished.report.error, finished.report.ended) == (None, "time limit")
    assert goal.state.reached_at is not None, goal.state
    line = ground.world.line[0].polyline()
    assert max(line.nearest(pose.x, pose.y)[0] for _, pose in path) < 100
    shown = [colours(emotion) for emotion in finished.report.emotions]
    assert tap.done == [lamp for emotion in shown for lamp in emotion]


def test_a_program_drives_it_to_the_same_place_as_its_twin(ground):
    reach(ground.settings)
    # Places are compared, without their times: asking for one takes a process of its own, so on a
    # busy machine nobody knows when it was there. Seldom, since each of them keeps it busy, too.
    with ground.watching(every=0.2) as path:
        run_example("polygons.bt", "thymio", seconds=7)
    twin = run_example("polygons.bt", "sim-thymio", world="empty", seconds=7).recorder.path
    expected = from_its_start([(x, y) for time, (x, y, _) in twin if time < 6])
    actual = from_its_start([(pose.x, pose.y) for _, pose in path])
    # Stated tolerance: 15 mm over the 190 mm that it drives, with a turn in them.
    assert off(expected, actual) < 15
    assert off(actual, from_its_start([(x, y) for _, (x, y, _) in twin])) < 15


def from_its_start(places):
    (x0, y0), *_ = places
    return [(x - x0, y - y0) for x, y in places]


# However the program ends, the robot stops.

PROGRAM = """
from learnblock.robots.thymio import Robot

robot = Robot()
robot.set_move(60, 0)
robot.sleep(0.7)
print("going", flush=True)
robot.sleep(60)
"""


@pytest.mark.parametrize("hosted", [True, False], ids=["learnblock run", "python"])
def test_it_stops_when_its_runner_is_killed(ground, tmp_path, hosted):
    reach(ground.settings)
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)
    command = ["-m", "learnblock", "run", program] if hosted else [program]
    begun = subprocess.Popen(
        [sys.executable, *command], stdout=subprocess.PIPE, text=True, start_new_session=True
    )
    with begun:
        assert "going\n" in iter(begun.stdout.readline, "")
        with ground.watching() as path:
            wait_for(lambda: len(path) > 5, "it drives")
            begun.kill()
            ended = path[-1][0]
            wait_for(lambda: path[-1][0] > ended + STOPPING + 0.4, "time passes")
    assert_stood(path, ended)


def assert_stood(path, ended):
    """Check that it was driving when the program ended and stopped half a second later."""
    before = [pose.x for time, pose in path if time <= ended]
    after = [pose.x for time, pose in path if time >= ended + STOPPING]
    assert before[-1] - before[0] > 3, "it did not drive"
    assert max(after) - min(after) < STILL, f"it went on driving: {after}"


def test_it_stops_by_itself_when_the_link_is_silent(hub, relay):
    robot = Robot(**{**hub.settings, "port": relay.port})
    robot.set_move(60, 0)
    with hub.watching() as path:
        wait_for(lambda: path and path[-1][1].x > 20, "it drives")
        relay.fault = Fault.SILENT
        ended = path[-1][0]
        wait_for(lambda: path[-1][0] > ended + STOPPING + 2.2, "time passes")
    with pytest.raises(RobotConnectionError, match="has not answered for"):
        robot.stop()
    assert_stood(path, ended)


# Faults.


def test_a_missing_program_is_reported_with_what_to_check():
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        port = taken.getsockname()[1]
        with pytest.raises(RobotConnectionError) as error:
            Robot(connection="tcp", port=port)
    assert error.value.phrase == Phrase("thymio-no-listener", place=f"127.0.0.1:{port}")


def test_a_server_that_never_answers_is_given_up():
    with mute_server() as port, pytest.raises(RobotConnectionError, match="No Thymio answers at"):
        Robot(connection="tcp", port=port, patience=0.5)


def test_a_server_with_another_protocol_is_not_a_thymio():
    with socket.create_server(("127.0.0.1", 0)) as server:
        thread = threading.Thread(target=refuse_as_a_web_server, args=(server,))
        thread.start()
        with pytest.raises(RobotConnectionError, match="does not come from a Thymio"):
            Robot(connection="tcp", port=server.getsockname()[1])
        thread.join()


def refuse_as_a_web_server(server):
    connection, _ = server.accept()
    with connection:
        connection.sendall(b"HTTP/1.1 400 Bad Request\r\n")
        connection.recv(1000)


def test_the_playground_accepts_a_second_program_and_the_first_one_gets_an_error(ground):
    first = Robot(**ground.settings)
    first.set_move(60, 0)
    with (
        Robot(**ground.settings),
        pytest.raises(RobotConnectionError, match=r"closed by the other end.*not in use by"),
    ):
        wait_for(first.check_link, "it is told")
    wait_for(lambda: standing(ground), "it stands")
    let_go(first)


def let_go(robot):
    """The first program can no longer stop the robot, and may report that."""
    with suppress(RobotConnectionError):
        robot.stop()
    assert robot.stopped


def standing(ground):
    """Whether it doesn't move for a tenth of a second of our time."""
    with ground.watching() as path:
        wait_for(lambda: path and path[-1][0] > path[0][0] + 0.1, "time passes")
    (_, first), (_, last) = path[0], path[-1]
    return math.dist((first.x, first.y), (last.x, last.y)) < STILL


def test_behind_a_switch_the_first_program_gets_an_error_when_a_second_one_connects(hub):
    first = Robot(**hub.settings)
    first.set_move(60, 0)
    with (
        Robot(**hub.settings) as second,
        pytest.raises(RobotConnectionError, match="Another program is now using"),
    ):
        wait_for(first.check_link, "it is told")
    let_go(first)
    assert second.stopped
    wait_for(lambda: standing(hub), "it stands")


def test_after_a_cut_it_can_be_connected_again(hub, relay):
    chosen = {**hub.settings, "port": relay.port, "patience": 1.0}
    for _ in range(3):
        robot = Robot(**chosen)
        relay.fault = Fault.CUT
        with pytest.raises(RobotConnectionError):
            wait_for(lambda robot=robot: robot.device(Base).move(10, 0), "an error")
        let_go(robot)
        relay.fault = Fault.NONE


# A serial cable: a pseudo-terminal with the playground at its other end.


@contextmanager
def cable(ground):
    """The path of a serial port that leads to the playground, and a way to unplug it."""
    import pty  # not available on Windows

    inner, outer = pty.openpty()
    unplugged = threading.Event()
    with socket.create_connection(("127.0.0.1", ground.settings["port"])) as wire:
        thread = threading.Thread(target=carry, args=(inner, wire, unplugged), daemon=True)
        thread.start()
        try:
            yield os.ttyname(outer), unplugged
        finally:
            unplugged.set()
            thread.join()
            os.close(outer)
            wire.shutdown(socket.SHUT_WR)
            while wire.recv(65536):
                pass


def carry(inner, wire, unplugged):
    while not unplugged.is_set():
        ready, _, _ = select.select([inner, wire], [], [], 0.05)
        if inner in ready:
            wire.sendall(os.read(inner, 4096))
        if wire in ready:
            os.write(inner, wire.recv(4096))
    os.close(inner)


@pytest.mark.skipif(sys.platform == "win32", reason="a pseudo-terminal is POSIX's")
def test_a_cable_does_what_the_network_does_until_it_is_unplugged(ground):
    with cable(ground) as (device, unplugged):
        with Robot(connection="serial", device=device) as robot:
            robot.set_move(60, 0)
            wait_for(lambda: ground.pose.x > 5, "it drives")
        with Robot(connection="serial", device=device) as robot:
            with pytest.raises(RobotConnectionError, match=r"(no other|by another) program"):
                Robot(connection="serial", device=device)
            unplugged.set()
            with pytest.raises(RobotConnectionError, match=f"{device} (was lost|has not)"):
                wait_for(robot.check_link, "an error")
            let_go(robot)


def test_a_missing_port_is_reported_by_name():
    with pytest.raises(RobotConnectionError, match=r"/dev/none .*plugged in"):
        Robot(connection="serial", device="/dev/none")


def test_without_a_thymio_the_error_asks_for_the_cable(monkeypatch):
    monkeypatch.setattr("serial.tools.list_ports.comports", list)
    with pytest.raises(RobotConnectionError, match="No Thymio is plugged in"):
        Robot(connection="serial")


# Scanning.


def test_a_scan_yields_settings(ground, monkeypatch):
    monkeypatch.setattr("serial.tools.list_ports.comports", list)
    reach({"port": ground.settings["port"], "suite_port": 1})
    expected = {"connection": "tcp", "address": "127.0.0.1", "port": ground.settings["port"]}
    assert list(Robot.scan(20)) == [expected]


def test_auto_uses_the_network_without_suite_and_cable(ground, monkeypatch):
    monkeypatch.setattr("serial.tools.list_ports.comports", list)
    with Robot(port=ground.settings["port"], suite_port=1) as robot:
        assert robot.device(GroundSensors) is not None


@pytest.mark.skipif(bool(missing()), reason=missing())
def test_nothing_of_the_playground_is_left_when_it_is_closed():
    with closing(Emulator("empty")) as emulator:
        folder = emulator._folder.name
        process = emulator._process
    assert process.poll() is not None
    assert not Path(folder).exists()
