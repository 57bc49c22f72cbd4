"""Events that are ready to use: a ``when`` whose condition is one skill is one sentence."""

from collections.abc import Mapping
from types import MappingProxyType

_SKILLS = (
    "is_key_pressed",
    "is_bumped",
    "is_front_obstacle",
    "received",
    "collected",
    "is_time_up",
)


def ready_hat(skill: str) -> str:
    """The type that the ready hat of a skill has or would have; its words have it as their key."""
    return f"lb_when_{skill}"


#: The skills of the ready hats, by the types of their blocks.
READY_HATS: Mapping[str, str] = MappingProxyType({ready_hat(skill): skill for skill in _SKILLS})
