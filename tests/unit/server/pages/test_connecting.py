"""Pages find real robots, connect to one of them, try it and measure it."""

import sys
import tomllib
from contextlib import contextmanager

import pytest

from learnblock.installation import Installation
from learnblock.robots import real
from learnblock.server.runs import nearby
from pages import serving
from waiting import wait_for

pytestmark = pytest.mark.realtime

#: A user's robot: wheels, a face and a speaker, which note their commands in a file.
ROBOT = """
from pathlib import Path
from threading import Event

from learnblock.client import Rights, RobotStatus
from learnblock.devices import Base, Display, DistanceSensors, Speaker
from learnblock.errors import RobotConnectionError
from learnblock.robots.calibration import Calibration
from learnblock.robots.real import RealRobot
from learnblock.robots.settings import Address, Length, RobotSettings

FOLDER = Path({folder!r})


class Settings(RobotSettings, frozen=True):
    address: Address = "10.0.0.1"
    radius: Length = 30.0
    track: Length = 100.0


class Robot(RealRobot[Settings]):
    settings_type = Settings
    calibration = Calibration(distance="radius", angle="track")
    rights = Rights(folders=({folder!r},))

    @classmethod
    def scan(cls, seconds):
        if (FOLDER / "slow").exists():
            note("look")
            Event().wait(0.3)
            note("looked")
        if (FOLDER / "endless").exists():
            yield {{"address": "10.0.0.8"}}
            note(f"may take {{seconds:g}} s")
            Event().wait()
        if (FOLDER / "on").exists():
            yield {{"address": "10.0.0.7"}}

    def connect(self):
        if not (FOLDER / "on").exists():
            raise RobotConnectionError("cozmo-no-answer", place=self.settings.address)
        self.note(f"connect {{self.settings.address}}")
        self.add(Base(lambda adv, rot: self.note(f"move {{adv:g}} {{rot:g}}")))
        self.add(DistanceSensors(lambda: {{"front": [123.0]}}))
        self.add(Display(lambda emotion: self.note(f"show {{emotion}}")))
        self.add(Speaker(tone=lambda hertz, milliseconds: self.note("beep")))

    def status(self):
        return RobotStatus(charge=0.85, signal=-58)

    def disconnect(self):
        self.note("disconnect")

    def check_link(self):
        if not (FOLDER / "on").exists():
            raise RobotConnectionError("cozmo-silent", place="there", seconds=5)

    def note(self, line):
        note(line)


def note(line):
    with (FOLDER / "notes").open("a") as notes:
        notes.write(line + "\\n")
"""


class Robot:
    """The robot at the other end."""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir()
        self.switch_on()

    def hang_after_the_first(self):
        (self.folder / "endless").touch()

    def switch_on(self):
        (self.folder / "on").touch()

    def switch_off(self):
        (self.folder / "on").unlink()

    def answer_slowly(self):
        (self.folder / "slow").touch()

    @property
    def notes(self):
        notes = self.folder / "notes"
        return notes.read_text().splitlines() if notes.exists() else []

    def await_note(self, note):
        wait_for(lambda: note in self.notes, note)


@pytest.fixture
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "home" / "robots").mkdir(parents=True)
    return tmp_path / "home"


@pytest.fixture
def robot(tmp_path, home):
    folder = tmp_path / "robot"
    (home / "robots" / "mine.py").write_text(ROBOT.format(folder=str(folder)))
    return Robot(folder)


@pytest.fixture(autouse=True)
def impatient(monkeypatch):
    """Look for robots again at once."""
    monkeypatch.setattr(nearby, "AGAIN", 0.02)
    monkeypatch.setattr(nearby, "AGAIN_AFTER_FOUND", 0.02)
    monkeypatch.setattr(nearby, "LIST_AGAIN", 0.02)


@pytest.fixture
def page(robot, server):
    with opened(server) as page:
        yield page


@contextmanager
def opened(server, name="program"):
    with server.visit() as page:
        page.open(name)
        yield page


def connect(page, robot="mine"):
    page.say("ConnectRobot", id=robot)
    return page.hear("RobotConnected", state="connected")


def test_a_robot_that_answers_is_found_and_connected(page, robot):
    page.say("FindRobots", on=True)
    while not (found := found_of(page.hear("RobotsNearby"), "mine")):
        pass
    assert found[0] == {"id": "mine 10.0.0.7", "robot": "mine", "way": "wifi", "place": "10.0.0.7"}
    state = connect(page, found[0]["id"])
    assert state["actions"] == ["wheels", "face", "beep", "distance", "angle"]
    assert robot.notes[0] == "connect 10.0.0.7"


def test_a_robot_is_not_connected_while_it_is_looked_for(page, robot):
    robot.answer_slowly()
    page.say("FindRobots", on=True)
    robot.await_note("look")
    connect(page)
    assert robot.notes[:3] == ["look", "looked", "connect 10.0.0.1"]


def test_a_robot_is_shown_while_its_driver_still_looks_for_others(page, robot):
    robot.hang_after_the_first()
    page.say("FindRobots", on=True)
    while not (found := found_of(nearby := page.hear("RobotsNearby"), "mine")):
        pass
    assert found[0]["place"] == "10.0.0.8"
    assert known_of(nearby, "mine")["looking"] is True


@pytest.fixture
def lacking(monkeypatch):
    """A computer without what a Cozmo needs, where the installer installs something else."""
    monkeypatch.setattr(real, "find_spec", lambda module: None if module == "pycozmo" else module)
    words = (sys.executable, "-c", "print('Collecting pycozmo')")
    monkeypatch.setattr(Installation, "adding", lambda _, extra: (*words, extra))


def add_on_of(page, **expected):
    """The add-on that a Cozmo lacks, once the page shows it so."""
    while True:
        add_on = known_of(page.hear("RobotsNearby"), "cozmo")["add_on"]
        if expected.items() <= add_on.items():
            return add_on


@pytest.mark.usefixtures("lacking")
def test_an_add_on_is_installed_from_the_page(page):
    page.say("FindRobots", on=True)
    assert add_on_of(page)["ours"] is True
    page.say("InstallAddOn", robot="cozmo")
    assert add_on_of(page, installing=True)
    problem = add_on_of(page, problem={"code": "connect-installed-restart", "values": {}})
    assert "installing" not in problem


@pytest.mark.usefixtures("lacking")
def test_an_add_on_is_not_installed_where_others_use_the_same_packages(page, monkeypatch):
    monkeypatch.setenv("JUPYTERHUB_USER", "ada")
    page.say("FindRobots", on=True)
    assert "ours" not in add_on_of(page)
    page.say("InstallAddOn", robot="cozmo", request=1)
    assert page.hear("Failed")["message"]["code"] == "connect-not-ours-to-install"


def test_a_robot_of_the_users_own_names_no_packages_to_install(page):
    page.say("InstallAddOn", robot="mine", request=1)
    assert page.hear("Failed")["message"]["code"] == "connect-not-ours-to-install"


@pytest.mark.parametrize(("asked", "given"), [("", "2"), ("4.5", "4.5"), ("60", "5")])
def test_the_class_of_a_robot_says_how_long_a_look_may_take_five_seconds_at_most(
    page, robot, home, asked, given
):
    if asked:
        source = home / "robots" / "mine.py"
        source.write_text(
            source.read_text().replace("    rights =", f"    scan_seconds = {asked}\n    rights =")
        )
    robot.hang_after_the_first()
    page.say("FindRobots", on=True)
    robot.await_note(f"may take {given} s")


def test_a_kind_is_being_looked_for_until_its_first_look_has_ended(page, robot):
    robot.switch_off()
    page.say("FindRobots", on=True)
    assert known_of(page.hear("RobotsNearby"), "mine")["looking"] is True
    while "looking" in known_of(page.hear("RobotsNearby"), "mine"):
        pass


def test_a_robot_that_is_switched_off_disappears(page, robot):
    page.say("FindRobots", on=True)
    while not found_of(page.hear("RobotsNearby"), "mine"):
        pass
    robot.switch_off()
    while found_of(page.hear("RobotsNearby"), "mine"):
        pass


def test_a_robot_whose_file_was_mended_is_found_while_it_is_looked_for(page, robot, home):
    mended = (home / "robots" / "mine.py").read_text()
    (home / "robots" / "mine.py").write_text("from learnblock import nothing_of_this_name\n")
    page.say("FindRobots", on=True)
    while "mine" in [one["robot"] for one in page.hear("RobotsNearby")["known"]]:
        pass
    (home / "robots" / "mine.py").write_text(mended)
    while not found_of(page.hear("RobotsNearby"), "mine"):
        pass


def test_its_values_are_reported_while_it_is_connected(page):
    connect(page)
    while "sensors" not in (values := page.hear("RobotValues")):
        pass
    assert values["sensors"][0]["value"] == 123
    # As the robot says, which reports no voltage.
    assert (values["charge"], values["signal"]) == (0.85, -58)


def test_the_test_of_the_wheels_drives_forward_and_back_and_stops(page, robot):
    connect(page)
    page.say("TryRobot", action="wheels")
    page.hear("RobotConnected", doing="wheels")
    robot.await_note("move -50 0")
    assert "doing" not in page.hear("RobotConnected")
    assert [line for line in robot.notes if "move" in line][:2] == ["move 50 0", "move -50 0"]
    assert robot.notes[-1] == "move 0 0"


def test_face_and_beep_are_tried(page, robot):
    connect(page)
    page.say("TryRobot", action="beep")
    robot.await_note("beep")
    page.say("TryRobot", action="face")
    robot.await_note("show joy")


def test_stopping_halts_the_wheels_at_once(page, robot):
    connect(page)
    page.say("TryRobot", action="distance")
    robot.await_note("move 100 0")
    page.say("TryRobot", action="stop")
    robot.await_note("move 0 0")
    assert robot.notes.count("move 100 0") == 1


def test_a_page_that_goes_stops_its_robot(robot, server):
    with opened(server) as page:
        connect(page)
        page.say("TryRobot", action="angle")
        robot.await_note("move 0 60")
    robot.await_note("disconnect")
    assert robot.notes[-2:] == ["move 0 0", "disconnect"]


def test_disconnecting_stops_the_robot(page, robot):
    connect(page)
    page.say("TryRobot", action="angle")
    robot.await_note("move 0 60")
    page.say("DisconnectRobot")
    page.hear("RobotConnected", state="none")
    assert robot.notes[-2:] == ["move 0 0", "disconnect"]


def test_a_stopping_server_stops_the_robot(projects, robot):
    with serving(projects) as server, opened(server) as page:
        connect(page)
        page.say("TryRobot", action="angle")
        robot.await_note("move 0 60")
    assert robot.notes[-2:] == ["move 0 0", "disconnect"]


def test_a_lost_robot_is_said(page, robot):
    connect(page)
    robot.switch_off()
    assert page.hear("RobotConnected", state="lost")["problem"]["code"] == "cozmo-silent"


def test_a_robot_that_does_not_answer_is_said(page, robot):
    robot.switch_off()
    page.say("ConnectRobot", id="mine")
    failed = page.hear("RobotConnected", state="failed")
    assert failed["problem"]["code"] == "cozmo-no-answer"


def test_a_driver_that_crashes_is_reported_and_can_be_connected_again(page, robot, home):
    (home / "robots" / "wild.py").write_text(
        ROBOT.format(folder=str(robot.folder)).replace('self.note("beep")', "1 / 0")
    )
    connect(page, "wild")
    page.say("TryRobot", action="beep")
    lost = page.hear("RobotConnected", state="lost")
    assert "ZeroDivisionError" in str(lost["problem"])
    connect(page, "wild")


def test_another_page_cannot_take_the_robot(page, server):
    connect(page)
    with opened(server, "another") as other:
        other.say("ConnectRobot", id="mine")
        assert other.hear("Failed")["message"]["code"] == "connect-used-by-page"


def test_a_robot_on_which_a_program_runs_cannot_be_connected(page, server, robot):
    page.say("ChooseRobot", name="mine")
    page.type("main:\n    function.sleep(60)\nend\n")
    page.say("Run")
    page.hear("RunState", state="running")
    with opened(server, "another") as other:
        other.say("ConnectRobot", id="mine")
        assert other.hear("Failed")["message"]["code"] == "connect-used-by-run"


def test_a_connected_robot_is_free_for_a_program_of_its_own_page_only(page, server, robot):
    connect(page)
    with opened(server, "another") as other:
        other.say("ChooseRobot", name="mine")
        other.say("Run")
        assert other.hear("Failed")["message"]["code"] == "connect-used-by-page"
    page.say("ChooseRobot", name="mine")
    page.say("Run")
    page.hear("RobotConnected", state="none")
    page.hear("Ended", ended="finished")


def test_using_a_robot_chooses_it_and_saves_what_reaches_it(page, home):
    page.say("FindRobots", on=True)
    while not (found := found_of(page.hear("RobotsNearby"), "mine")):
        pass
    connect(page, found[0]["id"])
    page.say("UseRobot")
    assert page.hear("Settings")["robot"] == "mine"
    assert saved(home)["robots"]["mine"] == {"address": "10.0.0.7"}
    assert saved(home)["robots_used"] == {"names": ["mine"]}


def test_a_robot_gets_a_name(page, home):
    page.say("FindRobots", on=True)
    page.say("NameRobot", robot="mine", name=" Ada ")
    choices = {one["name"]: one for one in page.hear("Robots")["robots"]}
    assert choices["mine"]["given"] == "Ada"
    assert saved(home)["robots"]["mine"] == {"name": "Ada"}
    # Once more, because it may have been told already.
    page.say("FindRobots", on=True)
    while known_of(page.hear("RobotsNearby"), "mine").get("name") != "Ada":
        pass


def test_measurements_correct_the_settings(page, home, robot):
    connect(page)
    page.say("CorrectRobot", distance=450, angle=300)
    suggested = page.hear("RobotCorrected")
    assert suggested["corrections"] == [
        {"setting": "radius", "before": 30, "after": 27},
        {"setting": "track", "before": 100, "after": 108},
    ]
    assert not (home / "settings.toml").exists() or "robots" not in saved(home)
    page.say("CorrectRobot", distance=450, angle=300, save=True)
    assert page.hear("RobotCorrected")["saved"]
    page.hear("RobotConnected", state="connected")
    assert saved(home)["robots"]["mine"] == {"radius": 27, "track": 108}


@pytest.mark.parametrize(
    ("kind", "values"),
    [
        ("ConnectRobot", {"id": "sim-ebo"}),
        ("ConnectRobot", {"id": "../../etc/passwd"}),
        ("ConnectRobot", {"id": ""}),
        ("TryRobot", {"action": "explode"}),
        ("TryRobot", {"action": "wheels"}),
        ("CorrectRobot", {"distance": 0}),
        ("CorrectRobot", {"angle": 1e9}),
        ("NameRobot", {"robot": "mine", "name": "x" * 41}),
        ("UseRobot", {}),
    ],
)
def test_what_makes_no_sense_is_refused(page, kind, values):
    page.say(kind, **values)
    assert page.hear("Failed")


def found_of(nearby, robot):
    return [one for one in nearby.get("found", []) if one["robot"] == robot]


def known_of(nearby, robot):
    return next(one for one in nearby["known"] if one["robot"] == robot)


def saved(home):
    return tomllib.loads((home / "settings.toml").read_text())
