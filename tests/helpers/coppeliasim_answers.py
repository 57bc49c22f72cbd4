"""A CoppeliaSim that returns given replies, without a wire."""

import cbor2

from learnblock.devices import Camera, Sensor
from learnblock.errors import RobotConnectionError
from learnblock.robots.coppeliasim.named_parts import NamedParts
from learnblock.robots.coppeliasim.paper_scene import PaperScene
from learnblock.robots.coppeliasim.remote import Remote
from learnblock.robots.coppeliasim.script_scene import ScriptScene
from learnblock.robots.coppeliasim.settings import Settings

SETTINGS = Settings(front=("/sonar",), ground_central="/floor", camera="/eye")
SCENES = {"script": ScriptScene, "paper": PaperScene, "names": NamedParts}
#: Replies of a working CoppeliaSim to several functions.
HEALTHY = (
    7,
    [1.0, 0.0, 0.0, 0.1, 0.0, 1.0, 0.0, 0.2, 0.0, 0.0, 1.0, 0.3],
    (1, 0.25, [0.0, 0.0, 0.25], 9, [0.0, 0.0, 1.0]),
    (1, [0.5] * 15, []),
    (bytes(12), [2, 2]),
    ([5], [0.5], [], ""),
    {"devices": ["Base", "Gyroscope", "Camera", "DistanceSensors"], "camera": 3},
    {"pose": [1.0, 2.0, 3.0], "distances": {"front": [100.0]}, "ground": {"left": 5}},
)


class Socket:
    """Returns the given bytes repeatedly."""

    def __init__(self, answers):
        self.answers = answers
        self.count = 0

    def send(self, data):
        assert isinstance(data, bytes)

    def recv(self):
        self.count += 1
        return self.answers[self.count % len(self.answers)]

    def close(self, linger=None):
        pass


def use(scene, answers):
    """Use every function of a robot whose CoppeliaSim replies like this."""
    remote = Remote("127.0.0.1", 1, 0.1)
    real, remote._client.socket = remote._client.socket, Socket(answers)
    try:
        remote._sim = Functions(remote._client)
        for device, _ in SCENES[scene](remote, SETTINGS).devices():
            if isinstance(device, Sensor):
                device.read()
            if isinstance(device, Camera):
                device.detect("tags")
    finally:
        real.close(linger=0)
        remote.close()


class Functions:
    """The vendor's object of functions, whose names are unknown here."""

    def __init__(self, client):
        self._client = client

    def __getattr__(self, name):
        if name.startswith("scripttype"):
            return 1
        return lambda *arguments: self._client.call(f"sim.{name}", arguments)


def listed(value):
    """The values that a function returns, in the sent format."""
    return list(value) if isinstance(value, tuple) else [value]


#: Separates two replies in a string.
BETWEEN = b"\n----\n"


def read(text):
    """Use a robot in each kind of scene, with CoppeliaSim's replies from a string of bytes."""
    answers = text.encode("latin-1", "replace").split(BETWEEN)
    refusals = []
    for scene in SCENES:
        try:
            use(scene, answers)
        except RobotConnectionError as refusal:
            refusals.append(refusal)
    if len(refusals) == len(SCENES):
        raise refusals[0]


def texts():
    """Return replies with which robots work, one after the other."""
    healthy = [cbor2.dumps({"ret": listed(value)}) for value in HEALTHY]
    description, senses, image = healthy[6], healthy[7], healthy[4]
    handle, matrix, echo, brightness = healthy[0], healthy[1], healthy[2], healthy[3]
    conversations = (
        [description, senses, image],
        [handle, handle, matrix, matrix, matrix, echo, brightness, image],
        [healthy[5]],
        [cbor2.dumps({"err": "no"}), cbor2.dumps({"func": "_*wait*_"})],
    )
    return tuple(BETWEEN.join(conversation).decode("latin-1") for conversation in conversations)
