"""The client of a new robot: the generated code works, and the rest says what to do."""

import math

import pytest

from learnblock import robots
from learnblock.client import Rights
from learnblock.devices import (
    Accelerometer,
    Base,
    Bumper,
    Camera,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
    JointMotor,
    LightSensor,
)
from learnblock.errors import NotWrittenError
from learnblock.new.files import write_new
from learnblock.new.robot import files_at_home
from learnblock.new.robot_plan import named, read_plan
from learnblock.testing import check_function, check_robot, functions_of
from learnblock.wheels import body_speeds
from new_robots import EVERYTHING


@pytest.fixture
def client(own_home, tmp_path):
    """Return the client that is written for a robot with every device."""
    (tmp_path / "whole.toml").write_text(EVERYTHING, encoding="utf-8")
    plan = named(read_plan(tmp_path / "whole.toml"), "whole")
    write_new(files_at_home(plan, own_home))
    return robots.find("whole").load()


READERS = {
    "acceleration": Accelerometer,
    "touches": Bumper,
    "ground": GroundSensors,
    "light_sensor": LightSensor,
}
COMMANDS = (
    "animate", "show_emotion", "send_code", "switch_lamp", "select_song", "press", "set_volume",
    "set_equalizer", "set_loop", "light_icon", "light_number",
    "light_text", "colour_lamp", "say",
    "play", "tone",
)  # fmt: skip


class FilledIn:
    """Fill in the functions that are left to the user: the twin is the hardware."""

    def __init__(self):
        self.twin = robots.connect("sim-whole", world="empty")
        self.turned = {}
        super().__init__(clock=self.twin.clock)

    def open_link(self):
        for name, kind in READERS.items():
            setattr(self, name, self.twin.device(kind).read)
        self.measure_heading = self.twin.device(Gyroscope, "Z_AXIS").read
        for name in COMMANDS:
            setattr(self, name, lambda *given: None)

    def close_link(self):
        self.twin.stop()

    def turn_wheels(self, left, right):
        self.twin.device(Base).move(*body_speeds((left, right), self.settings.track))

    def measure_distances(self):
        seen = self.twin.device(DistanceSensors).read()
        return [seen["left"][0], seen["right"][0]]

    def picture(self, camera):
        return self.twin.device(Camera, camera).read()

    def received_code(self):
        return None

    def turn_joint(self, joint, degrees):
        self.turned[joint] = degrees


def filled_in(client):
    return type("Filled", (FilledIn, client), {"__module__": client.__module__})


def test_a_finished_client_passes_the_checks_of_every_robot(client):
    assert check_robot(filled_in(client)).passed


def test_each_of_its_functions_has_the_right_arguments_and_result(client):
    with filled_in(client)() as robot:
        for function in functions_of(robot):
            check_function(robot, function)


def test_distances_appear_at_the_sides_of_each_sensor(client):
    with filled_in(client)() as robot:
        robot.measure_distances = lambda: [100.0, 200.0]
        seen = robot.device(DistanceSensors).read()
    assert seen == {"left": [100.0], "front": [100.0], "right": [200.0]}


def test_wheels_never_get_more_than_their_maximum_speed(client):
    with filled_in(client)() as robot:
        told = []
        robot.turn_wheels = lambda *speeds: told.append(speeds)
        robot.device(Base).move(100, 90)
        robot.device(Base).move(800, 0)
        difference = math.radians(90) * 115 / 2
        assert told == [(100 + difference, 100 - difference), (400, 400)]


def test_joints_only_get_angles_within_their_ranges(client):
    with filled_in(client)() as robot:
        for _, device in robot.devices():
            if isinstance(device, JointMotor):
                device.move(45)
        assert sorted(robot.turned.values()) == [20, 22]


def test_it_may_do_what_its_connections_need_and_nothing_else(client):
    ports = ("/dev/ttyACM*", "/dev/ttyUSB*")
    assert client.rights == Rights(network=True, devices=ports)


def test_an_unwritten_function_names_its_position_and_its_task(client):
    class Opened(client):
        def open_link(self):
            self.measure_heading = lambda: 0.0

        def close_link(self):
            pass

        def turn_wheels(self, left, right):
            if left or right:
                super().turn_wheels(left, right)

    with Opened() as robot:
        tasks = {name: task_of(robot, name) for name in functions_of(robot)}
        with pytest.raises(NotWrittenError, match=r"\'turn_wheels\(50.0, 50.0\)\' still .*mm/s"):
            robot.device(Base).move(50, 0)
    assert "whole.py, line" in tasks["LightSensor:ROBOT.read"]
    assert "0 (dark) to 1023" in tasks["LightSensor:ROBOT.read"]
    assert "from left to right, mm: 0 to 2000" in tasks["DistanceSensors:ROBOT.read"]
    assert "'switch_lamp('Back', False)'" in tasks["Led:Back.set"]
    written = {name for name, task in tasks.items() if not task}
    assert written == {
        "Base:ROBOT.move",
        "Base:ROBOT.read",
        "Gyroscope:Z_AXIS.read",
        "Gyroscope:Z_AXIS.reset",
    }


def task_of(robot, function):
    """Return the task that a function reports; empty if it is already written."""
    try:
        check_function(robot, function)
    except NotWrittenError as task:
        return str(task)
    return ""


def test_connecting_without_a_written_link_is_reported(client):
    with pytest.raises(
        NotWrittenError, match=r"whole.py, line \d+: \'open_link\(\)\' still has to be written"
    ):
        client()
