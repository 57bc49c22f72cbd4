"""Descriptions of new robots, and the files written from them, for `learnblock new`."""

import re

from places import ROOT

DOCS = ROOT / "docs" / "add-a-robot.md"

#: Every device, some of them several times.
EVERYTHING = """
title = "Every-Thing (2), Ñandú & Co."
world = "tags"
outputs = ["Speaker", "Matrix", "MP3", "Infrared", "Animator"]

[network]
port = 1
address = "robot.local"

[serial]

[body]
shape = "disc"
radius = 70
height = 80
mass = 0.8

[wheels]
radius = 33
track = 115
maximum_speed = 400

[gyroscope]

[accelerometer]

[bumper]
x = 70
width = 50

[light]

[display]

[[distance]]
direction = -45
sides = ["left", "front"]

[[distance]]
direction = 90
sides = ["right"]

[[ground]]
side = "left"

[[ground]]
side = "right"
kind = "cliff"

[[joint]]
key = "CAMERA"
minimum = -20
maximum = 20

[[joint]]
key = "A joint of the longest name there can be"
minimum = 20.5
maximum = 22

[[camera]]
z = 50
focal = 300
joint = "CAMERA"

[[camera]]
key = "second"
z = 60
focal = 200

[[led]]
slot = "Front"

[[led]]
slot = "Rear"

[[led]]
slot = "Back"
kind = "single"
"""


def guide() -> str:
    """Return the description in the guide."""
    match = re.search(r"```toml title=pathfinder.toml\n(.*?)```", DOCS.read_text("utf-8"), re.S)
    assert match
    return match[1]
