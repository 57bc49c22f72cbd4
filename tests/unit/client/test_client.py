import atexit
import signal
import subprocess
import sys
import textwrap
import threading
import time

import pytest

from learnblock.client import Client, endings
from learnblock.client.readings import PolledReadings
from learnblock.devices import Base, Camera, DistanceSensors, Gyroscope, Led
from learnblock.errors import (
    KeyTakenError,
    RobotAttributeError,
    RobotConnectionError,
    RobotStoppedError,
)
from learnblock.i18n import Phrase
from learnblock.testing import FakeRobot, VirtualClock

pytestmark = pytest.mark.realtime

needs_posix = pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")


class Logging(Client):
    """A robot that records when it is connected, driven and disconnected."""

    def __init__(self, *, bases=1, **options):
        self.log, self._bases = [], bases
        options.setdefault("skills", [])
        super().__init__(**options)

    def connect(self):
        self.log.append("connect")
        for number in range(self._bases):
            self.add(Base(self.mover(number)), str(number))

    def mover(self, number):
        return lambda adv, rot: self.log.append(f"move {number} {adv:g} {rot:g}")

    def disconnect(self):
        self.log.append("disconnect")


LIFE = ["connect", "move 0 0 0", "disconnect"]


class Observer:
    def __init__(self):
        self.calls, self.missed = [], []

    def called(self, skill, args, kwargs):
        self.calls.append((skill, args, kwargs))

    def missing(self, skill, device):
        self.missed.append((skill, device))


# The end in this process.


def test_stop_stops_the_motors_first_and_then_disconnects():
    robot = Logging()
    robot.stop()
    assert LIFE == robot.log
    assert robot.stopped


def test_stopping_twice_is_harmless():
    robot = Logging()
    robot.stop()
    robot.stop()
    assert LIFE == robot.log


def test_the_end_of_a_with_stops_the_robot():
    with Logging() as robot:
        assert not robot.stopped
    assert LIFE == robot.log


def test_an_error_in_a_with_stops_the_robot_and_propagates():
    with pytest.raises(ZeroDivisionError), Logging() as robot:
        1 / 0  # noqa: B018 - it raises
    assert LIFE == robot.log


def test_stop_from_many_threads_disconnects_once():
    robot = Logging()
    together = threading.Barrier(8)

    def stop():
        together.wait()
        robot.stop()

    threads = [threading.Thread(target=stop) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert LIFE == robot.log


def test_an_error_while_disconnecting_is_raised_once():
    class Broken(Logging):
        def disconnect(self):
            super().disconnect()
            raise OSError("the cable is out")

    robot = Broken()
    with pytest.raises(OSError, match="the cable is out"):
        robot.stop()
    robot.stop()
    assert LIFE == robot.log


def test_motors_that_cannot_be_stopped_prevent_neither_other_stops_nor_the_disconnection():
    class Broken(Logging):
        def mover(self, number):
            def move(adv, rot):
                self.log.append(f"move {number}")
                if number == 1:
                    raise OSError("stuck")

            return move

    robot = Broken(bases=3)
    with pytest.raises(OSError, match="stuck"):
        robot.stop()
    assert robot.log == ["connect", "move 2", "move 1", "move 0", "disconnect"]


def test_an_interrupt_while_stopping_does_not_leave_the_motors_running(monkeypatch):
    def interrupt(stop):
        atexit.unregister(stop)
        raise KeyboardInterrupt

    monkeypatch.setattr(endings, "forget", interrupt)
    robot = Logging()
    with pytest.raises(KeyboardInterrupt):
        robot.stop()
    assert LIFE == robot.log


def test_motors_stop_before_the_sensors_thread_is_waited_for():
    class Polling(Logging):
        def _make_readings(self):
            readings = super()._make_readings()
            close = readings.close
            readings.close = lambda: (self.log.append("sensors"), close())
            return readings

    robot = Polling()
    robot.stop()
    assert robot.log == ["connect", "move 0 0 0", "sensors", "disconnect"]


def test_a_connection_that_fails_half_way_is_undone_once():
    class Half(Logging):
        def connect(self):
            super().connect()
            raise RobotConnectionError("the robot at port 3 does not answer")

    logs = []
    Half.disconnect = lambda self: logs.append([*self.log, "disconnect"])
    with pytest.raises(RobotConnectionError, match="the robot at port 3 does not answer"):
        Half()
    assert logs == [["connect", "disconnect"]]


def test_an_error_while_disconnecting_does_not_hide_the_first_error():
    class Half(Client):
        def connect(self):
            raise RobotConnectionError("the port is closed")

        def disconnect(self):
            self.port.close()

    with pytest.raises(RobotConnectionError, match="the port is closed") as caught:
        Half(skills=[])
    assert "Disconnecting failed too: RobotAttributeError" in caught.value.__notes__[0]


def test_a_skill_of_the_user_does_not_hide_a_method_of_the_client(own_home):
    (own_home / "skills").mkdir()
    (own_home / "skills" / "mine.py").write_text("def stop(robot): pass\ndef clock(robot): pass\n")

    with FakeRobot() as robot:
        robot.stop()
        assert robot.stopped
        assert robot.clock.time() == 0


def test_a_function_of_the_program_can_become_a_skill():
    observer = Observer()

    def waltz(robot, times=1):
        robot.stop_bot()
        return times

    with FakeRobot(only=[], observer=observer) as robot:
        robot.learn(waltz)
        assert robot.waltz(times=3) == 3
    assert observer.missed == [("waltz", "Base:ROBOT")]


def test_a_skill_cannot_hide_an_attribute_of_every_robot():
    def stop(robot): ...

    with (
        FakeRobot(skills=[]) as robot,
        pytest.raises(KeyTakenError) as caught,
    ):
        robot.learn(stop)
    assert caught.value.phrase == Phrase("robot-skill-name-taken", name="stop")


# The end of a process.

ROBOT = """
import sys
from pathlib import Path
from learnblock.client import Client
from learnblock.devices import Base

class Robot(Client):
    def __init__(self):
        self.file = Path(sys.argv[1])
        super().__init__(skills=[])
    def connect(self):
        self.note("connect")
        self.add(Base(lambda adv, rot: self.note(f"move {adv:g} {rot:g}")))
    def disconnect(self):
        self.note("disconnect")
    def note(self, text):
        with self.file.open("a") as file:
            file.write(text + "\\n")

robot = Robot()
robot.device(Base).move(100, 0)
"""


def lived(tmp_path, ending, send=None):
    """Return the log of a robot whose program ends like this, and the program's exit status."""
    program, log = tmp_path / "program.py", tmp_path / "log"
    program.write_text(ROBOT + textwrap.dedent(ending))
    process = subprocess.Popen(
        [sys.executable, str(program), str(log)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    with process:
        if send is not None:
            assert process.stdout.readline() == "ready\n"
            process.send_signal(send)
        process.wait(20)
    return log.read_text().splitlines(), process.returncode


WHOLE_LIFE = ["connect", "move 100 0", "move 0 0", "disconnect"]
WAIT = "print('ready', flush=True)\nimport time\ntime.sleep(20)\n"


@pytest.mark.parametrize(
    ("ending", "status"),
    [
        ("", 0),
        ("raise ValueError", 1),
        ("sys.exit(3)", 3),
        ("robot.stop()", 0),
        ("robot.stop()\nrobot.stop()\nraise ValueError", 1),
        ("with robot: raise ValueError", 1),
        ("with robot: pass", 0),
        ("del robot", 0),
        ("import threading\nthreading.Thread(target=robot.stop).start()", 0),
    ],
)
def test_a_robot_is_stopped_and_disconnected_once_at_any_end_of_its_program(
    tmp_path, ending, status
):
    assert lived(tmp_path, ending) == (WHOLE_LIFE, status)


@needs_posix
@pytest.mark.parametrize("waiting", [WAIT, "with robot:\n" + textwrap.indent(WAIT, "    ")])
def test_ctrl_c_stops_the_robot(tmp_path, waiting):
    log, status = lived(tmp_path, waiting, send=signal.SIGINT)
    assert log == WHOLE_LIFE
    assert status != 0


@needs_posix
@pytest.mark.parametrize("waiting", [WAIT, "with robot:\n" + textwrap.indent(WAIT, "    ")])
def test_sigterm_stops_the_robot(tmp_path, waiting):
    log, status = lived(tmp_path, waiting, send=signal.SIGTERM)
    assert log == WHOLE_LIFE
    assert status == 128 + signal.SIGTERM


@needs_posix
def test_a_programs_own_handler_of_sigterm_is_left_alone(monkeypatch):
    handler = signal.signal(signal.SIGTERM, print)
    try:
        with Logging():
            assert signal.getsignal(signal.SIGTERM) is print
    finally:
        signal.signal(signal.SIGTERM, handler)


# Devices.


def test_devices_of_a_type_have_different_keys():
    with Logging(bases=0) as robot:
        for key in ("left", "right"):
            robot.add(Led(lambda on, key=key: robot.log.append((key, on))), key)
        robot.device(Led, "right").set(True)
        assert robot.log[-1] == ("right", True)
        assert [key for key, _ in robot.devices()] == ["left", "right"]


def test_a_second_device_with_the_same_key_is_refused():
    with Logging() as robot, pytest.raises(KeyTakenError) as caught:
        robot.add(Base(bool), "0")
    assert caught.value.phrase == Phrase("robot-key-taken", device="Base", key="0")


def test_devices_of_different_types_can_share_a_key():
    with Logging() as robot:
        robot.add(Led(bool), "0")
        assert robot.device(Led, "0")


def test_a_missing_device_is_none_and_so_is_its_reading():
    with Logging(bases=0) as robot:
        assert robot.device(Base) is None
        assert robot.read(DistanceSensors) is None
        assert robot.detect("tags") is None


def test_a_missing_device_is_reported_once_per_call():
    observer = Observer()
    with FakeRobot(only=[], observer=observer) as robot:
        robot.slow_down()
        robot.slow_down()
        robot.move_straight()
    assert observer.missed == [
        ("slow_down", "Base:ROBOT"),
        ("slow_down", "Base:ROBOT"),
        ("move_straight", "Base:ROBOT"),
    ]


def test_queries_in_quick_succession_use_the_same_picture():
    pictures = []

    class Watching(Client):
        sensing_period = None

        def connect(self):
            self.add(Camera(read=lambda: None, detect=self.detect_in_a_new_picture))

        def detect_in_a_new_picture(self, name):
            pictures.append(name)
            return ()

    with Watching() as robot:
        robot.is_tag(1)
        robot.is_tag(2)
        robot.tag_on_the_left()
        assert pictures == ["tags"]
        robot.is_tag(1)
        assert pictures == ["tags", "tags"]


def test_a_missing_detector_is_reported_to_the_observer():
    observer = Observer()
    with FakeRobot(only=[Camera], observer=observer) as robot:
        robot.set_detections("tags", None)
        robot.is_any_tag()
    assert observer.missed == [("is_any_tag", "Detector:tags")]


def test_a_missing_device_outside_a_skill_is_not_reported():
    observer = Observer()
    with FakeRobot(only=[], observer=observer, skills=[]) as robot:
        robot.device(Base)
    assert observer.missed == []


def test_only_the_programs_calls_are_reported_to_the_observer():
    observer = Observer()
    with FakeRobot(observer=observer) as robot:
        robot.turn_90_right()
        robot.move_straight(advSpeed=30)
    assert observer.calls == [("turn_90_right", (), {}), ("move_straight", (), {"advSpeed": 30})]


def test_a_stopped_robot_refuses_all_calls():
    robot = FakeRobot()
    robot.stop()
    for ask in (
        lambda: robot.device(Base),
        lambda: robot.read(DistanceSensors),
        lambda: robot.detect("tags"),
        robot.move_straight,
    ):
        with pytest.raises(RobotStoppedError, match="can't be used any more"):
            ask()


# Skills.


def test_only_the_skills_a_program_names_are_attached():
    with FakeRobot(skills=["turn"]) as robot:
        assert "turn" in vars(robot)
        assert "move_straight" not in vars(robot)


def test_a_skill_may_call_one_that_the_program_does_not_name():
    with FakeRobot(skills=[]) as robot:
        robot.move_straight(30)
        assert robot.commands[-1] == ("Base.move", 30.0, 0.0)


def test_an_unknown_skill_name_is_left_out():
    with FakeRobot(skills=["no_such_skill"]) as robot:
        assert not hasattr(robot, "no_such_skill")


def test_a_misspelt_skill_gets_a_suggestion():
    with FakeRobot() as robot, pytest.raises(RobotAttributeError) as caught:
        robot.move_strait()
    assert caught.value.phrase == Phrase(
        "robot-unknown-skill-like", name="move_strait", suggestion="move_straight"
    )


def test_a_skill_keeps_its_name_and_its_help():
    with FakeRobot() as robot:
        assert robot.turn.__name__ == "turn"
        assert robot.turn.__doc__


# Readings and time.


class Angle(Client):
    sensing_period = 3600.0

    def connect(self):
        self.angle = 90.0
        self.add(Gyroscope(lambda: self.angle, self.reset))

    def reset(self):
        self.angle = 0.0


def test_a_reset_gyroscope_reads_0_at_once_even_while_it_is_polled():
    with Angle(skills=[]) as robot:
        assert robot.read(Gyroscope) == 90.0
        robot.device(Gyroscope).reset()
        robot.forget_readings()
        assert robot.read(Gyroscope) == 0.0


def test_sensors_are_polled_only_on_a_wall_clock():
    with Angle(skills=[]) as wall, Angle(skills=[], clock=VirtualClock()) as virtual:
        assert isinstance(wall._readings, PolledReadings)
        assert not isinstance(virtual._readings, PolledReadings)


def test_a_sensing_period_of_none_reads_on_demand():
    class Direct(Angle):
        sensing_period = None

    with Direct(skills=[]) as robot:
        assert not isinstance(robot._readings, PolledReadings)


class PricedClock(VirtualClock):
    charges = 0

    def charge(self):
        self.charges += 1


def test_using_devices_and_reading_the_time_takes_time():
    clock = PricedClock()
    with Logging(clock=clock) as robot:
        robot.device(Base, "0")
        robot.read(DistanceSensors)
        robot.time()
        assert clock.charges == 3


def test_time_stops_within_a_snapshot():
    clock = PricedClock()
    with Logging(clock=clock) as robot, robot._snapshot():
        robot.read(DistanceSensors)
        assert clock.charges == 0


def test_asking_for_the_time_of_an_event_takes_time_and_showing_it_does_not():
    clock = PricedClock()
    with Logging(clock=clock) as robot:
        event = robot.when(bool)
        event.activate()
        robot.when_states()
        assert clock.charges == 0
        assert event.time == 0
        assert clock.charges == 1


class Watchful(Client):
    """A robot whose front is free, and whose camera sees nothing."""

    def connect(self):
        self.add(Base(move=lambda adv, rot: None))
        self.add(DistanceSensors(read=lambda: {"front": [500.0], "left": [500.0]}))
        self.add(Camera(read=lambda: None, detect=lambda _: ()))


@pytest.mark.parametrize(
    ("ask", "turns"),
    [
        (lambda robot: robot.is_front_obstacle(), 50),
        (lambda robot: robot.is_front_obstacle(1) or robot.is_left_obstacle(), 50),
        (lambda robot: robot.read(DistanceSensors), 50),
        (lambda robot: robot.get_pose(), 50),
        (lambda robot: robot.get_heading(), 50),
        (lambda robot: robot.is_any_tag(), 20),
        (lambda robot: robot.is_key_pressed("up"), 50),
    ],
)
def test_a_loop_that_only_asks_turns_as_often_as_there_is_something_new(ask, turns):
    with Watchful(clock=VirtualClock()) as robot:
        for _ in range(turns):
            ask(robot)
        assert robot.time() == pytest.approx(1 - 1 / turns)


def test_a_skill_that_reads_several_times_is_one_question():
    def look_around(robot):
        return [robot.is_front_obstacle() for _ in range(3)]

    with Watchful(clock=VirtualClock()) as robot:
        robot.learn(look_around)
        robot.look_around()
        assert robot.time() == 0


def test_the_body_of_a_when_may_ask_what_its_condition_has_asked():
    times = []
    with Watchful(clock=VirtualClock()) as robot:

        @robot.when(lambda: not robot.is_any_tag())
        def count():
            times.append(robot.time())
            robot.is_any_tag()
            if len(times) == 3:
                robot.stop()

        robot.run()
    assert times == pytest.approx([0, 0.02, 0.04])


def test_a_robot_describes_itself():
    with Logging() as robot:
        assert repr(robot).endswith("Logging connected: Base:0>")
    assert "Logging stopped" in repr(robot)


def test_hosted_passes_the_programs_arguments_to_the_robot():
    with Logging.hosted({"bases": 2}, {"world": "line"}) as robot:
        assert len(list(robot.devices())) == 2


def test_a_robot_without_hardware_takes_no_time(monkeypatch):
    monkeypatch.setattr(time, "sleep", lambda _: pytest.fail("it waits"))
    with FakeRobot() as robot:
        robot.turn_90_right()
        assert robot.time() > 0


def test_a_slow_detector_does_not_delay_a_distance_sensor():
    looking, read_on, free = threading.Event(), threading.Event(), threading.Event()
    looks, distances = [], []

    class Watching(Client):
        sensing_period = 0.001

        def connect(self):
            self.add(Camera(read=lambda: None, detect=self.think))
            self.add(DistanceSensors(read=self.measure))

        def think(self, name):
            looks.append(name)
            if len(looks) > 1:
                looking.set()
                free.wait(10)
            return ()

        def measure(self):
            if looking.is_set():
                distances.append(len(distances))
                if len(distances) == 5:
                    read_on.set()
            return {"front": [len(distances)]}

    with Watching() as robot:
        robot.is_there_face()
        robot.is_front_obstacle()
        assert looking.wait(5)
        assert read_on.wait(5)
        # A program that requests detections does not wait either.
        assert not robot.is_there_face()
        free.set()
