"""Two pupils of a class in one world, each from a page of their own, against real servers."""

from contextlib import contextmanager

import pytest
from websockets.exceptions import ConnectionClosed

from learnblock.classroom.rights import TO_GUEST
from pages import english

pytestmark = [pytest.mark.realtime, pytest.mark.slow]

STAY = "main:\n    function.sleep(0.2)\nend\n"
DRIVE = "main:\n    function.move_straight(40)\n    function.sleep(1)\nend\n"


@pytest.fixture(scope="module")
def ana(room):
    """Who invites."""
    return room.pupil("Ana")


@pytest.fixture(scope="module")
def ben(room):
    """Who is invited."""
    return room.pupil("Ben")


@pytest.fixture
def wall(room):
    """The teacher lets pupils share worlds."""
    with room.wall() as wall:
        wall.say("LetShareWorlds", on=True)
        wall.hear("Wall", sharing=True)
        yield wall
        wall.say("LetShareWorlds", on=False)
        while wall.hear("Wall").get("sharing"):
            pass


@contextmanager
def hosting(pupil):
    """A host's page, with two robots that stay where they are."""
    with pupil.page() as page:
        page.open("game", STAY, world="empty", robot="sim-thymio")
        page.say("AddTab", robot="sim-thymio")
        page.hear("TabOpened")
        page.hear("Document")
        page.type(STAY)
        page.say("SetSpeed", factor=None)
        yield page


@pytest.fixture
def host(ana):
    """The host's page."""
    with hosting(ana) as page:
        yield page


@pytest.fixture
def guest(ben):
    """The guest's page with a program of the guest's own."""
    with ben.page() as page:
        page.open("mine", DRIVE, robot="sim-thymio")
        yield page


@contextmanager
def world_of(guest, cookie=None):
    """The page on which a guest sees the world."""
    path = f"/p/guest-{guest.id}/ws"
    with guest.room.socket(path, guest.cookie if cookie is None else cookie) as page:
        yield page


def hear_pair(page, state, **values):
    """Wait until a page says that the pupil is in this state."""
    while (news := page.hear("InPair")).get("state", "alone") != state or not (
        values.items() <= news.items()
    ):
        pass
    return news


def noted(page, code):
    while (message := page.hear("Noted")["message"])["code"] != code:
        pass
    return english(message)


def refused(page, code, kind="Invite"):
    failed = page.hear("Failed", refused=kind)
    assert failed["message"]["code"] == code
    return english(failed["message"])


def play(host, guest, ben):
    """Invite and accept."""
    host.say("Invite", pupil=ben.id)
    hear_pair(guest, "invited", other="Ana", robot="sim-thymio")
    guest.say("AnswerInvitation", on=True)
    hear_pair(host, "host", other="Ben", away=True)
    return hear_pair(guest, "guest", other="Ana")


@pytest.mark.timeout(120)
def test_both_programs_run_in_the_hosts_world_which_the_guest_sees(wall, host, guest, ben):
    host.say("AskClassmates")
    assert host.hear("Classmates")["pupils"] == [{"id": ben.id, "name": "Ben"}]
    play(host, guest, ben)
    host.say("Run")
    assert refused(host, "class-pair-away", "Run").startswith("Ben's page does not show")
    with world_of(ben) as world:
        assert world.hear("Welcome")["worlds"] == []
        assert world.hear("Opened", name="game", tab="sim-thymio")["robot"] == "sim-thymio"
        world.hear("Scene")
        hear_pair(host, "host", other="Ben")
        host.run()
        while (ended := world.hear("Ended")).get("others"):
            pass
        assert ended["distance"] > 20
        # What the guest changes counts from the next run on.
        guest.type(STAY)
        host.run()
        while (ended := world.hear("Ended")).get("others"):
            pass
        assert ended["distance"] == 0
        assert world.heard.keys() <= TO_GUEST
        world.say("Run", request=3)
        assert world.hear("Failed", request=3)["message"]["code"] == "class-pair-only-keys"
        world.say("EditText", edit=1, notation="python", text="")
        guest.type("main:\n    functio.sleep(1)\nend\n")
        host.say("Run")
        refused(host, "class-pair-mistakes", "Run")
        assert "Ana" in noted(guest, "class-pair-mistakes-own")
        guest.say("LeaveWorld")
        assert noted(host, "class-pair-left") == "Ben no longer plays with you."
        with pytest.raises(ConnectionClosed) as closed:
            world.hear("Nothing")
    assert closed.value.rcvd.code == 4403
    hear_pair(guest, "alone")
    # The host's own second program is as it was.
    host.say("OpenTab", name="sim-thymio")
    assert host.hear("Document")["blocktext"] == STAY
    assert host.run()["ended"] == "finished"


def test_nothing_is_shared_until_the_teacher_allows_it(room, host, guest, ben):
    host.say("AskClassmates")
    refused(host, "class-pair-off", "AskClassmates")
    host.say("Invite", pupil=ben.id)
    refused(host, "class-pair-off")
    guest.say("AnswerInvitation", on=True)
    refused(guest, "class-pair-off", "AnswerInvitation")
    with world_of(ben) as world, pytest.raises(ConnectionClosed) as closed:
        world.hear("Welcome")
    assert closed.value.rcvd.code == 4403
    assert room.ask(f"/p/guest-{ben.id}/", cookie=ben.cookie).status == 403


def test_a_pupil_shows_a_project_to_the_teacher_and_a_copy_to_a_classmate(
    wall, host, guest, ana, ben
):
    project = host.last["Opened"]["name"]
    hear_seat(wall, ana, project=project)
    host.say("ShowTeacher")
    hear_seat(wall, ana, shows=project)
    with ana.page(ana.room.teacher()):
        assert noted(host, "class-show-seen") == f"Your teacher is looking at “{project}”."
    hear_seat(wall, ana, shows="")
    host.say("MakeLink", request=1)
    link = host.hear("ShareLink")["link"]
    host.say("ShowClassmate", pupil=ben.id, link=link)
    refused(host, "class-show-off", "ShowClassmate")
    wall.say("LetShowPrograms", on=True)
    host.hear("ProgramOffers", allowed=True)
    for wrong in ({"pupil": "../../etc", "link": link}, {"pupil": ben.id, "link": "A" * 8001}):
        host.say("ShowClassmate", **wrong)
        refused(host, "server-message-unknown", "ShowClassmate")
    host.say("ShowClassmate", pupil=ben.id, link=link)
    shown = {"pupil": ana.id, "classmate": ben.id, "project": project}
    assert wall.hear("Wall", shown=[shown])["showing"]
    guest.hear("ProgramOffers", offers=[{"pupil": ana.id, "name": "Ana", "project": project}])
    own = guest.last["Opened"]["name"]
    guest.say("AnswerOffer", pupil=ana.id, on=True)
    guest.hear("Opened", name=project)
    guest.hear("RunState", state="idle")
    assert noted(host, "class-show-opened") == f"Ben has opened a copy of “{project}”."
    guest.say("ListProjects")
    # Nothing runs by itself, and what the classmate had is still there.
    assert {own, project} <= {one["name"] for one in guest.hear("Projects")["projects"]}
    assert guest.last["RunState"]["state"] == "idle"


def hear_seat(wall, pupil, **values):
    """Wait until the wall shows this of a pupil."""
    while not any(
        seat["id"] == pupil.id and values.items() <= {"shows": "", **seat}.items()
        for seat in wall.hear("Seats")["seats"]
    ):
        pass


# Also claimed, without servers, in `test_pairs.py`.
@pytest.mark.exhaustive
@pytest.mark.timeout(120)
def test_the_teacher_ends_it_in_the_middle(wall, host, guest, ben):
    play(host, guest, ben)
    with world_of(ben) as world:
        world.hear("Scene")
        wall.say("LetShareWorlds", on=False)
        for page in (host, guest):
            noted(page, "class-pair-over")
            hear_pair(page, "alone")
        with pytest.raises(ConnectionClosed) as closed:
            world.hear("Nothing")
    assert closed.value.rcvd.code == 4403
    assert host.run()["ended"] == "finished"


@pytest.mark.timeout(120)
def test_a_guest_comes_back_after_a_lost_connection_and_nobody_else_sees_the_world(
    wall, host, guest, ben
):
    room = ben.room
    play(host, guest, ben)
    for cookie in (room.teacher(), "", room.pupil("Eva").cookie):
        with world_of(ben, cookie) as world, pytest.raises(ConnectionClosed) as closed:
            world.hear("Welcome")
        assert closed.value.rcvd.code == 4403
    with world_of(ben) as world:
        world.hear("Scene")
    hear_pair(host, "host", away=True)
    with world_of(ben) as first, world_of(ben) as world:
        world.hear("Scene")
        with pytest.raises(ConnectionClosed) as closed:
            first.hear("Nothing")
        assert closed.value.rcvd.code == 4429
        # A new name of the project keeps it open for the guest.
        host.say("RenameProject", name="other")
        host.hear("ProjectRenamed")
    hear_pair(host, "host", away=True)
    with world_of(ben) as world:
        assert world.hear("Opened")["name"] == "other"
        host.run()
        host.say("LeaveWorld")
        assert noted(guest, "class-pair-left") == "Ana no longer plays with you."


@pytest.fixture
def dan(room):
    """Who has invited nobody yet: invitations have a pace."""
    return room.pupil("Dan")


@pytest.fixture
def dans(dan):
    """Dan's page."""
    with hosting(dan) as page:
        yield page


# Also claimed, without servers, in `test_pairs.py`.
@pytest.mark.exhaustive
def test_invitations_that_cannot_be_made(wall, guest, dan, dans, ben):
    host = dans
    for pupil in (dan.id, "aaaaaaaaaa"):
        host.say("Invite", pupil=pupil)
        refused(host, "class-classmate-away")
    host.say("Invite", pupil="../../etc")
    assert host.hear("Failed", refused="Invite")["message"]["code"] == "server-message-unknown"
    host.say("Invite", pupil=ben.id)
    hear_pair(guest, "invited")
    host.say("Invite", pupil=ben.id)
    refused(host, "class-pair-already")
    guest.say("AnswerInvitation", on=False)
    assert noted(host, "class-pair-declined") == "Ben does not want to play now."
    host.say("Invite", pupil=ben.id)
    refused(host, "class-classmate-declined")
    guest.say("AnswerInvitation", on=True)
    refused(guest, "class-pair-no-invitation", "AnswerInvitation")
    guest.say("Invite", pupil=dan.id)
    refused(guest, "class-pair-one-robot")
