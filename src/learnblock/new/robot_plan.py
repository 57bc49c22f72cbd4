"""The description of a new robot: its connection and its devices.

It is the file of a simulated robot (`learnblock.simulator.robot_description`) with a name and two
more tables, ``[network]`` and ``[serial]``.
"""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Annotated, Any

import msgspec
from msgspec import Meta, Struct

from learnblock.errors import RobotDescriptionError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.robots.simulated import known_worlds
from learnblock.simulator import robot_description
from learnblock.simulator.robot_description import RobotFile
from learnblock.storage import toml_source
from learnblock.storage.toml_source import FileMistake

_WORDS = re.compile(r"\w[\w ]*")


WIDEST = 400.0
"""From the middle between the wheels to the farthest corner of a body, mm."""


class Network(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """The default address of a robot on the network."""

    port: Annotated[int, Meta(ge=1, le=65535, description="network port")]
    address: Annotated[
        str,
        Meta(
            min_length=1,
            max_length=60,
            pattern=r"^[A-Za-z0-9][A-Za-z0-9.:-]*\Z",
            description="network address: letters, digits, ., : and -",
        ),
    ] = "127.0.0.1"


class Serial(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """The default serial port of a robot."""

    device: Annotated[
        str,
        Meta(
            min_length=1,
            max_length=60,
            pattern=r"^[A-Za-z0-9/][A-Za-z0-9/._:-]*\Z",
            description="the serial port, such as /dev/ttyUSB0 or COM3",
        ),
    ] = "/dev/ttyUSB0"
    baud: Annotated[int, Meta(ge=300, le=4000000, description="bits per second")] = 115200


class RobotPlan(RobotFile, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """The description of a new robot."""

    name: Annotated[
        str,
        Meta(
            max_length=40, description="lower-case letters, digits and -; default: the file's name"
        ),
    ] = ""
    title: Annotated[
        str,
        Meta(
            max_length=60,
            pattern=r"^(?:\w[\w .,&()+-]*)?\Z",
            description="name for people: letters, digits, spaces and .,&()+-",
        ),
    ] = ""
    network: Annotated[Network, Meta(description="connection")] | None = None
    serial: Annotated[Serial, Meta(description="connection")] | None = None

    @property
    def twin(self) -> RobotFile:
        """The part of the description that the simulator needs."""
        return RobotFile(**{field: getattr(self, field) for field in RobotFile.__struct_fields__})


def read_plan(file: Path) -> RobotPlan:
    """A description in a file.

    Raises:
        RobotDescriptionError: the file has mistakes.
        OSError: the file cannot be read.
    """
    return toml_source.read(file, RobotPlan, RobotDescriptionError, _check)


def parse_plan(source: str) -> RobotPlan:
    """A description in a string.

    Raises:
        RobotDescriptionError: it has mistakes.
    """
    name, error = "the description", RobotDescriptionError
    values = toml_source.parse(source, name, error)
    return toml_source.convert(values, RobotPlan, error, _check, name=name, source=source)


def plan_of(values: Mapping[str, Any]) -> RobotPlan:
    """A description from values, not from a file.

    Raises:
        RobotDescriptionError: a value is invalid.
    """
    name = "the description"
    return toml_source.convert(values, RobotPlan, RobotDescriptionError, _check, name=name)


def named(plan: RobotPlan, name: str) -> RobotPlan:
    """The description with another name."""
    return msgspec.structs.replace(plan, name=name)


def is_key(text: str) -> bool:
    """Whether a string can be the key of a device."""
    return bool(_WORDS.fullmatch(text)) and len(text) <= 40


def _check(plan: RobotPlan) -> Iterator[FileMistake]:
    yield from robot_description.check(plan)
    yield from _check_keys(plan)
    if round(plan.body.reach) > WIDEST:
        message = Phrase("new-too-wide", reach=round(plan.body.reach), most=int(WIDEST))
        yield FileMistake(("body",), "too-wide", message)
    if plan.gyroscope and plan.gyroscope.key != "Z_AXIS":
        message = Phrase("new-gyroscope-key", key=plan.gyroscope.key)
        yield FileMistake(("gyroscope", "key"), "unusual-key", message)
    if plan.world not in known_worlds():
        message = UnknownNameError("world", plan.world, known_worlds()).phrase
        yield FileMistake(("world",), "unknown-world", message)


def _check_keys(plan: RobotPlan) -> Iterator[FileMistake]:
    """Refuse keys that are not identifiers, because they become part of a Python file."""
    keys = [(("camera", i, "key"), camera.key) for i, camera in enumerate(plan.camera)]
    keys += [(("joint", i, "key"), joint.key) for i, joint in enumerate(plan.joint)]
    keys += [(("led", i, "slot"), led.slot) for i, led in enumerate(plan.led)]
    for path, key in keys:
        if not is_key(key):
            message = Phrase("new-bad-key", field=str(path[2]), key=key)
            yield FileMistake(path, "wrong-key", message)
