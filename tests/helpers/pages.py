"""A server in this process, and clients that talk to it like a page."""

import asyncio
import http.client
import json
import socket
import threading
from collections import Counter
from contextlib import contextmanager
from types import SimpleNamespace

import uvicorn
import uvicorn.server
from websockets.sync.client import connect

from learnblock.i18n import Phrase
from learnblock.server.app import create_app
from learnblock.server.serve import configured
from learnblock.server.sessions.periods import Periods
from waiting import SECONDS

TOKEN = "the-token-of-the-tests"
TIMEOUT = SECONDS
#: A user would not notice the difference.
SOON = Periods(save=0.02)
#: What another program writes is noticed at once, or only when the project is saved.
WATCHING, ON_SAVING = Periods(save=0.02, watch=0.02), Periods(save=0.02, watch=3600)

# uvicorn looks every tenth of a second whether it should stop and whether its connections have
# closed, which costs the tests two minutes.
uvicorn.server.asyncio = SimpleNamespace(
    **{**vars(asyncio), "sleep": lambda seconds: asyncio.sleep(seconds / 20)}
)


class Server:
    """A server on a free port.

    It runs in a thread, and stops in the same way as a user's server.
    """

    def __init__(self, folder, *, periods=SOON, **options):
        self.app = create_app(folder, token=TOKEN, periods=periods, **options)
        self._server = uvicorn.Server(configured(self.app))
        self._started = threading.Event()
        self._thread = threading.Thread(target=self._run, name="server")

    @property
    def port(self):
        return self._server.servers[0].sockets[0].getsockname()[1]

    def start(self):
        self._server.config.port = 0
        startup = self._server.startup

        async def started(*args, **kwargs):
            await startup(*args, **kwargs)
            self._started.set()

        self._server.startup = started
        self._thread.start()
        assert self._started.wait(TIMEOUT)

    def stop(self):
        self._server.should_exit = True
        self._thread.join(TIMEOUT)
        assert not self._thread.is_alive()

    def get(self, path, **headers):
        """Return the response to a request, with its `body`."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=TIMEOUT)
        connection.request("GET", path, headers=headers)
        response = connection.getresponse()
        response.body = response.read()
        connection.close()
        return response

    def post(self, path, body, **headers):
        """Return the response to a request that sends something, with its `body`."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=TIMEOUT)
        connection.request("POST", path, body, headers=headers)
        response = connection.getresponse()
        response.body = response.read()
        connection.close()
        return response

    @contextmanager
    def visit(self, *, token=TOKEN, host="127.0.0.1", at="ws", **options):
        """A page with a websocket, which calls the server by the name `host`."""
        with connect(
            f"ws://{host}:{self.port}/{at}",
            sock=socket.create_connection(("127.0.0.1", self.port)),
            subprotocols=["learnblock", token],
            max_size=None,
            **options,
        ) as opened:
            yield Visitor(opened)

    def _run(self):
        self._server.run()


@contextmanager
def serving(folder, **options):
    server = Server(folder, **options)
    server.start()
    try:
        yield server
    finally:
        server.stop()


class Visitor:
    """Sends and receives; messages received while waiting for another one are kept as seen."""

    def __init__(self, socket):
        self.socket = socket
        #: How often each kind of message was received.
        self.heard = Counter()
        #: The last message of each kind.
        self.last = {}
        self._edits = 0
        #: The number of the program that it shows.
        self._shown = 0

    def say(self, kind, **values):
        self.socket.send(json.dumps({"kind": kind, **values}))

    def say_raw(self, text):
        self.socket.send(text)

    def next(self):
        message = self.socket.recv(timeout=TIMEOUT)
        if isinstance(message, bytes):
            return {"kind": "bytes", "data": message}
        message = json.loads(message)
        self.heard[message["kind"]] += 1
        self.last[message["kind"]] = message
        if message["kind"] in {"Opened", "TabOpened"}:
            self._shown = message.get("shown", 0)
        return message

    def hear(self, kind, **values):
        """Return the next message of that kind with these values."""
        while True:
            try:
                message = self.next()
            except TimeoutError:
                messages = {name: self.last[name] for name in (kind, "Failed") if name in self.last}
                raise AssertionError(f"in vain: {kind} {values}; heard {messages}") from None
            if message["kind"] == kind and values.items() <= message.items():
                return message
            assert message["kind"] != "Failed" or kind == "Failed", message

    def until(self, kind, **values):
        """Return all messages up to the next one of that kind."""
        messages = []
        while not messages or not (
            messages[-1]["kind"] == kind and values.items() <= messages[-1].items()
        ):
            messages.append(self.next())
        return messages

    def open(self, name="program", text=None, **choices):
        """Create a project with a program; return the first messages about it."""
        self.say("New", name=name, **choices)
        opened = self.hear("Opened")
        self.hear("Document")
        if text is not None:
            self.type(text)
        return opened

    def type(self, text, notation="blocktext", **made_on):
        """Edit a text; return the resulting document."""
        self._edits += 1
        made_on = {"shown": self._shown, **made_on}
        self.say("EditText", edit=self._edits, notation=notation, text=text, **made_on)
        return self.hear("Document", edit=self._edits)

    def run(self, **options):
        """Run the program; return how it ended."""
        self.say("Run", **options)
        ended = self.hear("Ended")
        self.hear("RunState", state="ended")
        return ended

    def pulse(self):
        """Wait until the server has handled all messages sent so far."""
        self.say("ListProjects")
        return self.hear("Projects")


def english(data) -> str:
    """The English text of a phrase that the server sent."""
    return str(phrase(data))


def phrase(data):
    """A phrase that the server sent, or a value of one."""
    if isinstance(data, dict):
        return Phrase(data["code"], **{key: phrase(value) for key, value in data["values"].items()})
    return tuple(map(phrase, data)) if isinstance(data, list) else data
