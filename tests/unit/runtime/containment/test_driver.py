"""What a program can do through its robot's driver, in the host's own thread."""

import os
import signal
import socket
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

import pytest

import tempted
from attacks import COMPLETE, prepare
from learnblock import robots
from learnblock.client import Rights
from learnblock.errors import LearnBlockError, RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.runtime.containment import landlock, seccomp
from learnblock.runtime.containment.driver import OwnThread, end_threads, give_up, in_own_thread
from learnblock.runtime.escalation import Measure
from learnblock.runtime.limits import Limits
from tempted import CONNECTING, COPYING, STARTING, WRITING, tempt
from waiting import SECONDS

pytestmark = [
    pytest.mark.realtime,
    pytest.mark.certain,
    pytest.mark.skipif(sys.platform != "linux", reason="Landlock and seccomp are Linux's"),
]
complete = pytest.mark.skipif(not COMPLETE, reason="needs Linux 6.12 on x86-64")

NOTHING = Rights()


@pytest.fixture
def others(tmp_path, monkeypatch):
    """A folder with the user's files."""
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    folder = prepare(tmp_path)[0]
    (folder / "bare").mkdir()
    return folder


def got_in(results):
    return [name for name, result in results.items() if result == "IN"]


@complete
@pytest.mark.parametrize("attempts", [WRITING, STARTING, COPYING, CONNECTING])
def test_a_driver_without_rights_can_be_tempted_to_nothing(others, attempts):
    results = tempt(attempts, others, NOTHING)
    assert dict.fromkeys(attempts, "PermissionError") == results


@complete
def test_the_same_attempts_are_not_refused_without_a_fence(others, monkeypatch):
    monkeypatch.setattr("learnblock.running.program_run.give_up", lambda rights: None)
    results = tempt({**WRITING, **STARTING, **CONNECTING}, others, NOTHING)
    assert "PermissionError" not in results.values()
    assert {*WRITING} - {"change a file's attributes"} <= {*got_in(results)}


@complete
def test_a_driver_with_every_right_still_cannot_write(others):
    rights = Rights(network=True, programs=True, devices=("/dev/*",))
    assert got_in(tempt(WRITING, others, rights)) == []


@complete
def test_a_driver_reaches_the_network_if_it_needs_it(others):
    attempts = {"be a server": CONNECTING["be a server"], **STARTING}
    assert got_in(tempt(attempts, others, Rights(network=True))) == ["be a server"]


@complete
def test_a_driver_starts_programs_if_it_needs_them_but_they_cannot_write(others):
    attempts = {
        "speak": "subprocess.run(['true'], check=True)",
        "write by a program": (
            "if subprocess.run(['touch', FOLDER + '/new.txt']).returncode: raise PermissionError"
        ),
        "connect by a program": (
            f"if subprocess.run([{sys.executable!r}, '-Ic', 'import socket; socket.socket()'],"
            " stderr=subprocess.DEVNULL).returncode: raise PermissionError"
        ),
    }
    assert got_in(tempt(attempts, others, Rights(programs=True))) == ["speak"]


@complete
def test_a_driver_opens_the_devices_that_it_needs_and_no_others(others):
    ours, slave = os.openpty()
    name = os.ttyname(slave)
    attempts = {
        "its port": f"import tty\ntty.setraw(os.open({name!r}, os.O_RDWR | os.O_NOCTTY))",
        "another": "os.openpty()",
    }
    try:
        assert got_in(tempt(attempts, others, Rights(devices=(name,)))) == ["its port"]
        assert got_in(tempt(attempts, others, NOTHING)) == []
    finally:
        os.close(ours)
        os.close(slave)


@complete
def test_a_pattern_of_devices_never_allows_a_plain_file(others):
    attempts = {"a file": "open(FOLDER + '/emptied.txt', 'w')"}
    assert got_in(tempt(attempts, others, Rights(devices=(f"{others}/*",)))) == []


@complete
def test_a_driver_writes_in_the_folders_that_it_needs(others):
    attempts = {
        "a file": "open(FOLDER + '/empty/calibration.txt', 'w').close()",
        "a pipe": "os.mkfifo(FOLDER + '/empty/pipe')",
        "its rights": "os.chmod(FOLDER + '/empty/pipe', 0o600)",
        "a file elsewhere": "open(FOLDER + '/new.txt', 'w')",
    }
    rights = Rights(folders=(f"{others}/empty",))
    assert got_in(tempt(attempts, others, rights)) == ["a file", "a pipe", "its rights"]


def test_the_thread_that_waits_for_the_run_keeps_its_rights(others):
    tempt({}, others, NOTHING)
    (others / "new.txt").write_text("")
    assert subprocess.run(["true"], check=False).returncode == 0
    socket.socket().close()


def test_the_program_itself_is_limited_as_before(others):
    tempted.Robot.rights = NOTHING
    source = (
        "files = []\nfor i in range(9):\n    files.append(open(str(i), 'wb'))\n"
        "    files[-1].write(bytes(10**7))\n    files[-1].flush()\n    os.unlink(str(i))\n"
        "while True: pass"
    )
    report = tempted.run(f"import os\n{source}", limits=Limits(silence=30))
    assert report.error["message"].code == "run-too-much-disk"


def test_the_programs_temporary_folder_is_removed_after_the_run(others, monkeypatch):
    made = []
    make = tempfile.mkdtemp
    monkeypatch.setattr(tempfile, "mkdtemp", lambda **named: made.append(make(**named)) or made[-1])
    tempt({}, others, NOTHING)
    assert [Path(folder).exists() for folder in made] == [False]


@complete
def test_many_robots_in_one_run_are_one_fence(others):
    # Landlock allows sixteen layers.
    again = "robot.stop()\nrobot = Robot()\n" * 20
    tempted.Robot.rights, tempted.Robot.results = NOTHING, {}
    report = tempted.run(f'{again}robot.say_Text(\'write\\nopen("/dev/shm/new", "w")\')')
    assert (report.error, tempted.Robot.results) == (None, {"write": "PermissionError"})


@pytest.mark.parametrize("broken", ["version", "call"])
def test_a_robot_works_where_the_kernel_refuses_the_fence(others, monkeypatch, broken):
    def refuse(*_):
        raise OSError(1, "Operation not permitted")

    monkeypatch.setattr(landlock, "version", lambda: 0) if broken == "version" else None
    monkeypatch.setattr(seccomp, "is_supported", lambda: broken != "version")
    monkeypatch.setattr("learnblock.runtime.containment.kernel.prctl", refuse)
    assert got_in(tempt({"write": WRITING["make a file"]}, others, NOTHING)) == ["write"]


def test_an_author_learns_that_the_fence_refused_the_driver(others, monkeypatch):
    def write(self):
        (others / "new.txt").write_text("")

    monkeypatch.setattr(tempted.Robot, "connect", write)
    tempted.Robot.rights = NOTHING
    reason = Phrase(f"PermissionError: [Errno 13] Permission denied: '{others / 'new.txt'}'")
    message = Phrase("run-robot-not-created", reason=Phrase("run-driver-refused", reason=reason))
    assert tempted.run("").error["message"] == message


@pytest.mark.parametrize("name", ["sim-ebo", "sim-thymio", "sim-ev3", "sim-cozmo"])
def test_a_twin_needs_no_rights(others, name):
    assert robots.find(name).load().known_rights() == NOTHING


def test_the_settings_of_perception_add_what_a_camera_needs(others):
    settings = Path(os.environ["LEARNBLOCK_HOME"]) / "settings.toml"
    settings.write_text('[perception]\nwebcam = 1\napriltag = "localhost:10000"\n')
    expected = Rights(network=True, devices=("/dev/video*",))
    assert robots.find("sim-ebo").load().known_rights() == expected


def test_a_device_of_the_users_settings_is_allowed_and_one_of_the_program_is_not(others):
    settings = Path(os.environ["LEARNBLOCK_HOME"]) / "settings.toml"
    settings.write_text('[robots.thymio]\ndevice = "/dev/robot"\n')
    robot = robots.find("thymio").load()
    assert robot.known_rights() == robot.rights | Rights(devices=("/dev/robot",))
    settings.write_text("[robots.thymio]\ntrack = 1\n")
    assert robot.known_rights() == robot.rights


def test_an_error_in_the_thread_is_raised_in_the_one_that_waits():
    def fail():
        raise RobotConnectionError("run-robot-stopped")

    with pytest.raises(RobotConnectionError):
        in_own_thread(fail)


def test_a_signal_stops_the_thread_that_is_waited_for():
    ended = threading.Event()
    finished = []

    def work():
        signal.setitimer(signal.ITIMER_REAL, 0.01)
        finished.append(ended.wait(20))

    def interrupt(number, frame):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        with pytest.raises(KeyboardInterrupt):
            in_own_thread(work, [Measure(ended.set, SECONDS)])
    finally:
        signal.signal(signal.SIGALRM, before)
    assert finished == [True]


def test_what_ends_before_it_has_begun_is_never_called():
    called = []
    thread = OwnThread(lambda: called.append(True))
    end_threads([thread], [])
    thread.start()
    assert thread.ends_within(SECONDS)
    assert called == []


def test_a_thread_that_does_not_end_is_left_behind():
    released = threading.Event()
    try:
        with pytest.raises(LearnBlockError) as caught:
            in_own_thread(lambda: released.wait(SECONDS), [Measure(bool, 0.01)], seconds=0.01)
    finally:
        released.set()
    assert caught.value.phrase.code == "run-given-up"


@complete
def test_giving_up_leaves_the_other_threads_alone(others):
    in_own_thread(lambda: give_up(NOTHING))
    (others / "new.txt").write_text("")
