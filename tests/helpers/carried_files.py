"""What leaves a computer, for the fuzzer: worlds as files, and projects that bring things."""

import os
import tempfile
from contextlib import contextmanager
from unittest import mock

from learnblock.extensions import worlds
from learnblock.extensions.worlds import PackedWorld
from learnblock.project.files import unpacking
from learnblock.project.files.carried import Carried, CarriedWorld, Code
from learnblock.project.files.project import Project
from learnblock.project.files.project_file import decode, encode
from learnblock.project.files.unpacking import unpacked
from learnblock.server.sessions.offered_code import offer
from shared_worlds import MAT, ROOM, png

BLOCK = {"learnblock_block": 1, "name": "dance", "source": ["def waltz(robot): pass"]}
LIBRARY = {
    "library.toml": ["learnblock = 1", 'name = "moves"', 'version = "1.0.0"'],
    "steps.py": ["def step(robot): pass"],
}
CARRIED = Carried(
    world=CarriedWorld("mat", MAT.split("\n"), png(4, 4)),
    tags={"door": 12},
    code=Code({"dance": BLOCK}, {"moves": LIBRARY}),
)


def read_world(text):
    """Import the bytes of a zip, given as a letter for each byte."""
    with _empty_home():
        worlds.install(worlds.unpack("mat.zip", text.encode("latin-1", "replace")))


def world_texts():
    packed = (PackedWorld("mat", MAT, png(4, 4)), PackedWorld("room", ROOM))
    return tuple(worlds.pack(world)[1].decode("latin-1") for world in packed)


def read_project(text):
    """Open a project elsewhere, and install what it brings."""
    with _empty_home():
        project = unpacked(decode(text.encode("utf-8", "replace"), "p")).project
        offer(project.carried.offered)
        unpacking.install(project.carried.offered)


def project_texts():
    project = Project("p", "x = 1\n", world="mat", tags={"ball": 3}, carried=CARRIED)
    return (encode(project).decode(),)


@contextmanager
def _empty_home():
    with (
        tempfile.TemporaryDirectory() as folder,
        mock.patch.dict(os.environ, {"LEARNBLOCK_HOME": folder}),
    ):
        yield
