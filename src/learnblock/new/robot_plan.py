"""What the author of a robot says of it: how it is reached, and what it has.

It is the file of a simulated robot (`learnblock.simulator.robot_description`) with a name and with
two tables more, ``[network]`` and ``[serial]``.
"""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Annotated, Any

import msgspec
from msgspec import Meta, Struct

from learnblock import description_file
from learnblock.description_file import Finding, unknown
from learnblock.errors import RobotDescriptionError
from learnblock.robots.simulated import known_worlds
from learnblock.simulator import robot_description
from learnblock.simulator.robot_description import RobotFile

_WORDS = re.compile(r"\w[\w ]*")


WIDEST = 400.0
"""From the middle between the wheels to the farthest corner of a body, mm."""


class Network(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Where a robot is in the network, unless its user says otherwise."""

    port: Annotated[int, Meta(ge=1, le=65535, description="at which it listens")]
    address: Annotated[
        str,
        Meta(
            min_length=1,
            max_length=60,
            pattern=r"^[A-Za-z0-9][A-Za-z0-9.:-]*\Z",
            description="a name or number in the network: letters, digits, `.`, `:` and `-`",
        ),
    ] = "127.0.0.1"


class Serial(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """On which cable a robot is, unless its user says otherwise."""

    device: Annotated[
        str,
        Meta(
            min_length=1,
            max_length=60,
            pattern=r"^[A-Za-z0-9/][A-Za-z0-9/._:-]*\Z",
            description="the serial port, such as /dev/ttyUSB0 or COM3",
        ),
    ] = "/dev/ttyUSB0"
    baud: Annotated[int, Meta(ge=300, le=4000000, description="bits a second")] = 115200


class RobotPlan(RobotFile, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Everything a robot's description may hold."""

    name: Annotated[
        str, Meta(max_length=40, description="small letters, digits and `-`; else the file's name")
    ] = ""
    title: Annotated[
        str,
        Meta(
            max_length=60,
            pattern=r"^(?:\w[\w .,&()+-]*)?\Z",
            description="what people call it: letters, digits, blanks and `.,&()+-`",
        ),
    ] = ""
    network: Annotated[Network, Meta(description="how it is reached")] | None = None
    serial: Annotated[Serial, Meta(description="how it is reached")] | None = None

    @property
    def twin(self) -> RobotFile:
        """What the simulator has to know of it."""
        return RobotFile(**{field: getattr(self, field) for field in RobotFile.__struct_fields__})


def read_plan(file: Path) -> RobotPlan:
    """A description in a file.

    Raises:
        RobotDescriptionError: the file is wrong.
        OSError: it cannot be read.
    """
    return description_file.read(file, RobotPlan, RobotDescriptionError, _check)


def parse_plan(source: str) -> RobotPlan:
    """A description in a text.

    Raises:
        RobotDescriptionError: the text is wrong.
    """
    name, error = "the description", RobotDescriptionError
    values = description_file.parse(source, name, error)
    return description_file.convert(values, RobotPlan, error, _check, name=name, source=source)


def plan_of(values: Mapping[str, Any]) -> RobotPlan:
    """A description whose values come from elsewhere.

    Raises:
        RobotDescriptionError: one is wrong.
    """
    name = "the description"
    return description_file.convert(values, RobotPlan, RobotDescriptionError, _check, name=name)


def named(plan: RobotPlan, name: str) -> RobotPlan:
    """The same under a name."""
    return msgspec.structs.replace(plan, name=name)


def is_key(text: str) -> bool:
    """Whether it can be the key of a device: words."""
    return bool(_WORDS.fullmatch(text)) and len(text) <= 40


def _check(plan: RobotPlan) -> Iterator[Finding]:
    yield from robot_description.check(plan)
    yield from _check_keys(plan)
    if round(plan.body.reach) > WIDEST:
        message = (
            f"the body reaches {plan.body.reach:.0f} mm from the middle between the wheels: more"
            f" than {WIDEST:g} has no room in our worlds, which are 2000 mm wide"
        )
        yield Finding(("body",), "too-wide", message)
    if plan.gyroscope and plan.gyroscope.key != "Z_AXIS":
        message = f"`gyroscope.key` is {plan.gyroscope.key!r}: a robot's own gyroscope is Z_AXIS"
        yield Finding(("gyroscope", "key"), "unusual-key", message)
    if plan.world not in known_worlds():
        message = unknown(f"there is no world `{plan.world}`", plan.world, known_worlds())
        yield Finding(("world",), "unknown-world", message)


def _check_keys(plan: RobotPlan) -> Iterator[Finding]:
    """What becomes part of a Python file can be nothing but words."""
    keys = [(("camera", i, "key"), one.key) for i, one in enumerate(plan.camera)]
    keys += [(("joint", i, "key"), one.key) for i, one in enumerate(plan.joint)]
    keys += [(("led", i, "slot"), one.slot) for i, one in enumerate(plan.led)]
    for path, key in keys:
        if not is_key(key):
            message = f"the {path[2]} {key!r} is no word: use letters, digits, `_` and blanks"
            yield Finding(path, "wrong-key", message)
