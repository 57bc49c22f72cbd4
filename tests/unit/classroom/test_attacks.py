"""What pupils try to reach another's work, or the teacher's rights: nothing succeeds."""

import json
import re
import subprocess
import sys
from urllib.parse import quote

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from learnblock.classroom.roster import FILE
from learnblock.project.files.folder import ProjectFolder
from learnblock.runtime.containment.landlock import version as landlock_version
from pages import TIMEOUT

pytestmark = [pytest.mark.realtime, pytest.mark.certain, pytest.mark.slow]

SECRET = "ana-wrote-this"
PROGRAM = f'main:\n    print("{SECRET}")\nend\n'


@pytest.fixture(scope="module")
def ana(room):
    pupil = room.pupil("Ana")
    with pupil.page() as page:
        page.open("mine", PROGRAM)
        page.say("CloseProject")
        page.pulse()
    return pupil


@pytest.fixture(scope="module")
def leo(room):
    return room.pupil("Leo")


def as_it_was(room, ana):
    """Whether Ana's work, her PIN and the class are as they were."""
    (entry,) = ProjectFolder(ana.folder / "projects").entries()
    project = ProjectFolder(ana.folder / "projects").read(entry.name)
    return project.blocktext == PROGRAM and room.ask("/teacher", cookie=ana.cookie).status == 403


# Requests. {ana} and {leo} are the ids.

PATHS = [
    "/p/{ana}/", "/p/{ana}/index.html", "/p/{ana}/palette/en.json", "/p/{ana}/textures/tag/1.png",
    "/p/{ana}/projects/mine/picture.jpg", "/p/{ana}/projects/mine/runs/1.why",
    "/p/{ana}/projects/mine/runs", "/p/{ana}/worlds/own/floor.png",
    "/p/{ana}/?token=x", "/p/{ana}/#project=mine", "/p/{ana}/ws", "/p/{ana}//",
    "/p/{leo}/../{ana}/palette/en.json", "/p/{leo}/..%2f{ana}/palette/en.json",
    "/p/{leo}/%2e%2e/{ana}/palette/en.json", "/p/{leo}/%2e%2e%2f{ana}%2fpalette%2fen.json",
    "/p/{leo}/../../export.zip", "/p/{leo}/..%2f..%2fclass.json",
    "/p/{leo}/projects/..%2f..%2f..%2f{ana}%2fprojects%2fmine/picture.jpg",
    "/p/{leo}/projects/%2e%2e%2f%2e%2e%2f{ana}%2fprojects%2fmine/runs/1.why",
    "/p/{leo}/lessons/..%2f..%2f..%2f/pictures/class.json",
    "/p/{leo}/worlds/..%2f..%2f..%2f{ana}/floor.png",
    "/p/{leo}/assets/../../../classes/7b/class.json",
    "/p/{leo}/assets/%2e%2e/%2e%2e/%2e%2e/class.json",
    "/assets/../../../../class.json", "/class.json", "/classes/7b/class.json",
    "/%2e%2e/class.json", "/p/../class.json", "/p/", "/p/{ana}", "/p/*/", "/p/%00/",
    "/teacher", "/teacher?key=", "/teacher?key=x", "/teacher?key=é", "/teacher?key={ana}",
    "/p/hand-ins/", "/p/hand-ins/textures/tag/1.png", "/p/hand-ins/projects/mine.learnblock",
    "/p/hand-in-{ana}/", "/p/hand-in-{ana}/textures/tag/1.png", "/p/hand-in-{ana}/projects/x",
    "/p/{ana}/record", "/p/{ana}/record.json", "/p/{leo}/../{ana}/record.json",
    "/export.zip", "/export.zip?pupil={ana}", "/export.zip?pupil={leo}", "/export.zip?pupil=*",
]  # fmt: skip

HAND_IN = "/p/hand-ins/ws?pupil={ana}&lesson=1-03-square&step=4"
ROBBERS = ("leo", "nobody", "forged", "made up")


def cookie_of(robber, room, ana, leo):
    name, _, badge = leo.cookie.partition("=")
    return {
        "leo": leo.cookie,
        "nobody": "",
        # Ana's id with Leo's signature.
        "forged": f"{name}={ana.id}.0.{badge.rpartition('.')[2]}",
        "made up": f"{name}_teacher=teacher.{'0' * 64}; {name}=teacher.{'0' * 64}",
    }[robber]


@pytest.mark.parametrize("robber", ROBBERS)
@pytest.mark.parametrize("path", PATHS)
def test_no_request_reaches_anothers_work(room, ana, leo, path, robber):
    cookie = cookie_of(robber, room, ana, leo)
    path = path.format(ana=ana.id, leo=leo.id)
    answer = room.ask(quote(path, safe="/?=%#*&"), cookie=cookie)
    told = answer.body.decode(errors="replace")
    assert SECRET not in told
    assert room.key not in told
    assert b"PK\x03\x04" not in answer.body[:4]
    assert '"secret"' not in told
    assert "_teacher" not in answer.headers.get("set-cookie", "")
    if f"/p/{ana.id}/" in path and ".." not in path:
        # The page itself sends those who are not in to the entrance.
        assert answer.status in {307, 403, 404}


@pytest.mark.parametrize("robber", ROBBERS)
def test_nobody_posts_to_anothers_project(room, ana, leo, robber):
    cookie = cookie_of(robber, room, ana, leo)
    answer = room.ask(f"/p/{ana.id}/projects/mine/runs", b"x" * 100, cookie=cookie)
    assert answer.status == 403
    assert as_it_was(room, ana)


def listen(room, path, cookie):
    """Open a socket, ask for Ana's project, and listen until it is closed."""
    with room.socket(path, cookie) as page:
        page.say("Open", name="mine")
        while True:
            page.socket.recv(timeout=TIMEOUT)


@pytest.mark.parametrize("robber", ROBBERS)
@pytest.mark.parametrize(
    "path", ["/p/{ana}/ws", "/wall", "/projected", "/p/{leo}/../{ana}/ws", HAND_IN]
)
def test_no_socket_opens_to_what_is_anothers(room, ana, leo, path, robber):
    path = path.format(ana=ana.id, leo=leo.id)
    with pytest.raises((ConnectionClosed, InvalidStatus)) as closed:
        listen(room, path, cookie_of(robber, room, ana, leo))
    if isinstance(closed.value, ConnectionClosed):
        assert closed.value.rcvd.code == 4403
    assert as_it_was(room, ana)


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:1"])
def test_pages_of_other_servers_are_refused(room, ana, origin):
    with pytest.raises(InvalidStatus), room.socket(f"/p/{ana.id}/ws", ana.cookie, origin):
        pass
    assert room.ask("/join", "{}", Origin=origin).status == 403


def test_another_name_for_the_computer_is_refused(room, ana):
    answer = room.ask(f"/p/{ana.id}/", cookie=ana.cookie, Host="evil.example")
    assert answer.status == 403


MESSAGES = [
    {"kind": "Open", "name": "mine"},
    {"kind": "Open", "name": "../../{ana}/projects/mine"},
    {"kind": "Open", "name": "..\\..\\{ana}\\projects\\mine"},
    {"kind": "Open", "name": "/{ana}/mine"},
    {"kind": "Delete", "name": "../../{ana}/projects/mine"},
    {"kind": "RenameProject", "project": "../../{ana}/projects/mine", "name": "stolen"},
    {"kind": "CopyProject", "project": "../../{ana}/projects/mine", "name": "stolen"},
    {"kind": "Export", "format": "bt", "project": "../../{ana}/projects/mine"},
    {"kind": "New", "name": "../../{ana}/projects/mine"},
    {"kind": "ReadWorld", "name": "../../../class.json"},
    {"kind": "ExportLesson", "lesson": "mine"},
    {"kind": "ReadSettings"},
    {"kind": "ChangeSettings", "robot": "ev3", "name": "password", "value": "x"},
    {"kind": "FindRobots", "on": True},
    {"kind": "ConnectRobot", "id": "ev3"},
    {"kind": "AllowNetwork", "on": True, "key": "x"},
    {"kind": "MakeRobot"},
    {"kind": "AskToWrite", "on": True},
    {"kind": "EyesUp", "on": True},
    {"kind": "StopAll"},
    {"kind": "SendHint", "text": "ha"},
    {"kind": "HandOut", "lesson": "1-01-first-drive"},
    {"kind": "RenewPin", "pupil": "{ana}"},
    {"kind": "RemovePupils", "pupils": ["{ana}"]},
    {"kind": "AnswerKnocking", "on": True},
    {"kind": "LetJoin", "on": False},
    {"kind": "RenewWord"},
    {"kind": "ShowOnProjector", "pupil": "{ana}"},
    {"kind": "LetShowPrograms", "on": True},
    {"kind": "ShowClassmate", "pupil": "{ana}", "link": "1.AAAA"},
    {"kind": "AnswerOffer", "pupil": "{ana}", "on": True},
    {"kind": "InClass", "name": "x"},
    {"kind": "Nonsense"},
    {"kind": 7},
    {},
]


@pytest.mark.parametrize("message", MESSAGES, ids=lambda one: str(one.get("kind")))
def test_no_message_does_what_is_not_the_pupils(room, ana, leo, message):
    text = json.dumps(message).replace("{ana}", ana.id)
    with leo.page() as page:
        page.say_raw(text)
        page.say("ListProjects")
        heard = page.until("Projects")
    told = json.dumps(heard)
    assert SECRET not in told
    if message.get("kind") != "New":
        assert any(one["kind"] == "Failed" for one in heard)
    assert as_it_was(room, ana)
    assert room.join("Ana", ana.pictures).status == 200


#: The classroom must not read another kind than the pupil's server does.
TWO_KINDS = [
    '{"kind":"Undo","kind":"ReadSettings"}',
    '{"kind":"ReadSettings","kind":"Undo"}',
    '{"k\\u0069nd":"ReadSettings","kind":"Undo"}',
    '{"kind":"Undo","k\\u0069nd":"ReadSettings"}',
]


@pytest.mark.parametrize(
    "raw", [*TWO_KINDS, "", "[", '{"kind":', '"x"', "[" * 50_000, "\x00", "{}" * 10]
)
def test_no_broken_message_ends_the_page(leo, raw):
    with leo.page() as page:
        page.say_raw(raw)
        assert page.hear("Failed")
        page.pulse()


def programs(room, ana):
    """Programs that try to reach what is Ana's or the class's, from Leo's robot."""
    hers = next((ana.folder / "projects").glob("*.learnblock"))
    yield f"print(open({str(hers)!r}).read())"
    yield f"print(open({str(room.folder / FILE)!r}).read())"
    yield f"open({str(hers)!r}, 'w').write('x')"
    yield f"import os; print(os.listdir({str(ana.folder)!r}))"
    yield f"import shutil; shutil.rmtree({str(ana.folder)!r})"
    yield f"import urllib.request; print(urllib.request.urlopen('http://127.0.0.1:{room.port}/').read())"
    yield f"import socket; socket.create_connection(('127.0.0.1', {room.port}))"
    yield "import os; [os.kill(int(n), 9) for n in os.listdir('/proc') if n.isdigit()]"
    yield "import os; print(dict(os.environ))"


@pytest.mark.parametrize("number", range(9))
def test_no_program_reaches_anothers_work(room, ana, leo, number):
    attack = list(programs(room, ana))[number]
    text = f"from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n\n{attack}\n"
    with leo.page() as page:
        page.open(f"attack {number}")
        page.type(text, "python")
        ended = page.run()
        told = json.dumps([one for one in (page.last.get("Printed"), ended) if one])
    assert SECRET not in told
    assert room.key not in told
    assert as_it_was(room, ana)


#: What a pupil's server does once it has been taken over by its pupil.
TAKEN_OVER = """
import sys
from pathlib import Path
from learnblock.runtime.containment.fence import contain_server

own, others = map(Path, sys.argv[1:])
contain_server(own)
(own / "mine").write_text("x")
for attempt in (lambda: (others / "work").read_text(), lambda: list(others.iterdir()),
                lambda: (others / "new").write_text("x"), lambda: (others / "work").unlink()):
    try:
        attempt()
    except PermissionError:
        print("refused")
"""


@pytest.mark.skipif(not landlock_version(), reason="needs Landlock (Linux 5.13)")
def test_a_pupils_server_reaches_its_own_folder_only(tmp_path):
    for name in ("own", "others"):
        (tmp_path / name).mkdir()
    (tmp_path / "others" / "work").write_text(SECRET)
    command = [sys.executable, "-c", TAKEN_OVER, tmp_path / "own", tmp_path / "others"]
    ended = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60)
    assert ended.stdout.split() == ["refused"] * 4
    assert (tmp_path / "own" / "mine").read_text() == "x"


@pytest.fixture
def guessing(request):
    """A class, and an address of the guesser's own, since it has to wait afterwards."""
    if sys.platform == "linux":
        room = request.getfixturevalue("room")
        return room, room.device()
    return request.getfixturevalue("own_room"), None


WRONG = ["apple", "apple", "apple", "apple"]


def test_guessing_pictures_has_to_wait(guessing):
    room, device = guessing
    room.pupil("Mia")
    codes = [room.join("Mia", WRONG, device=device).json["message"]["code"] for _ in range(8)]
    assert codes[:5] == ["class-wrong-pictures"] * 5
    assert codes[-2:] == ["class-wait"] * 2


def test_guessing_tells_nothing_about_names(guessing):
    room, device = guessing
    room.pupil("Zoe")
    for _ in range(7):
        answers = (room.join(name, WRONG, device=device) for name in ("Zoe", "Bea"))
        known, unknown = (re.sub(r"\d+", "N", one.body.decode()) for one in answers)
        assert known == unknown


def test_guessing_the_word_has_to_wait(guessing):
    room, device = guessing
    # No class has a number of three digits.
    answers = [room.join("Ana", word=f"koala {n}", device=device) for n in range(100, 170)]
    codes = {one.json["message"]["code"] for one in answers}
    assert codes == {"class-wrong-word", "class-wait"}


def test_a_page_that_sends_too_much_is_slowed_down(leo):
    with leo.page() as page:
        for _ in range(15):
            page.say("Run")
        page.say("ListProjects")
        heard = page.until("Projects")
    codes = [one["message"]["code"] for one in heard if one["kind"] == "Failed"]
    assert "class-too-fast" in codes
