"""Which skills drive, wait and ask."""

from functools import cache

from learnblock.blocks import builtin

#: Skills that start a movement that lasts until the next command.
LASTING = frozenset(
    ("move_straight", "move_left", "move_right", "turn_left", "turn_right", "set_move")
)
TURNS = frozenset(("turn", "turn_90_left", "turn_90_right", "turn_back", "set_orientation"))
#: Skills that wait until their movement is done.
MOVEMENTS = TURNS | {"drive_distance", "drive_arc", "go_to"}
DRIVING = LASTING | MOVEMENTS
STOPPING = frozenset(("stop_bot", "slow_down"))
WAITING = MOVEMENTS | frozenset(
    (
        "sleep",
        "wait_until_still",
        "play_note",
        "rest",
        "play_audio",
        "play_frequency",
        "say_Text",
    )
)
#: Perceptual skills that ask nothing.
_ACTS = frozenset(("send", "send_code_IR"))
#: What is asked about the program or the robot itself, not about its world.
_CLOCKS = frozenset(("elapsedTime", "get_timer"))

#: The `when` that runs first, which needs no condition.
START = "start"

OBSTACLES = frozenset(
    (
        "is_front_obstacle",
        "is_left_obstacle",
        "is_right_obstacle",
        "is_back_obstacle",
        "is_obstacle_free",
        "get_min_distance",
        "get_obstacle_direction",
        "is_bumped",
    )
)


@cache
def questions() -> frozenset[str]:
    """The skills that answer something."""
    return frozenset(name for name, block in builtin().items() if block.returns_value) - _ACTS


@cache
def sensors() -> frozenset[str]:
    """The skills that ask about the world around the robot."""
    perceptual = (name for name, block in builtin().items() if block.type == "perceptual")
    return frozenset(perceptual) - _ACTS - _CLOCKS


@cache
def faces() -> frozenset[str]:
    """The skills that show an emotion."""
    return frozenset(name for name in builtin() if name.startswith("express"))


def side(skill: str) -> str:
    """The side in the name of a skill: ``left``, ``right`` or none."""
    return next((word for word in ("left", "right") if word in skill), "")


def asks_line(skill: str) -> bool:
    """Whether a skill asks for a line."""
    return skill in sensors() and skill.endswith("_line")
