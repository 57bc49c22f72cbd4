"""Custom blocks for the fuzzer: sources with their configurations, and exported files."""

import json
import tempfile
from unittest import mock

from learnblock.extensions.custom_blocks import check, import_file
from learnblock.extensions.custom_blocks.package import Package, pack

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
    """Check a source; if it has no errors, its blocks stay the same."""
    checked = check(text, WORDS, name="dance")
    if not checked.errors and check(text, checked.chosen, name="dance").blocks != checked.blocks:
        raise AssertionError("what was chosen is not what is saved")


def read_configuration(text: str) -> None:
    """Check a configuration."""
    check(SOURCE, text, name="dance")


def read_package(text: str) -> None:
    """Import a file into an empty folder."""
    with (
        tempfile.TemporaryDirectory() as home,
        mock.patch.dict("os.environ", LEARNBLOCK_HOME=home),
    ):
        import_file(text)
