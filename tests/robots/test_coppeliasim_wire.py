"""Whatever CoppeliaSim, or what stands in its place, answers: only our own errors come of it."""

from contextlib import suppress

import cbor2
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from learnblock.devices import Camera, Sensor
from learnblock.errors import RobotConnectionError
from learnblock.robots.coppeliasim.named_parts import NamedParts
from learnblock.robots.coppeliasim.paper_scene import PaperScene
from learnblock.robots.coppeliasim.remote import Remote
from learnblock.robots.coppeliasim.script_scene import ScriptScene
from learnblock.robots.coppeliasim.settings import Settings

SETTINGS = Settings(front=("/sonar",), ground_central="/floor", camera="/eye")
SCENES = {"script": ScriptScene, "paper": PaperScene, "names": NamedParts}
#: What a healthy CoppeliaSim would answer to some function or other.
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
    """Answers with given bytes, again and again."""

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
    """Do everything with a robot whose CoppeliaSim answers so."""
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
    """The vendor's object of functions, of which one cannot know the names here."""

    def __init__(self, client):
        self._client = client

    def __getattr__(self, name):
        if name.startswith("scripttype"):
            return 1
        return lambda *arguments: self._client.call(f"sim.{name}", arguments)


VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=4) | st.binary(),
    lambda inner: st.lists(inner, max_size=16) | st.dictionaries(st.text(max_size=8), inner),
    max_leaves=20,
)
REPLIES = (
    st.sampled_from(HEALTHY).map(lambda value: {"ret": listed(value)})
    | st.lists(VALUES, max_size=4).map(lambda values: {"ret": values})
    | VALUES.map(lambda value: {"ret": value})
    | st.text(max_size=30).map(lambda text: {"err": text})
    | VALUES
).map(cbor2.dumps) | st.binary(max_size=60)


def listed(value):
    return list(value) if isinstance(value, tuple) else [value]


@pytest.mark.parametrize("scene", SCENES)
@given(answers=st.lists(REPLIES, min_size=1, max_size=8))
@example(answers=[cbor2.dumps({"ret": [float("nan")] * 12})])
@example(answers=[cbor2.dumps({"ret": [{"devices": ["Base"]}]}), b"\x9b" + b"\xff" * 8])
@example(answers=[b"\x81" * 2000])
@example(answers=[cbor2.dumps({"ret": [10**400]})])
def test_only_our_own_errors_come_of_whatever_is_answered(scene, answers):
    with suppress(RobotConnectionError):
        use(scene, answers)
