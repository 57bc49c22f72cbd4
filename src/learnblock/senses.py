"""The senses that programs use, and the devices that can serve each of them.

A program asks whether there is a line on the left; whether a camera or a sensor under the robot
answers depends on the robot. This table is what checks, lists of skills and running programs share.

A need is a device (``Camera``, ``JointMotor:CAMERA``) or an ability that not every device of its
type has (``DistanceSensors:front``, ``Speaker:say``).
"""

from collections.abc import Iterable, Mapping
from functools import lru_cache
from itertools import chain

#: The needs that can serve each sense, best first.
SENSES: Mapping[str, tuple[str, ...]] = {
    "heading": ("Gyroscope:Z_AXIS", "Base"),
    "black-line": ("Camera", "GroundSensors:line"),
    "red-line": ("Camera",),
    "blue-line": ("Camera",),
    "ground-line": ("GroundSensors:line", "Camera"),
    "obstacle-front": ("DistanceSensors:front", "Bumper"),
    "obstacle-left": ("DistanceSensors:left",),
    "obstacle-right": ("DistanceSensors:right",),
    "obstacle-back": ("DistanceSensors:back",),
    "brightness": ("LightSensor", "Camera"),
    "shaking": ("Accelerometer",),
    "tilting": ("Accelerometer",),
    "text-display": ("Matrix", "Screen"),
}

#: Which sense each method of `robot.senses` reads; its argument takes the place of ``{}``.
METHODS: Mapping[str, str] = {
    "heading": "heading",
    "reset_heading": "heading",
    "line": "{}-line",
    "line_position": "black-line",
    "ground_line": "ground-line",
    "distance": "obstacle-{}",
    "obstacle_direction": "obstacle-front",
    "brightness": "brightness",
    "is_shaken": "shaking",
    "tilt": "tilting",
    "text_display": "text-display",
}

#: The senses that programs may also ask for by the device that serves them best.
ASKED_BY_DEVICE: Mapping[str, str] = {"Gyroscope:Z_AXIS": "heading"}

#: Devices that can serve for another one with the same key: a coloured LED can be white, too.
STAND_INS: Mapping[str, str] = {"Led": "RGBLed"}

#: The abilities that not every device of a type has.
ABILITIES: Mapping[str, tuple[str, ...]] = {
    "Camera": ("emotions",),
    "DistanceSensors": ("front", "left", "right", "back"),
    "GroundSensors": ("line",),
    "Speaker": ("say", "play", "tone"),
}

#: What a program can do without, if it is missing: it only decorates. A robot that can't tilt its
#: camera sees only what is ahead, and a robot without a camera has nothing to tilt.
DECORATIONS = frozenset(
    (
        "Animator",
        "Display",
        "JointMotor:CAMERA",
        "Led",
        "MP3",
        "Matrix",
        "RGBLed",
        "Screen",
        "Speaker",
    )
)


#: The devices that none of LearnBlock's robots has; those of users and plugins can have them.
UNSERVED = frozenset(("Infrared", "MP3", "Matrix"))


def equipment(devices: Iterable[str], abilities: frozenset[str] | None) -> frozenset[str]:
    """The devices of a robot, their types and their abilities, any of which may be a need.

    Args:
        devices: such as ``Camera:ROBOT``.
        abilities: such as ``Speaker:say``; None if its devices have every ability.
    """
    names = frozenset(devices)
    types = {name.partition(":")[0] for name in names}
    if abilities is None:
        every = ((f"{kind}:{ability}" for ability in ABILITIES.get(kind, ())) for kind in types)
        return names | types | frozenset(chain.from_iterable(every))
    return names | types | {ability for ability in abilities if ability.partition(":")[0] in types}


@lru_cache(maxsize=1000)
def served_by(need: str, equipment: frozenset[str]) -> str | None:
    """What serves a sense on a robot, or the need itself if the robot has it; None if nothing does.

    >>> served_by("heading", frozenset({"Base"}))
    'Base'
    >>> served_by("Camera", frozenset({"Base"}))
    """
    kind, colon, key = need.partition(":")
    stand_in = (f"{STAND_INS[kind]}{colon}{key}",) if kind in STAND_INS else ()
    ways = SENSES.get(need, (need, *stand_in))
    return next((way for way in ways if way in equipment), None)


def sense_of(method: str, argument: str | None = None) -> str | None:
    """The sense that a method of `robot.senses` reads; None if only the run will tell.

    >>> sense_of("distance", "front"), sense_of("heading")
    ('obstacle-front', 'heading')
    >>> sense_of("distance")
    """
    sense = METHODS.get(method, "").format(argument)
    return sense if sense in SENSES else None


def is_decoration(need: str) -> bool:
    """Whether a program without this sense or device loses nothing but decoration.

    >>> is_decoration("Speaker:say"), is_decoration("Base")
    (True, False)
    """
    if need in SENSES:
        return all(map(is_decoration, SENSES[need]))
    return need in DECORATIONS or need.partition(":")[0] in DECORATIONS
