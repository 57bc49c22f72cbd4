"""What a guest's page gets of a pupil's world, and what it may send there."""

import asyncio
from contextlib import asynccontextmanager

import msgspec
import pytest

from learnblock.classroom import guest_view
from learnblock.classroom.guest_view import GuestView
from learnblock.classroom.limits import GUEST_PICTURES
from learnblock.classroom.quota import Paces
from learnblock.i18n import Phrase
from learnblock.server import messages


class Socket:
    """A page's websocket, or a server's, with what it receives."""

    def __init__(self, *texts):
        self.texts = list(texts)
        self.sent = []
        self.code = None

    async def receive(self):
        if self.texts:
            return {"type": "websocket.receive", "text": self.texts.pop(0)}
        return {"type": "websocket.disconnect"}

    async def send_text(self, text):
        self.sent.append(msgspec.json.decode(text))

    async def send(self, text):
        self.sent.append(msgspec.json.decode(text))

    async def close(self, code):
        self.code = code

    async def __aiter__(self):
        for text in self.texts:
            yield text


def shown(*texts):
    """What a guest's page gets of what the host's server sends."""
    page, lost = Socket(), []

    async def lose():
        lost.append("lost")

    asyncio.run(GuestView(page, Paces(), lose)._show(Socket(*texts)))
    return page, lost


def test_a_guest_gets_what_shows_the_world_and_nothing_else():
    kinds = ["Document", "Printed", "Projects", "RunState", "Variables", "Ended", "Nonsense"]
    page, _ = shown(*(f'{{"kind":"{kind}"}}' for kind in kinds), "", "{", b"frame")
    assert [message["kind"] for message in page.sent] == ["RunState", "Ended"]
    assert page.code == 1012


def test_a_guest_gets_no_message_that_is_too_large():
    page, _ = shown(f'{{"kind":"Scene","x":"{"x" * 2_000_000}"}}', '{"kind":"Ended"}')
    assert [message["kind"] for message in page.sent] == ["Ended"]


def test_only_the_newest_picture_of_what_moves_counts():
    moves = [f'{{"kind":"Telemetry","time":{i}}}' for i in range(50)]
    page, _ = shown(*moves, '{"kind":"Ended"}')
    assert page.sent == [{"kind": "Telemetry", "time": 49}, {"kind": "Ended"}]


def test_pictures_have_a_rate():
    async def show():
        page = Socket()
        view = GuestView(page, Paces(), None)
        showing = asyncio.create_task(view._show_moves())
        began = asyncio.get_running_loop().time()
        while len(page.sent) < 4:
            await view._see('{"kind":"Telemetry"}')
            await asyncio.sleep(0)
        showing.cancel()
        return asyncio.get_running_loop().time() - began

    assert asyncio.run(show()) >= 2.9 / GUEST_PICTURES


def test_the_greeting_says_nothing_about_the_host():
    welcome = {
        "kind": "Welcome",
        "version": "0",
        "robots": [],
        "folder": "/home/ana",
        "worlds": [1],
    }
    page, _ = shown(msgspec.json.encode(welcome).decode(), '{"kind":"Welcome"')
    assert "/home/ana" not in str(page.sent)
    assert [message["worlds"] for message in page.sent] == [[], []]


def test_a_project_that_cannot_be_opened_ends_the_pair():
    for refused, lost in {"Open": ["lost"], "Run": []}.items():
        failed = messages.Failed(Phrase("project-missing"), refused)
        assert shown(msgspec.json.encode(failed).decode())[1] == lost


@pytest.mark.parametrize(
    ("text", "passes"),
    [
        ('{"kind":"HoldKeys","keys":["up"]}', True),
        ('{"kind":"HoldKeys","keys":["up"],"x":"' + "x" * 2000 + '"}', False),
        ('{"kind":"EditText","edit":1,"notation":"python","text":""}', False),
        ('{"kind":"Run"}', False),
        ('{"kind":"TakeGuest","name":"x","program":{"text":""}}', False),
        ("", False),
        ("{", False),
    ],
)
def test_a_guest_sends_keys_and_nothing_else(text, passes):
    page, server = Socket(text), Socket()
    asyncio.run(GuestView(page, Paces(), None)._hear(server))
    assert bool(server.sent) is passes
    assert page.sent == []


def test_the_keys_of_a_guest_are_kept_apart_before_any_is_pressed(monkeypatch):
    server = Socket()

    @asynccontextmanager
    async def connected(_place):
        yield server

    monkeypatch.setattr(guest_view, "connected", connected)
    page = Socket('{"kind":"HoldKeys","keys":["up"]}')
    asyncio.run(GuestView(page, Paces(), None).serve(None, "game", "rival"))
    assert [message["kind"] for message in server.sent] == ["Open", "KeepKeysApart", "HoldKeys"]
    assert (server.sent[0]["name"], server.sent[0]["tab"]) == ("game", "rival")


def test_a_guests_request_is_answered():
    page, server = Socket('{"kind":"Run","request":4}'), Socket()
    asyncio.run(GuestView(page, Paces(), None)._hear(server))
    assert (page.sent[0]["kind"], page.sent[0]["request"]) == ("Failed", 4)
    assert server.sent == []
