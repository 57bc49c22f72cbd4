"""The client of a new robot, written from its description."""

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from learnblock.devices import DEVICE_TYPES, FORMS
from learnblock.new.robot_plan import RobotPlan
from learnblock.new.template import fill, has, indented
from learnblock.simulator.robot_description import Joint

_WIDTH = 100
"""Columns of a line."""

#: The functions from which the client builds a device of each type, as in the templates; all others
#: are sensors.
FUNCTIONS: Mapping[str, tuple[str, ...]] = {
    "Animator": ("play",),
    "Base": ("move",),
    "Display": ("show_emotion",),
    "Gyroscope": ("read", "reset"),
    "Infrared": ("read", "send"),
    "JointMotor": ("move",),
    "Led": ("set",),
    "MP3": ("select", "action", "volume", "equalizer", "loop"),
    "Matrix": ("icon", "number", "text"),
    "RGBLed": ("set_color",),
    "Speaker": ("say", "play", "tone"),
}
_OF_A_SENSOR = ("read",)
#: The types of which a robot can have several devices; their keys are in a table.
_TABLES = {
    "Camera": "CAMERAS",
    "JointMotor": "JOINT_RANGES",
    "Led": "LAMPS",
    "RGBLed": "COLOURED_LAMPS",
}


def client_source(plan: RobotPlan, title: str) -> str:
    """The source of its module."""
    kinds = device_types(plan)
    parts = [_part(plan, kind) for kind in kinds]
    return fill(
        "robot/client.py",
        title=title,
        name=plan.name,
        imports="\n".join(_imports(kinds, plan)),
        tables="".join(f"\n\n{table}" for table in _tables(plan)),
        settings=indented("\n".join(_settings(plan)), 1),
        device_names=indented("\n".join(map(_entry, sorted(plan.devices()))), 4),
        rights=_rights(plan),
        reached=_reached(plan),
        added=indented("\n".join(added.strip() for added, _ in parts), 2),
        functions="\n\n".join(functions.strip("\n") for _, functions in parts),
    )


def device_types(plan: RobotPlan) -> list[str]:
    """The types of its devices, wheels first."""
    kinds = {device.partition(":")[0] for device in plan.devices()}
    return sorted(kinds, key=lambda kind: (kind != "Base", kind))


def function_names(plan: RobotPlan) -> list[str]:
    """The functions of its devices, as ``Type:KEY.function``."""
    return [
        f"{device}.{function}"
        for device in sorted(plan.devices())
        for function in FUNCTIONS.get(device.partition(":")[0], _OF_A_SENSOR)
    ]


def literal(text: str) -> str:
    """A string as a Python literal."""
    return json.dumps(text, ensure_ascii=False)


def _entry(text: str) -> str:
    return f"{literal(text)},"


def _part(plan: RobotPlan, kind: str) -> tuple[str, str]:
    """The lines that add a device, and its functions."""
    name = f"robot/devices/{kind}"
    if has(name):
        sides = ", ".join(sensor.side for sensor in plan.ground)
        text = fill(name, count=len(plan.distance), sides=sides)
    else:
        text = fill("robot/devices/Sensor", **_plain_sensor(kind))
    added, _, functions = text.partition("---\n")
    return added, functions


def _plain_sensor(kind: str) -> dict[str, str]:
    """What the template of a sensor that only reads shows of its type."""
    first_line = (DEVICE_TYPES[kind].__doc__ or kind).partition("\n")[0]
    what, _, reading = first_line.partition(": `read` returns ")
    return {
        "kind": kind,
        "function": re.sub(r"(?<=[a-z])(?=[A-Z])", "_", kind).lower(),
        "annotation": FORMS[kind].annotation,
        "what": what[0].lower() + what[1:],
        "reading": reading,
    }


def _imports(kinds: list[str], plan: RobotPlan) -> Iterator[str]:
    """The imports, in the order that import sorters use."""
    if "DistanceSensors" in kinds:
        yield "from collections.abc import Sequence"
    if _TABLES.keys() & kinds:
        yield "from functools import partial"
    if "Camera" in kinds:
        yield "from typing import TYPE_CHECKING\n"
    elif "DistanceSensors" in kinds or _TABLES.keys() & kinds:
        yield ""
    yield "from learnblock.client import EverySkill, Rights"
    yield _import("learnblock.devices", kinds)
    yield "from learnblock.robots.real import RealRobot, not_written"
    yield _import("learnblock.robots.settings", ["RobotSettings", *_setting_types(plan)])
    yield "from learnblock.wheels import Drivetrain"
    if "Camera" in kinds:
        yield "\nif TYPE_CHECKING:\n    from learnblock.devices import Frame"


def _import(module: str, names: list[str]) -> str:
    # Import sorters put CONSTANTS first: names without lower-case letters.
    sorted_names = sorted(names, key=lambda name: (not name.isupper(), name))
    line = f"from {module} import {', '.join(sorted_names)}"
    if len(line) <= _WIDTH:
        return line
    return "\n".join([f"from {module} import (", *(f"    {name}," for name in sorted_names), ")"])


def _settings(plan: RobotPlan) -> Iterator[str]:
    if plan.network:
        yield f"address: Address = {literal(plan.network.address)}"
        yield f"port: Port = {plan.network.port}"
    if plan.serial:
        yield f"serial_port: SerialPort = {literal(plan.serial.device)}"
        yield f"baud: Baud = {plan.serial.baud}"
    if plan.network or plan.serial:
        yield "patience: Patience = 3.0"
    yield f"wheel_radius: Length = {float(plan.wheels.radius)}"
    yield f"track: Length = {float(plan.wheels.track)}  # between the wheels"
    yield f"full_speed: Speed = {float(plan.wheels.maximum_speed)}  # of a wheel's rim"


def _rights(plan: RobotPlan) -> str:
    """What its driver needs for the connection."""
    needs = ["network=True"] if plan.network else []
    if plan.serial:
        needs.append('devices=("/dev/ttyACM*", "/dev/ttyUSB*")')
    return f"Rights({', '.join(needs)})"


def _setting_types(plan: RobotPlan) -> set[str]:
    return {line.partition(": ")[2].partition(" =")[0] for line in _settings(plan)}


def _reached(plan: RobotPlan) -> str:
    """The settings of the connection, for the docstring."""
    names = [line.partition(":")[0] for line in _settings(plan)]
    ways = [f"`{name}`" for name in names[: names.index("wheel_radius")]]
    return f" by the settings {', '.join(ways[:-1])} and {ways[-1]}" if ways else ""


def _tables(plan: RobotPlan) -> Iterator[str]:
    """The tables of the types of which a robot can have several devices."""
    if plan.distance:
        sides = [_tuple(map(literal, sensor.sides)) for sensor in plan.distance]
        meaning = "The sides that each sensor looks to, from left to right."
        yield _table(meaning, "SENSOR_SIDES", sides)
    if plan.camera:
        keys = [literal(camera.key) for camera in plan.camera]
        yield _table("The keys of its cameras.", _TABLES["Camera"], keys)
    if plan.joint:
        yield _joint_ranges(plan.joint)
    for kind, device in (("single", "Led"), ("rgb", "RGBLed")):
        if places := [literal(led.slot) for led in plan.led if led.kind == kind]:
            yield _table("The places of its lamps.", _TABLES[device], places)


def _joint_ranges(joints: Sequence[Joint]) -> str:
    name = _TABLES["JointMotor"]
    rows = [
        f"    {literal(joint.key)}: ({float(joint.minimum)}, {float(joint.maximum)}),\n"
        for joint in joints
    ]
    return f"#: How far each joint goes, degrees, up positive.\n{name} = {{\n{''.join(rows)}}}"


def _table(meaning: str, name: str, rows: Sequence[str]) -> str:
    """A constant with one row per line, or a single row on one line, as formatters write it."""
    if len(rows) == 1:
        return f"#: {meaning}\n{name} = {_tuple(rows)}"
    return "\n".join((f"#: {meaning}", f"{name} = (", *(f"    {row}," for row in rows), ")"))


def _tuple(items: Iterable[str]) -> str:
    parts = list(items)
    return f"({parts[0]},)" if len(parts) == 1 else f"({', '.join(parts)})"
