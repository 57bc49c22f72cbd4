"""A Thymio of Thymio Suite, with `tdmclient`'s own server as the Suite.

The Suite itself is not in Debian, so its real timing is not tested here. The program for its
compiler is compiled by another Aseba tool instead.
"""

import shutil
import socket
import struct
import subprocess
import threading
import urllib.request
from contextlib import closing, contextmanager, suppress
from pathlib import Path
from xml.etree import ElementTree as Xml

import pytest
from tdmclient import ThymioFB
from tdmclient.server import ServerHandler, ServerNode

from emulated import LONG
from learnblock.devices import DistanceSensors, GroundSensors
from learnblock.emulators.thymio import Emulator
from learnblock.errors import RobotConnectionError
from learnblock.robots.thymio import Robot
from learnblock.robots.thymio.node import READ
from learnblock.robots.thymio.program import DRIVE, EVENTS, source
from learnblock.testing import Fault, Relay
from ports import free_port
from waiting import wait_for

#: The source of a locale.
ENGLISH = Path("/usr/share/i18n/locales/en_US")


class Thymio(ServerNode):
    """The Suite's state of one robot: it records the program and the events."""

    def __init__(self):
        variables = {name: [0] * size for name, size in READ.items()}
        variables |= {"acc": [0, 0, 23], "prox.horizontal": [0, 0, 1908, 0, 0, 0, 0]}
        super().__init__(type=ThymioFB.NODE_TYPE_THYMIO2, variables=variables)
        self.program = ""

    def compile_and_load(self, language, program, options):
        self.program = program


class Suite:
    """The Suite's end of the wire; `tdmclient` handles its messages.

    Its server's threads never end, so these threads are ours.
    """

    def __init__(self, nodes):
        self.nodes = nodes
        self._server = socket.create_server(("127.0.0.1", 0))
        self._server.settimeout(0.05)
        self.port = self._server.getsockname()[1]
        self._ended = threading.Event()
        self._threads = [threading.Thread(target=self._accept)]
        self._threads[0].start()

    def close(self):
        self._ended.set()
        for thread in self._threads:
            thread.join()
        self._server.close()

    def _accept(self):
        while not self._ended.is_set():
            with suppress(TimeoutError):
                client, _ = self._server.accept()
                self._threads.append(threading.Thread(target=self._serve, args=(client,)))
                self._threads[-1].start()

    def _serve(self, client):
        def send(packet):
            client.sendall(struct.pack("<I", len(packet)) + bytes(packet))

        handler = ServerHandler(None, self.nodes, send)
        free = {node for node in self.nodes if node.status == ThymioFB.NODE_STATUS_AVAILABLE}
        client.settimeout(0.05)
        with client, suppress(ConnectionError):
            self._converse(client, handler)
        # Robots are released when their client is gone; the library's server forgets that.
        for node in free:
            node.status = ThymioFB.NODE_STATUS_AVAILABLE

    def _converse(self, client, handler):
        waiting = b""
        while not self._ended.is_set():
            try:
                data = client.recv(65536)
            except TimeoutError:
                continue
            if not data:
                return
            waiting += data
            while len(waiting) >= 4 and len(waiting) >= (end := 4 + length(waiting)):
                handler.process_message(waiting[4:end])
                waiting = waiting[end:]


def length(packet):
    return struct.unpack_from("<I", packet)[0]


@contextmanager
def suite(*nodes):
    opened = Suite(set(nodes))
    try:
        yield opened
    finally:
        opened.close()


@pytest.fixture
def thymio():
    return Thymio()


def connect(port, **others):
    return Robot(**{"connection": "suite", "suite_port": port, "patience": LONG, **others})


def test_our_program_is_loaded_and_its_variables_are_read(thymio):
    with suite(thymio) as opened, connect(opened.port) as robot:
        assert "onevent drive" in thymio.program
        assert robot.device(DistanceSensors).read()["front"] == [2000.0, 100.0, 2000.0]
        thymio.variables["prox.ground.delta"] = [1000, 0]
        assert robot.device(GroundSensors).read()["right"] == 0.0
        assert thymio.status == ThymioFB.NODE_STATUS_READY
    wait_for(lambda: thymio.status == ThymioFB.NODE_STATUS_AVAILABLE, "it is released")


@pytest.mark.parametrize(
    # Gravity towards the left, the rear and down: 23 is 1 g.
    ("acc", "felt"),
    [
        ([0, 0, 23], []),
        ([0, -12, 20], ["front"]),
        ([0, 12, 20], ["back"]),
        ([12, 0, 20], ["left"]),
        ([-12, 0, 20], ["right"]),
        ([31, 0, 23], ["shaken"]),
    ],
)
def test_it_feels_that_it_is_tilted_and_shaken(thymio, acc, felt):
    thymio.variables["acc"] = acc
    with suite(thymio) as opened, connect(opened.port) as robot:
        sides = [side for side in ("front", "back", "left", "right") if robot.is_tilted(side)]
        assert [*sides, *(["shaken"] if robot.is_shaken() else [])] == felt


def test_a_thymio_in_use_by_another_program_is_not_taken(thymio):
    refused = pytest.raises(RobotConnectionError, match="has no free Thymio")
    with suite(thymio) as opened, connect(opened.port), refused:
        connect(opened.port, patience=1.0)


def test_a_suite_without_robots_is_reported():
    with suite() as opened, pytest.raises(RobotConnectionError, match="shows no Thymio"):
        connect(opened.port, patience=1.0)


def test_auto_uses_the_suite_if_it_is_running(thymio):
    with suite(thymio) as opened, connect(opened.port, connection="auto"):
        assert thymio.status == ThymioFB.NODE_STATUS_READY


@pytest.mark.parametrize(
    ("fault", "sentence"),
    [
        (Fault.GARBAGE, "does not come from a Thymio"),
        (Fault.CUT, "The connection to the Thymio at .* was lost"),
    ],
)
def test_a_failing_link_is_reported_and_it_can_be_connected_again(thymio, fault, sentence):
    with suite(thymio) as opened, Relay(("127.0.0.1", opened.port)) as relay:
        robot = connect(relay.port)
        relay.fault = fault
        with pytest.raises(RobotConnectionError, match=sentence):
            wait_for(robot.check_link, "an error")
        robot.stop()
        relay.fault = Fault.NONE
        connect(relay.port).stop()


# The program that the Suite gets, through the compiler of Aseba's HTTP switch.


@pytest.fixture(scope="module")
def bridge(tmp_path_factory):
    """Aseba's HTTP switch before a playground: a function that requests a path from it."""
    if shutil.which("asebahttp") is None or not ENGLISH.exists():
        pytest.skip("apt-get install aseba locales")
    # It starts only with an American English locale.
    folder = tmp_path_factory.mktemp("locale")
    locale = folder / "en_US.UTF-8"
    subprocess.run(["localedef", "-i", "en_US", "-f", "UTF-8", locale], check=True)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("QT_QPA_PLATFORM", "offscreen")
        patch.setenv("LOCPATH", str(folder))
        with closing(Emulator("empty")) as ground:
            yield from bridged(ground.settings["port"])


def bridged(robot):
    port = free_port()
    process = subprocess.Popen(
        ["asebahttp", "-p", str(port), f"tcp:host=127.0.0.1;port={robot}"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    yield lambda *request: ask(port, *request)
    process.kill()
    process.wait()


def ask(port, path, program=None):
    """The switch's answer to a GET or to a PUT of a program; None if it refuses."""
    place = f"http://127.0.0.1:{port}{path}"
    request = urllib.request.Request(place, data=program, method="PUT" if program else "GET")
    try:
        with urllib.request.urlopen(request, timeout=3) as answer:  # noqa: S310 - http
            return answer.read().decode()
    except OSError:
        return None


def aesl(text):
    """A program in the file format of Aseba's tools, with its events."""
    network = Xml.Element("network")
    for event in EVENTS:
        Xml.SubElement(network, "event", name=event.name, size=str(event.size))
    Xml.SubElement(network, "node", name="thymio-II", nodeId="1").text = text
    return b"<!DOCTYPE aesl-source>" + Xml.tostring(network)


def test_asebas_own_compiler_accepts_the_source_which_drives_and_has_a_watchdog(bridge):
    wait_for(lambda: "thymio-II" in (bridge("/nodes") or ""), "its robot is listed")
    assert bridge("/nodes/thymio-II", aesl(source())) == ""
    wait_for(lambda: bridge("/nodes/thymio-II/life") == "[0]", "the program runs")
    bridge(f"/nodes/thymio-II/{DRIVE.name}/100/50")
    target = "/nodes/thymio-II/motor.right.target"
    wait_for(lambda: bridge(target) == "[50]", "it drives")
    wait_for(lambda: bridge(target) == "[0]", "it stands")


def test_asebas_own_compiler_rejects_wrong_source(bridge):
    wait_for(lambda: "thymio-II" in (bridge("/nodes") or ""), "its robot is listed")
    bridge("/nodes/thymio-II", aesl(source() + "\nlife = nonsense\n"))
    assert bridge("/nodes/thymio-II/life") is None
