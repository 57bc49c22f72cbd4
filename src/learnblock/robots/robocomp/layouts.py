"""Detects the message layout of a robot's components, which do not report it themselves."""

import math
from collections.abc import Mapping
from dataclasses import astuple
from typing import Any

from learnblock.errors import IceEncodingError, IceRefusedError
from learnblock.ice.endpoint import Endpoint
from learnblock.ice.proxy import Proxy
from learnblock.ice.robocomp import Layout, MotorGoalPosition, interfaces

#: Operations whose answers differ between the layouts.
_QUESTIONS = (
    ("jointmotor", "getBusParams"),
    ("laser", "getLaserConfData"),
    ("differentialrobot", "getBaseState"),
)
#: Numbers beyond these bounds, except 0, were read from the wrong position of a message: 100 m, and
#: what whole numbers are when they are read as floats. A robot that has driven straight has turned
#: by as little as 1e-17.
_LEAST, _MOST = 1e-37, 1e5
#: A joint that no robot has, so that nothing moves.
_NO_JOINT = MotorGoalPosition(name="which layout?")


def layouts_of(endpoints: Mapping[str, Endpoint]) -> tuple[Layout, ...]:
    """The layouts that match the components' answers and that they understand.

    Args:
        endpoints: the endpoints of the components differentialrobot, jointmotor and laser.

    Raises:
        IceLinkError: one of them cannot be reached.
    """
    return tuple(layout for layout in Layout if _fits(layout, endpoints))


def _fits(layout: Layout, endpoints: Mapping[str, Endpoint]) -> bool:
    proxies = {
        identity: Proxy(interfaces(layout)[identity], identity, endpoint)
        for identity, endpoint in endpoints.items()
    }
    return _understands_goals(proxies["jointmotor"]) and all(
        _answers_well(proxies[identity], question) for identity, question in _QUESTIONS
    )


def _understands_goals(joints: Proxy) -> bool:
    """Whether the component can read a goal; in another layout it refuses the message."""
    try:
        joints.call("setSyncPosition", [_NO_JOINT])
    except IceRefusedError as refusal:
        return refusal.kind != "UnknownLocalException"
    return True


def _answers_well(component: Proxy, question: str) -> bool:
    """Whether the answer makes sense; a refusal proves nothing and is accepted."""
    try:
        answer = component.call(question)
    except IceRefusedError:
        return True
    except IceEncodingError:
        return False
    return all(map(_makes_sense, astuple(answer)))


def _makes_sense(value: Any) -> bool:
    if isinstance(value, float):
        return value == 0 or (math.isfinite(value) and _LEAST < abs(value) < _MOST)
    return not isinstance(value, str) or value.isprintable()
