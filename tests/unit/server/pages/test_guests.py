"""A guest's program drives a robot of the host's project, as a class asks for it."""

import pytest

from pages import serving

pytestmark = pytest.mark.realtime

#: The robots of the host's project; the second is the guest's.
FIRST, SECOND = "game", "sim-thymio"
STAY = "main:\n    function.sleep(0.2)\nend\n"
DRIVE = (
    "main:\n    function.move_straight(40)\n    function.sleep(1)\n    function.stop_bot()\nend\n"
)
KEY = (
    'main:\n    while not function.is_key_pressed("up"):\n        function.sleep(0.1)\n'
    "    end\nend\n"
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
        page.open("game", STAY, world="empty", robot="sim-thymio")
        page.say("AddTab", robot="sim-thymio")
        page.hear("TabOpened")
        page.hear("Document")
        page.type(STAY)
        page.say("SetSpeed", factor=None)
        yield page


@pytest.fixture
def guest(pupil, host):
    """The page of a guest, who drives the second robot."""
    host.say("FindGuestRobot")
    found = host.hear("GuestRobot")
    assert found == {"kind": "GuestRobot", "project": "game", "tab": SECOND}
    with pupil.visit(at="ws?seat", max_queue=None) as page:
        page.say("Open", name=found["project"], tab=found["tab"])
        page.hear("Opened", tab=SECOND)
        yield page


def take(page, text, **options):
    page.say("TakeGuest", name="Ben", program={"text": text, **options})
    return page.hear("GuestTaken").get("fits", False)


def distance(page):
    """How far the robot of a page drove in a run that the host has started."""
    while (ended := page.hear("Ended")).get("others"):
        pass
    return ended["distance"]


def test_the_guests_program_runs_on_the_second_robot_until_the_guest_leaves(pupil, host, guest):
    assert take(guest, DRIVE)
    host.say("Run")
    assert distance(guest) > 20
    # The host's own program of that robot is as before.
    assert host.pulse()
    host.say("OpenTab", name=SECOND)
    assert host.hear("Document")["blocktext"] == STAY
    guest.socket.close()
    host.pulse()
    host.run()
    while host.last["Ended"]["distance"] != 0:
        host.hear("Ended")


@pytest.mark.parametrize("tab", [FIRST, SECOND])
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


@pytest.mark.parametrize("program", ["main:\n    functio.sleep(1)\nend\n", "x("])
def test_a_program_that_cannot_run_is_not_taken(host, guest, program):
    assert not take(guest, program)
    assert not take(guest, program, is_python=True)
    assert host.run()["ended"] == "finished"


def test_a_guest_whose_robot_is_closed_drives_no_other(host, guest):
    host.say("CloseTab", name=SECOND)
    guest.hear("TabOpened", tab="")
    assert not take(guest, DRIVE)


def test_each_player_has_keys_of_their_own(host, guest):
    host.type(KEY)
    assert take(guest, KEY)
    host.say("OpenTab", name=FIRST)
    host.hear("TabOpened")
    host.hear("Document")
    host.type(KEY, shown=2)
    host.say("Run")
    guest.hear("KeysWanted", programs=2)
    guest.say("HoldKeys", keys=["up"])
    # The guest's program ends while the host's still waits for its key.
    assert guest.hear("Ended")["others"]
    host.say("HoldKeys", keys=["up"])
    host.hear("RunState", state="ended")


def test_a_link_claims_nothing_about_a_run_with_a_guest(host, guest):
    assert take(guest, DRIVE)
    host.run()
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
