"""A server in this process, and visitors who speak to it as a page does."""

import http.client
import json
import socket
import threading
from collections import Counter
from contextlib import contextmanager

import uvicorn
from websockets.sync.client import connect

from learnblock.server.app import create_app
from learnblock.server.serve import _config

TOKEN = "the-token-of-the-tests"
PATIENCE = 20


class Server:
    """A server on a free port.

    It runs in a thread, and ends as that of a user does.
    """

    def __init__(self, folder, **options):
        self.app = create_app(folder, token=TOKEN, **options)
        self._server = uvicorn.Server(_config(self.app))
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
        assert self._started.wait(PATIENCE)

    def stop(self):
        self._server.should_exit = True
        self._thread.join(PATIENCE)
        assert not self._thread.is_alive()

    def get(self, path, **headers):
        """The response to a request, with its `body`."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE)
        connection.request("GET", path, headers=headers)
        response = connection.getresponse()
        response.body = response.read()
        connection.close()
        return response

    @contextmanager
    def visit(self, *, token=TOKEN, host="127.0.0.1", **options):
        """A page with a websocket, which calls the server by the name `host`."""
        with connect(
            f"ws://{host}:{self.port}/ws",
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
    """Speaks and hears; what it has heard while it waited for something else it has seen."""

    def __init__(self, socket):
        self.socket = socket
        #: How often each kind of message was heard.
        self.heard = Counter()
        #: The last message of each kind.
        self.last = {}
        self._edits = 0

    def say(self, kind, **values):
        self.socket.send(json.dumps({"kind": kind, **values}))

    def say_raw(self, text):
        self.socket.send(text)

    def next(self):
        message = self.socket.recv(timeout=PATIENCE)
        if isinstance(message, bytes):
            return {"kind": "bytes", "data": message}
        message = json.loads(message)
        self.heard[message["kind"]] += 1
        self.last[message["kind"]] = message
        return message

    def hear(self, kind, **values):
        """The next message of that kind with these values."""
        while True:
            message = self.next()
            if message["kind"] == kind and values.items() <= message.items():
                return message
            assert message["kind"] != "Failed" or kind == "Failed", message

    def until(self, kind, **values):
        """All messages up to the next one of that kind."""
        found = []
        while not found or not (found[-1]["kind"] == kind and values.items() <= found[-1].items()):
            found.append(self.next())
        return found

    def open(self, name="program", text=None, **choices):
        """A new project with a program; what the page hears of it first."""
        self.say("New", name=name, **choices)
        opened = self.hear("Opened")
        self.hear("Document")
        if text is not None:
            self.type(text)
        return opened

    def type(self, text, notation="blocktext"):
        """Edit a text; the document that answers."""
        self._edits += 1
        self.say("EditText", edit=self._edits, notation=notation, text=text)
        return self.hear("Document", edit=self._edits)

    def run(self, **options):
        """Run the program; how it ended."""
        self.say("Run", **options)
        ended = self.hear("Ended")
        self.hear("RunState", state="ended")
        return ended

    def pulse(self):
        """Return when everything said until now has been obeyed."""
        self.say("ListProjects")
        return self.hear("Projects")
