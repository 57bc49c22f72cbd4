"""Users of a real JupyterHub, behind its real proxy, each with a LearnBlock of their own."""

import os
import re
import signal
import sys

import httpx
import pytest
from websockets.exceptions import InvalidStatus

import hubs
from waiting import wait_for

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform != "linux", reason="looks for processes in /proc"),
]

DRIVES = "main:\n    function.move_straight(40)\n    function.sleep(0.5)\nend\n"
#: What a page asks for, with a project named "mine".
REQUESTS = (
    "",
    "palette/en.json",
    "icon.svg",
    "projects/mine/picture.jpg",
    "projects/mine/runs/1.why",
)


@pytest.fixture(scope="module")
def hub(tmp_path_factory):
    with hubs.running(tmp_path_factory.mktemp("hub"), hubs.proxy_command()) as running:
        yield running


@pytest.fixture(scope="module")
def alice(hub):
    """A user with a project."""
    user = hub.login("alice")
    with user.visit() as page:
        page.open("mine", DRIVES)
    return user


@pytest.fixture(scope="module")
def bob(hub):
    return hub.login("bob")


@pytest.fixture(scope="module")
def carol(hub):
    """A user in no group."""
    return hub.login("carol")


@pytest.fixture(scope="module")
def teacher(hub):
    """The teacher of Alice's group, who needs no server."""
    user = hub.visitor("teacher")
    user.login("/hub/home")
    return user


@pytest.fixture
def stranger(hub):
    return hub.visitor("stranger")


def projects(user):
    with user.visit() as page:
        return [project["name"] for project in page.pulse()["projects"]]


def test_the_login_leads_to_the_page_and_all_its_files(alice):
    assert alice.page.url.path == "/user/alice/learnblock/"
    files = re.findall(r'(?:src|href)="\./([^"]+)"', alice.page.text)
    assert [file for file in files if file.startswith("assets/")]
    assert {alice.get(file).status_code for file in files} == {200}


def test_the_browser_sends_its_login_when_it_asks_for_the_manifest(alice):
    assert re.search(r"<link rel=\"manifest\"[^>]*use-credentials", alice.page.text)


def test_a_page_opens_a_project_and_runs_it(alice):
    with alice.visit() as page:
        page.open("square", DRIVES)
        assert page.run()["ended"] == "finished"


@pytest.mark.certain
def test_neither_user_sees_the_projects_of_the_other(alice, bob):
    with bob.visit() as page:
        page.open("hers", DRIVES)
    assert "mine" in projects(alice)
    assert "mine" not in projects(bob)
    assert "hers" in projects(bob)
    assert "hers" not in projects(alice)


@pytest.mark.certain
@pytest.mark.parametrize("path", REQUESTS)
def test_a_user_is_refused_the_server_of_another(alice, bob, path):
    assert bob.get(path, of="alice").status_code == 403


@pytest.mark.certain
@pytest.mark.parametrize("path", REQUESTS)
def test_who_has_not_logged_in_is_led_to_the_login(alice, stranger, path):
    assert stranger.get(path, of="alice").url.path == "/hub/login"


@pytest.mark.certain
@pytest.mark.parametrize("who", ["bob", "stranger"])
def test_nobody_else_sends_a_file_to_a_user(alice, request, who):
    answer = request.getfixturevalue(who).post("projects/mine/runs", b"x", of="alice")
    assert answer.status_code in {403, 405}


@pytest.mark.certain
@pytest.mark.parametrize("who", ["bob", "stranger"])
def test_nobody_else_opens_the_websocket_of_a_user(alice, request, who):
    user = request.getfixturevalue(who)
    with pytest.raises(InvalidStatus, match="403"), user.visit(of="alice"):
        pass


@pytest.mark.certain
def test_a_page_of_another_site_does_not_open_the_websocket(alice):
    with pytest.raises(InvalidStatus, match="403"), alice.visit(origin="https://evil.example"):
        pass


@pytest.mark.certain
def test_only_a_page_of_the_hub_sends_a_file(hub, alice):
    sent = "projects/mine/runs", b"x"
    # It is read, and is no file of a run.
    assert alice.post(*sent, Origin=hub.address).status_code == 400
    # The proxy answers 500 if it is still sending when LearnBlock refuses.
    assert alice.post(*sent, Origin="https://evil.example").status_code in {403, 500}


def test_the_teacher_of_a_group_sees_a_project_of_it(alice, teacher):
    assert teacher.ask_for("alice").url.path == "/user/alice/learnblock/"
    with teacher.visit(of="alice") as shown, alice.visit() as page:
        shown.say("Open", name="mine")
        assert "move_straight(40)" in shown.hear("Document")["blocktext"]
        page.say("Open", name="mine")
        page.hear("Document")
        page.type(DRIVES.replace("40", "50"))
        while "move_straight(50)" not in (shown.hear("Document")["blocktext"] or ""):
            pass


@pytest.mark.certain
def test_the_teacher_of_a_group_sees_nobody_outside_it(carol, teacher):
    assert teacher.get("", of=carol.name).status_code == 403
    with pytest.raises(InvalidStatus, match="403"), teacher.visit(of=carol.name):
        pass


def test_only_simulated_robots_are_offered(alice):
    with alice.visit() as page:
        robots = page.hear("Welcome")["robots"]
    assert robots
    assert all(robot["simulated"] for robot in robots)


@pytest.mark.certain
def test_a_pupil_has_no_terminal(alice):
    assert alice.client.post("/user/alice/api/terminals").status_code in {403, 404}


@pytest.mark.certain
def test_the_token_stays_between_the_proxy_and_learnblock(hub, alice):
    token = hubs.token(hub.server("alice"))
    assert token not in hub.log
    assert token not in alice.page.text
    assert token not in str(alice.page.headers)
    assert "learnblock_token" not in str([one.headers for one in alice.page.history])


@pytest.mark.certain
def test_past_the_proxy_nothing_is_answered_without_the_token(hub, alice):
    process = hub.server("alice")
    transport = httpx.HTTPTransport(uds=hubs.unix_socket(process))
    with httpx.Client(transport=transport, base_url="http://localhost") as client:
        for path in REQUESTS:
            assert client.get(f"/{path}").status_code == 403
    for token in (None, "wrong"):
        with pytest.raises(InvalidStatus, match="403"), hubs.knock(process, token):
            pass
    with hubs.knock(process, hubs.token(process)) as page:
        assert page.next()["kind"] == "Welcome"


@pytest.mark.certain
def test_two_users_have_two_tokens_and_two_folders(hub, alice, bob):
    assert hubs.token(hub.server("alice")) != hubs.token(hub.server("bob"))
    with bob.visit() as page:
        page.open("own", DRIVES)
    folders = [[*hub.home(name).rglob("*.learnblock")] for name in ("alice", "bob")]
    assert all(folders)


def test_a_launcher_shows_learnblock_with_its_icon(alice):
    entry = hubs.servers_info(alice)["learnblock"]["launcher_entry"]
    assert entry["title"] == "LearnBlock"
    icon = alice.client.get(entry["icon_url"])
    assert icon.headers["Content-Type"] == "image/svg+xml"
    assert b"<svg" in icon.content


@pytest.mark.certain
def test_a_killed_learnblock_starts_again_with_its_projects(hub, alice):
    killed = hub.server("alice")
    os.kill(killed, signal.SIGKILL)
    wait_for(lambda: hub.server("alice") not in {None, killed}, "a new one", hubs.STARTING)
    wait_for(lambda: alice.get("").status_code == 200, "its answer", hubs.STARTING)
    assert "mine" in projects(alice)


@pytest.mark.certain
def test_a_stopped_server_ends_learnblock_which_saves_everything(hub, carol):
    with carol.visit() as page:
        page.open("kept", "main:\nend\n")
        page.type(DRIVES)
        process = hub.server("carol")
        hub.stop_server("carol")
    wait_for(lambda: not hubs.is_running(process), "the end of LearnBlock", hubs.STARTING)
    (file,) = hub.home("carol").rglob("kept.learnblock")
    assert "move_straight(40)" in file.read_text()
    assert carol.spawn().url.path == "/user/carol/learnblock/"
    assert "kept" in projects(carol)
