"""Questions about a new robot that has no description yet."""

import math
import typing
from collections.abc import Iterator
from typing import Any, get_args

import click
import msgspec
from msgspec import Struct, inspect

from learnblock.cli.console import say
from learnblock.cli.console import text as text_of
from learnblock.errors import NewNameError
from learnblock.i18n import Phrase, Value
from learnblock.new.names import check_robot_name
from learnblock.new.robot_plan import Network, RobotPlan, Serial, is_key, plan_of
from learnblock.new.tables import (
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
from learnblock.storage.struct_types import describe

Answers = dict[str, Any]


def ask_plan(name: str | None) -> RobotPlan:
    """Ask for the description of a robot; invalid answers are refused and the question repeated.

    Args:
        name: of the robot; None to ask for it.
    """
    name = name or click.prompt(_question("new-ask-name"), value_proc=_robot_name)
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
        _question("new-ask-connection"),
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
    count = click.prompt(_question("new-ask-distance-count"), type=click.IntRange(0, 50), default=0)
    for index in range(count):
        say("new-ask-distance-sensor", number=index + 1)
        usual = round(-90 + 180 * (index + 1) / (count + 1))
        direction = _ask("distance.direction", DistanceSensor, "direction", usual)
        radians, reach = math.radians(direction), _half_length(body)
        place = {"x": round(reach * math.cos(radians)), "y": round(-reach * math.sin(radians))}
        yield {
            "direction": direction,
            "sides": _ask_several(_question("new-ask-sides"), get_args(Side), _sides(direction)),
            **_fields("distance", DistanceSensor, **place, maximum=1000.0),
        }


def _sides(direction: float) -> str:
    """The sides of a reading by default; both sides, if it is between two."""
    looks = {"front": 0, "right": 90, "back": 180, "left": -90}
    apart = {side: abs((direction - middle + 180) % 360 - 180) for side, middle in looks.items()}
    return ", ".join(side for side, degrees in apart.items() if degrees <= 45)


def _ground_sensors(body: Answers) -> Iterator[Answers]:
    sides = _ask_several(_question("new-ask-ground"), get_args(GroundSide), "")
    for side in sides:
        say("new-ask-ground-sensor", side=side)
        y = {"left": 12.0, "central": 0.0, "right": -12.0}[side]
        yield {"side": side} | _fields(
            "ground", GroundSensor, x=round(0.8 * _half_length(body)), y=y
        )


def _simple_devices() -> Answers:
    """Devices without further questions."""
    answers: Answers = {}
    if click.confirm(_question("new-ask-gyroscope"), default=False):
        answers["gyroscope"] = {}
    if click.confirm(_question("new-ask-accelerometer"), default=False):
        answers["accelerometer"] = {}
    if click.confirm(_question("new-ask-face"), default=False):
        answers["display"] = {"kind": _ask("display.kind", Display, "kind", "screen")}
    if click.confirm(_question("new-ask-speaker"), default=False):
        answers["outputs"] = ["Speaker"]
    return answers


def _joints() -> Iterator[Answers]:
    for key in _keys(_question("new-ask-joints")):
        say("new-ask-joint", joint=key)
        yield {"key": key} | _range()


def _range() -> Answers:
    answers = _fields("joint", Joint, minimum=-40.0, maximum=40.0)
    if answers["minimum"] < answers["maximum"]:
        return answers
    say("new-ask-range-order")
    return _range()


def _cameras(answers: Answers) -> Iterator[Answers]:
    if not click.confirm(_question("new-ask-camera"), default=False):
        return
    camera = _fields("camera", Camera, z=60.0, x=_half_length(answers["body"]), focal=300.0)
    if any(joint["key"] == "CAMERA" for joint in answers["joint"]):
        camera["joint"] = "CAMERA"
    yield camera


def _leds() -> Iterator[Answers]:
    for place in _keys(_question("new-ask-leds")):
        in_colour = click.confirm(_question("new-ask-led-colour", position=place))
        yield {"slot": place, "kind": "rgb" if in_colour else "single"}


def _half_length(body: Answers) -> float:
    return float(body.get("radius") or body["length"] / 2)


def _fields(table: str, struct: type[Struct], **defaults: Any) -> Answers:
    """Ask for fields of a table in the description."""
    return {
        field: _ask(f"{table}.{field}", struct, field, default)
        for field, default in defaults.items()
    }


def _ask(key: str, struct: type[Struct], field: str, default: Any) -> Any:
    """Ask for the value of a field until it is valid; `key` is its name in the description."""
    hint = typing.get_type_hints(struct, include_extras=True)[field]
    allowed = str(describe(inspect.type_info(hint)))

    def converted(text: str) -> Any:
        try:
            return msgspec.convert(text, hint, strict=False)
        except msgspec.ValidationError:
            raise _refused(
                "new-ask-wrong-value", key=key, value=text[:80], allowed=allowed
            ) from None

    # Only the meaning; the message about an invalid value says what is allowed.
    note = allowed.partition(" (")[2].removesuffix(")")
    return click.prompt(f"{key} ({note})", default=default, value_proc=converted)


def _ask_several(question: str, options: tuple[str, ...], default: str) -> list[str]:
    def split(text: str) -> list[str]:
        choices = _split(text)
        for choice in choices:
            if choice not in options:
                raise _refused("new-ask-unknown", value=choice[:80], known=options)
        return choices

    answer: list[str] = click.prompt(question, default=default, value_proc=split)
    return answer


def _keys(question: str) -> list[str]:
    def split(text: str) -> list[str]:
        keys = _split(text)
        for key in keys:
            if not is_key(key):
                raise _refused("new-ask-bad-key", key=key[:80])
        return keys

    answer: list[str] = click.prompt(question, default="", show_default=False, value_proc=split)
    return answer


def _split(text: str) -> list[str]:
    """The comma-separated words without duplicates and without ``none``."""
    words = (word.strip() for word in text.split(","))
    return list(dict.fromkeys(word for word in words if word and word != "none"))


def _robot_name(text: str) -> str:
    try:
        check_robot_name(text)
    except NewNameError as wrong:
        raise click.BadParameter(text_of(wrong.phrase)) from None
    return text


def _question(code: str, /, **values: str) -> str:
    return text_of(Phrase(code, **values))


def _refused(code: str, /, **values: Value) -> click.BadParameter:
    return click.BadParameter(text_of(Phrase(code, **values)))
