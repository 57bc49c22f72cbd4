"""Folders of users: the one where a project was made, and others where it is opened."""

from learnblock.extensions import custom_blocks, libraries, worlds
from learnblock.extensions.worlds import PackedWorld
from learnblock.language import parse
from learnblock.perception import tag_names
from shared_worlds import MAT, png

#: A program that needs a world, a custom block that uses another one, a library and a tag.
PROGRAM = """import "moves"

main:
    function.waltz()
    function.two_step()
    print(function.is_tag("door"))
end
"""
WALTZ = "def waltz(robot):\n    robot.turn_twice()\n"
TURN = "def turn_twice(robot):\n    robot.turn_back()\n    robot.turn_back()\n"
UNUSED = "def clap(robot):\n    pass\n"
STEPS = "def two_step():\n    print(1)\nend\n\nmain:\n    pass\nend\n"


def furnish():
    """Fill the user's folder with everything that `PROGRAM` needs, and more."""
    worlds.install(PackedWorld("mat", MAT, png(20, 10)))
    for name, source in (("dances", WALTZ), ("turns", TURN), ("claps", UNUSED)):
        assert not custom_blocks.save(name, source).errors
    install_library("1.0.0")
    tag_names.save_names({"door": 12, "window": 13})


def install_library(version, text=STEPS):
    manifest = libraries.manifest("moves", version)
    libraries.install([libraries.make(manifest, parse(text), ["two_step"])])
