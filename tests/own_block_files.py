"""Blocks of one's own for the fuzzer: sources, with what is chosen for them, and exported files."""

import json
import tempfile
from unittest import mock

from learnblock.own_blocks import check, import_file
from learnblock.own_blocks.package import Package, pack

SOURCE = '''\
"""Dances."""
from typing import Annotated, Literal

from learnblock.devices import Base
from learnblock.fields import Angle, Colour, Range, TagName


def waltz(
    robot,
    times: Annotated[int, Range(1, 9, step=2)] = 3,
    way: Literal["left", "right"] = "left",
    colour: Colour = "#ff8800",
    angle: "Annotated[Angle, Range(-90, 90)] | None" = None,
    tag: TagName = "ball",
    fast: bool = False,
    steps: list[float] = [1, 2.5],
    *,
    note: str = "",
) -> float:
    """Dance a waltz.

    And more.
    """
    robot.device(Base).move(0, 30)
    return _half(times)


def _half(x):
    return x / 2
'''
WORDS = json.dumps(
    [
        {
            "type": "motor",
            "category": "Dance",
            "name": "waltz",
            "shape": ["blockLeft"],
            "languages": {"ES": "vals"},
            "variables": [{"type": "int", "name": "times", "range": [1, 9, 2], "default": 3}],
        }
    ]
)
PACKAGE = pack(Package("dance", SOURCE, WORDS))


def read_source(text: str) -> None:
    """A source is checked, and one without errors makes blocks that stay the same."""
    checked = check(text, WORDS, name="dance")
    if not checked.errors and check(text, checked.chosen, name="dance").blocks != checked.blocks:
        raise AssertionError("what was chosen is not what is saved")


def read_configuration(text: str) -> None:
    """What is chosen is checked."""
    check(SOURCE, text, name="dance")


def read_package(text: str) -> None:
    """A file is imported into a folder of its own."""
    with (
        tempfile.TemporaryDirectory() as home,
        mock.patch.dict("os.environ", LEARNBLOCK_HOME=home),
    ):
        import_file(text)
