"""A guest's program drives a robot of the host's project, as a class asks for it."""

import io
from contextlib import contextmanager
from types import SimpleNamespace

import pytest

from learnblock.running import team
from learnblock.running.recorded_keys import read_keys_of
from learnblock.running.team import TeamRun
from learnblock.runtime.inline import InlineWorker
from pages import serving
from runs import Presser

pytestmark = pytest.mark.realtime

#: The robots of the host's project; the second is the guest's.
FIRST, SECOND = "game", "sim-thymio"
STAY = "main:\n    function.sleep(0.2)\nend\n"
DRIVE = (
    "main:\n    function.move_straight(40)\n    function.sleep(1)\n    function.stop_bot()\nend\n"
)
#: Drives once the key is held.
KEY = (
    'main:\n    while not function.is_key_pressed("up"):\n        function.sleep(0.1)\n'
    "    end\n    function.move_straight(40)\n    function.sleep(1)\nend\n"
)


@pytest.fixture
def pupil(projects):
    """A pupil's own server, as in a class."""
    with serving(projects, static=projects.parent / "static", for_one=True) as running:
        yield running


@pytest.fixture
def host(pupil):
    """The host's page, with two robots that stay where they are."""
    with pupil.visit(at="ws?seat", max_queue=None) as page:
        page.open(FIRST, STAY, world="empty", robot="sim-thymio")
        page.say("AddTab", robot="sim-thymio")
        page.hear("TabOpened")
        page.hear("Document")
        page.type(STAY)
        page.say("SetSpeed", factor=None)
        yield page


@contextmanager
def seated(pupil):
    """A page of a guest, who drives the second robot."""
    with pupil.visit(at="ws?seat", max_queue=None) as page:
        page.say("Open", name=FIRST, tab=SECOND)
        page.say("KeepKeysApart")
        page.hear("Opened", tab=SECOND)
        yield page


@pytest.fixture
def guest(pupil, host):
    """The page of a guest."""
    host.say("FindGuestRobot")
    assert host.hear("GuestRobot") == {"kind": "GuestRobot", "project": FIRST, "tab": SECOND}
    with seated(pupil) as page:
        yield page


@pytest.fixture
def recorded(monkeypatch):
    """The jobs of a run of several robots, and its trace."""
    kept = SimpleNamespace(jobs={}, trace=io.BytesIO())

    def record(jobs, **options):
        kept.jobs = jobs
        return TeamRun(jobs, trace=kept.trace, **options)

    monkeypatch.setattr(team, "TeamRun", record)
    return kept


def take(page, text, **options):
    page.say("TakeGuest", name="Ben", program={"text": text, **options})
    return page.hear("GuestTaken").get("fits", False)


def end_of_run(page):
    """How a run ends for the robot of a page, and no program of it runs any more."""
    while (ended := page.hear("Ended")).get("others"):
        pass
    return ended


def until(page, seconds):
    """Wait for a time of the robots' world."""
    while page.hear("Telemetry").get("time", 0) < seconds:
        pass


def run_until_keys(host, guest):
    """Let both programs wait for a key."""
    assert take(guest, KEY)
    host.say("OpenTab", name=FIRST)
    host.hear("TabOpened")
    host.hear("Document")
    host.type(KEY, shown=2)
    host.say("Run")
    host.hear("KeysWanted", programs=2)


def test_the_guests_program_runs_on_the_second_robot_until_the_guest_leaves(pupil, host, guest):
    assert take(guest, DRIVE)
    host.say("Run")
    assert end_of_run(guest)["distance"] > 20
    # The host's own program of that robot is as before.
    assert host.pulse()
    host.say("OpenTab", name=SECOND)
    assert host.hear("Document")["blocktext"] == STAY
    guest.socket.close()
    host.pulse()
    host.run()
    while host.last["Ended"]["distance"] != 0:
        host.hear("Ended")


@pytest.mark.parametrize("tab", [pytest.param(FIRST, marks=pytest.mark.exhaustive), SECOND])
def test_the_host_sees_nothing_of_the_guests_program(host, guest, tab):
    assert (
        take(guest, "main:\n    secret = 7\n    function.sleep(0.3)\n    x = nothing\nend\n")
        is False
    )
    assert take(guest, "main:\n    secret = 7\n    function.sleep(0.3)\nend\n")
    host.say("OpenTab", name=tab)
    host.hear("TabOpened")
    host.say("Run")
    seen = []
    while not seen or seen[-1] != {"kind": "RunState", "state": "ended", "speed": None}:
        seen.append(host.next())
    assert "secret" not in str(seen)
    if tab == SECOND:
        assert {one.get("line") for one in seen if one["kind"] == "RunningLine"} <= {0}
        host.say("LookBack", time=0.1)
        assert host.hear("Failed")["message"]["code"] == "play-nothing-to-look-back-at"


def test_a_program_that_cannot_run_is_not_taken(host, guest):
    for program in ("main:\n    functio.sleep(1)\nend\n", "x("):
        assert not take(guest, program)
        assert not take(guest, program, is_python=True)
    assert host.run()["ended"] == "finished"


def test_a_guest_whose_robot_is_closed_drives_no_other(host, guest):
    host.say("CloseTab", name=SECOND)
    guest.hear("TabOpened", tab="")
    assert not take(guest, DRIVE)


def test_a_guest_who_leaves_during_a_run_leaves_the_robot_to_nobody(pupil, host, guest):
    run_until_keys(host, guest)
    guest.socket.close()
    host.pulse()
    host.say("HoldKeys", keys=["up"])
    ended = host.hear("Ended")
    assert ended["others"]
    # The guest's program goes on, and still waits for its key.
    until(host, ended["time"] + 5)
    with seated(pupil) as again:
        again.say("HoldKeys", keys=["up"])
        assert end_of_run(again)["distance"] > 20


@pytest.mark.certain
def test_each_player_has_keys_of_their_own_from_which_the_run_is_repeated(
    host, guest, recorded, tmp_path
):
    run_until_keys(host, guest)
    until(guest, 0.5)
    guest.say("HoldKeys", keys=["up"])
    # The guest's program ends while the host's still waits for its key.
    assert guest.hear("Ended")["others"]
    host.say("HoldKeys", keys=["up"])
    sha256 = end_of_run(guest)["trace_sha256"]
    path = tmp_path / "trace.jsonl"
    path.write_bytes(recorded.trace.getvalue())
    keys = read_keys_of(path, [FIRST, SECOND])
    [(later, own)], [(sooner, guests)] = keys[FIRST].changes, keys[SECOND].changes
    assert own == guests == ("up",)
    # A second is the least for which the guest drives.
    assert 0.4 < sooner < later - 1

    again = TeamRun(recorded.jobs, watch=lambda name: Presser(keys[name]), worker=InlineWorker)
    assert again.run().trace_sha256 == sha256


@pytest.mark.certain
def test_the_same_programs_give_the_same_run_of_which_a_link_claims_nothing(host, guest):
    hashes = []
    for _ in range(2):
        assert take(guest, DRIVE)
        host.say("Run")
        hashes.append(end_of_run(guest)["trace_sha256"])
        host.hear("RunState", state="ended")
    assert hashes[0] == hashes[1] != ""
    host.say("MakeLink")
    assert host.hear("ShareLink")["problem"]["code"] == "share-no-run-person"


@pytest.mark.parametrize("opens", [False, True])
def test_a_project_without_a_second_robot_has_none_for_a_guest(pupil, opens):
    with pupil.visit(at="ws?seat", max_queue=None) as page:
        if opens:
            page.open("alone", STAY)
        page.say("FindGuestRobot")
        assert page.hear("GuestRobot")["lack"] == ("robot" if opens else "project")


def test_a_lesson_has_no_robot_for_a_guest(pupil):
    with pupil.visit(at="ws?seat", max_queue=None) as page:
        page.say("StartLesson", lesson="1-01-first-drive", name="First drive")
        page.hear("LessonShown")
        page.say("FindGuestRobot")
        assert page.hear("GuestRobot")["lack"] == "lesson"


def test_a_page_gives_the_program_that_it_shows(pupil):
    with pupil.visit(at="ws?seat", max_queue=None) as page:
        page.say("GiveProgram")
        assert page.hear("ProgramGiven") == {"kind": "ProgramGiven"}
        page.open("mine", DRIVE)
        page.say("GiveProgram")
        assert page.hear("ProgramGiven")["program"] == {"text": DRIVE}
        page.type("main:\n    functio.sleep(1)\nend\n")
        page.say("GiveProgram")
        assert page.hear("ProgramGiven")["mistakes"]


def test_only_a_class_has_guests(projects):
    with serving(projects, static=projects.parent / "static") as running, running.visit() as page:
        page.open("game", STAY)
        page.say("FindGuestRobot")
        assert page.hear("Failed")["message"]["code"] == "server-only-in-class"
