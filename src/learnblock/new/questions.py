"""The questions about a new robot, for those who have no description of it yet."""

import math
import typing
from collections.abc import Iterator
from typing import Any, get_args

import click
import msgspec
from msgspec import Struct, inspect

from learnblock.description_file import describe
from learnblock.errors import NewNameError
from learnblock.new.names import check_robot_name
from learnblock.new.robot_plan import Network, RobotPlan, Serial, is_key, plan_of
from learnblock.simulator.robot_description import (
    Body,
    Camera,
    Display,
    DistanceSensor,
    GroundSensor,
    GroundSide,
    Joint,
    Side,
    Wheels,
)

Answers = dict[str, Any]


def ask_plan(name: str | None) -> RobotPlan:
    """Ask what a robot is and has; a wrong answer is told, and asked for again.

    Args:
        name: None asks for it as well.
    """
    name = name or click.prompt("Name of the robot, such as path-finder", value_proc=_robot_name)
    title = name.replace("-", " ").title()
    answers: Answers = {"name": name, "title": _ask("title", RobotPlan, "title", title)}
    answers |= _connection()
    answers["wheels"] = _fields("wheels", Wheels, radius=30.0, track=120.0, maximum_speed=300.0)
    answers["body"] = _body(answers["wheels"]["track"])
    answers["distance"] = list(_distance_sensors(answers["body"]))
    answers["ground"] = list(_ground_sensors(answers["body"]))
    answers |= _simple_devices()
    answers["joint"] = list(_joints())
    answers["camera"] = list(_cameras(answers))
    answers["led"] = list(_leds())
    return plan_of({key: value for key, value in answers.items() if value != []})


def _connection() -> Answers:
    way = click.prompt(
        "How is it reached",
        type=click.Choice(["network", "serial", "otherwise"]),
        default="network",
    )
    if way == "network":
        return {way: _fields(way, Network, address="127.0.0.1", port=4000)}
    if way == "serial":
        return {way: _fields(way, Serial, device="/dev/ttyUSB0", baud=115200)}
    return {}


def _body(track: float) -> Answers:
    shape = _ask("body.shape", Body, "shape", "box")
    size = {"radius": round(0.6 * track)} if shape == "disc" else {"length": 150.0, "width": track}
    return {"shape": shape} | _fields("body", Body, **size, height=80.0, mass=0.5)


def _distance_sensors(body: Answers) -> Iterator[Answers]:
    count = click.prompt("How many distance sensors", type=click.IntRange(0, 50), default=0)
    for index in range(count):
        click.echo(f"Distance sensor {index + 1}, from left to right:")
        usual = round(-90 + 180 * (index + 1) / (count + 1))
        direction = _ask("distance.direction", DistanceSensor, "direction", usual)
        radians, reach = math.radians(direction), _half_length(body)
        place = {"x": round(reach * math.cos(radians)), "y": round(-reach * math.sin(radians))}
        yield {
            "direction": direction,
            "sides": _ask_several(
                "distance.sides (where its reading appears)", get_args(Side), _sides(direction)
            ),
            **_fields("distance", DistanceSensor, **place, maximum=1000.0),
        }


def _sides(direction: float) -> str:
    """Where a reading appears by default; between two sides, at both."""
    looks = {"front": 0, "right": 90, "back": 180, "left": -90}
    apart = {side: abs((direction - middle + 180) % 360 - 180) for side, middle in looks.items()}
    return ", ".join(side for side, degrees in apart.items() if degrees <= 45)


def _ground_sensors(body: Answers) -> Iterator[Answers]:
    sides = _ask_several("Ground sensors (left, central, right, or none)", get_args(GroundSide), "")
    for side in sides:
        click.echo(f"Ground sensor {side}:")
        y = {"left": 12.0, "central": 0.0, "right": -12.0}[side]
        yield {"side": side} | _fields(
            "ground", GroundSensor, x=round(0.8 * _half_length(body)), y=y
        )


def _simple_devices() -> Answers:
    """Those of which nothing more has to be known."""
    answers: Answers = {}
    if click.confirm("A gyroscope?", default=False):
        answers["gyroscope"] = {}
    if click.confirm("An accelerometer?", default=False):
        answers["accelerometer"] = {}
    if click.confirm("A face that shows emotions?", default=False):
        answers["display"] = {"kind": _ask("display.kind", Display, "kind", "screen")}
    if click.confirm("A loudspeaker?", default=False):
        answers["outputs"] = ["Speaker"]
    return answers


def _joints() -> Iterator[Answers]:
    for key in _keys("Joints, such as CAMERA, ARM (or none)"):
        click.echo(f"Joint {key}:")
        yield {"key": key} | _range()


def _range() -> Answers:
    answers = _fields("joint", Joint, minimum=-40.0, maximum=40.0)
    if answers["minimum"] < answers["maximum"]:
        return answers
    click.echo("Error: `joint.minimum` is not below `joint.maximum`")
    return _range()


def _cameras(answers: Answers) -> Iterator[Answers]:
    if not click.confirm("A camera?", default=False):
        return
    camera = _fields("camera", Camera, z=60.0, x=_half_length(answers["body"]), focal=300.0)
    if any(joint["key"] == "CAMERA" for joint in answers["joint"]):
        camera["joint"] = "CAMERA"
    yield camera


def _leds() -> Iterator[Answers]:
    for place in _keys("Lamps by their places, such as Front, Left (or none)"):
        yield {"slot": place, "kind": "rgb" if click.confirm(f"{place}: in colours?") else "single"}


def _half_length(body: Answers) -> float:
    return float(body.get("radius") or body["length"] / 2)


def _fields(table: str, struct: type[Struct], **defaults: Any) -> Answers:
    """Ask for fields of a table of the description."""
    return {
        field: _ask(f"{table}.{field}", struct, field, default)
        for field, default in defaults.items()
    }


def _ask(key: str, struct: type[Struct], field: str, default: Any) -> Any:
    """Ask for the value of a field until it is one; `key` is its name in the description."""
    hint = typing.get_type_hints(struct, include_extras=True)[field]
    allowed = describe(inspect.type_info(hint))

    def converted(text: Any) -> Any:
        try:
            return msgspec.convert(text, hint, strict=False)
        except msgspec.ValidationError:
            raise click.BadParameter(f"`{key}` is {text!r:.80}: expected {allowed}") from None

    # What it is: what is allowed besides is told to those who need it.
    note = allowed.partition(" (")[2].removesuffix(")")
    return click.prompt(f"{key} ({note})", default=default, value_proc=converted)


def _ask_several(question: str, known: tuple[str, ...], default: str) -> list[str]:
    def split(text: str) -> list[str]:
        chosen = _split(text)
        for one in chosen:
            if one not in known:
                raise click.BadParameter(f"{one!r:.80}: expected one of {', '.join(known)}")
        return chosen

    answer: list[str] = click.prompt(question, default=default, value_proc=split)
    return answer


def _keys(question: str) -> list[str]:
    def split(text: str) -> list[str]:
        keys = _split(text)
        for key in keys:
            if not is_key(key):
                raise click.BadParameter(f"{key!r:.80} is no word: use letters, digits and blanks")
        return keys

    answer: list[str] = click.prompt(question, default="", show_default=False, value_proc=split)
    return answer


def _split(text: str) -> list[str]:
    """Words between commas, each once; none at all where the answer is ``none``."""
    words = (word.strip() for word in text.split(","))
    return list(dict.fromkeys(word for word in words if word and word != "none"))


def _robot_name(text: str) -> str:
    try:
        check_robot_name(text)
    except NewNameError as wrong:
        raise click.BadParameter(str(wrong)) from None
    return text
