"""What one client may use: the others are answered meanwhile, and it is told in words.

`benchmarks/abuse_class.py` measures how long a child beside it waits.
"""

import http.client
import json
import os
import socket
import threading
from contextlib import ExitStack

import pytest
from websockets.exceptions import ConnectionClosed

from classes import opened
from learnblock.classroom.limits import OPEN_PAGES
from learnblock.classroom.roster import FILE, Roster
from learnblock.server.http.connections import MOST_UNKNOWN
from pages import TIMEOUT
from waiting import wait_for

pytestmark = [pytest.mark.realtime, pytest.mark.slow]

HALF_JOIN = b'POST /join HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 100\r\n\r\n{"w'


@pytest.fixture(scope="module")
def noted(tmp_path_factory):
    """A class, and the file in which it notes its faults."""
    folder = tmp_path_factory.mktemp("noted")
    # The class adds to it.
    with (folder / "errors").open("a+") as errors, opened(folder / "home", errors=errors) as one:
        yield one, errors


@pytest.fixture
def room(noted):
    return noted[0]


@pytest.fixture
def printed(noted):
    """Returns what the class has printed since the test began."""
    errors = noted[1]
    start = errors.seek(0, os.SEEK_END)

    def since():
        errors.seek(start)
        return errors.read()

    return since


def connected(room, stack, sent):
    one = stack.enter_context(socket.create_connection(("127.0.0.1", room.port), TIMEOUT))
    one.sendall(sent)
    return one


def upload_head(pupil, length):
    return (
        f"POST /{pupil.address}projects/x/runs?filename=a.why HTTP/1.1\r\nHost: 127.0.0.1\r\n"
        f"Cookie: {pupil.cookie}\r\nContent-Length: {length}\r\n\r\n"
    ).encode()


def answer_of(connection):
    answer = http.client.HTTPResponse(connection)
    answer.begin()
    return answer.status, answer.read()


def test_half_joins_keep_nobody_out_and_print_nothing(room, printed):
    with ExitStack() as stack:
        halves = [connected(room, stack, HALF_JOIN) for _ in range(300)]
        assert room.join("Ana").status == 200
        # Those that have waited longest are closed for others.
        wait_for(
            lambda: room.ask("/about.json").status == 200 and is_closed(halves[0]),
            "the oldest is closed",
        )
    assert room.join("Leo").status == 200
    assert printed() == ""


def is_closed(connection):
    connection.setblocking(False)
    try:
        return connection.recv(1) == b""
    except BlockingIOError:
        return False
    except ConnectionResetError:
        return True


def test_strangers_at_a_pupils_address_do_not_close_the_pupils_pages(room):
    ana = room.pupil("Ana Uno")
    with ana.page() as page, ExitStack() as stack:
        for _ in range(3 * MOST_UNKNOWN):
            connected(room, stack, HALF_JOIN)
        page.pulse()
        assert ana.ask("palette/en.json").status == 200


def test_bytes_that_are_not_http_are_said_once(room, printed):
    for _ in range(50):
        with ExitStack() as stack:
            connected(room, stack, b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" * 5)
    wait_for(printed, "a line")
    assert room.ask("/about.json").status == 200
    assert printed().splitlines() == ["Invalid HTTP request received."]


@pytest.mark.parametrize("path", ["%00", "%01", "%7f", "a%00b/c.png", "projects/%00/runs"])
def test_an_address_that_cannot_be_is_not_found(room, path):
    ana = room.pupil(f"Ana {''.join(c for c in path if c.isalnum())}")
    assert ana.ask(path).status in {400, 404}
    assert room.ask("/about.json").status == 200


def test_a_binary_message_does_not_close_the_wall(room):
    with room.wall() as wall:
        wall.hear("Wall")
        wall.socket.send(b"\x00\xff")
        wall.hear("Refused")
        wall.say("EyesUp", on=False)


def test_one_page_too_many_is_refused_in_words(room):
    ana = room.pupil("Ana Dos")
    with ExitStack() as stack:
        for _ in range(OPEN_PAGES):
            stack.enter_context(ana.page())
        with room.socket(f"/{ana.address}ws", ana.cookie) as page:
            assert page.hear("Failed")["message"]["code"] == "class-too-many-pages"
            with pytest.raises(ConnectionClosed) as closed:
                page.hear("nothing")
        assert closed.value.rcvd.code == 4429
        # The teacher can still look.
        stack.enter_context(ana.page(cookie=room.teacher()))
    # The class learns a moment after a page that it has closed.
    wait_for(lambda: is_let_in(ana), "the pupil may open a page again")


def is_let_in(pupil):
    """Whether a page of a pupil is connected, rather than refused."""
    with pupil.room.socket(f"/{pupil.address}ws", pupil.cookie) as page:
        while (kind := page.next()["kind"]) not in {"Welcome", "Failed"}:
            pass
        return kind == "Welcome"


def test_all_pages_of_a_pupil_share_the_pace(room):
    ana = room.pupil("Ana Tres")
    refused = 0
    with ExitStack() as stack:
        for _ in range(4):
            page = stack.enter_context(ana.page())
            for _ in range(4):
                page.say("Run")
            page.say("ListProjects")
            heard = page.until("Projects")
            refused += sum(
                one["kind"] == "Failed" and one["message"]["code"] == "class-too-fast"
                for one in heard
            )
    assert refused >= 4


def test_a_pupil_uploads_one_file_at_a_time(room):
    ana, leo = room.pupil("Ana Cinco"), room.pupil("Leo Uno")
    with ana.page() as page, leo.page() as other, ExitStack() as stack:
        first = connected(room, stack, upload_head(ana, 1_000_000) + bytes(100_000))
        page.pulse()
        other.pulse()
        status, body = answer_of(connected(room, stack, upload_head(ana, 10) + bytes(10)))
        assert (status, json.loads(body)["code"]) == (400, "class-uploading")
        # Others may, and the first one goes on.
        status, body = answer_of(connected(room, stack, upload_head(leo, 10) + bytes(10)))
        assert json.loads(body)["code"] == "kept-no-project"
        first.sendall(bytes(900_000))
        status, body = answer_of(first)
        assert json.loads(body)["code"] == "kept-no-project"


def test_a_file_that_is_too_large_is_refused_while_it_arrives(room):
    ana = room.pupil("Ana Seis")
    with ana.page(), ExitStack() as stack:
        one = connected(room, stack, upload_head(ana, 45_000_000))
        sending = threading.Thread(target=send_until_refused, args=(one,))
        sending.start()
        status, body = answer_of(one)
        assert (status, json.loads(body)["code"]) == (400, "log-file-too-large")
        sending.join()


def send_until_refused(connection):
    try:
        for _ in range(45):
            connection.sendall(bytes(1_000_000))
    except OSError:
        pass


def quiet(wall):
    """Wait until nobody asks to be let in."""
    while "knocking" in wall.hear("Wall"):
        pass


@pytest.fixture
def small_room(tmp_path):
    """A class that expects one pupil."""
    file = Roster(tmp_path / "classes" / "7b", "7b").folder / FILE
    file.write_text(json.dumps({**json.loads(file.read_text()), "expected": 1}))
    with opened(tmp_path) as one:
        yield one


def test_the_teacher_is_asked_from_the_35th_pupil_on(small_room):
    small_room.pupil("Ana")
    with small_room.wall() as wall:
        assert small_room.join("Leo").json["message"]["code"] == "class-asks-teacher"
        assert wall.hear("Wall", knocking=["Leo"])["more"] == 5
        wall.say("AnswerKnocking", on=False)
        quiet(wall)
        assert small_room.join("Leo").json["message"]["code"] == "class-asks-teacher"
        wall.hear("Wall", knocking=["Leo"])
        wall.say("AnswerKnocking", on=True)
        quiet(wall)
    assert small_room.join("Leo").status == 200


def test_the_teacher_deletes_several_pupils_at_once(room):
    leaving = [room.pupil(name) for name in ("Leo", "Mia")]
    with room.wall() as wall:
        wall.hear("Wall")
        wall.say("RemovePupils", pupils=[one.id for one in leaving])
        while {one.id for one in leaving} & {*wall.hear("Wall")["pupils"]}:
            pass
    assert [room.join(one.name, one.pictures).status for one in leaving] == [403, 403]


@pytest.mark.parametrize("example", ["square", "avoid"])
def test_a_class_has_the_examples_wherever_it_was_started(room, example):
    ana = room.pupil(f"Ana {example}")
    with ana.page() as page:
        page.say("New", name="mine", example=example)
        assert page.hear("Document")["blocktext"]
