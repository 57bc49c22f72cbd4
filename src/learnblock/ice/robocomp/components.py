"""The interface of every RoboComp component: CommonBehavior."""

from dataclasses import dataclass
from enum import IntEnum

from learnblock.ice.interface import Interface, Mode, Operation
from learnblock.ice.types import INT, STRING, Bool, Dictionary, Enumeration, String, Structure


class ComponentState(IntEnum):
    """The state of a component."""

    STARTING = 0
    RUNNING = 1


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter of a component."""

    editable: Bool = False
    value: String = ""
    type: String = ""


def common_behavior() -> Interface:
    """The component itself: its period in ms, its parameters, and an operation that ends it."""
    parameters = Dictionary(STRING, Structure.of(Parameter))
    return Interface(
        "::RoboCompCommonBehavior::CommonBehavior",
        (
            Operation("getPeriod", gives=(INT,), mode=Mode.IDEMPOTENT),
            Operation("setPeriod", takes=(INT,)),
            Operation("timeAwake", gives=(INT,), mode=Mode.IDEMPOTENT),
            Operation("killYourSelf"),
            Operation("getParameterList", gives=(parameters,)),
            Operation("setParameterList", takes=(parameters,)),
            Operation("reloadConfig"),
            Operation("getState", gives=(Enumeration(ComponentState),)),
        ),
    )
