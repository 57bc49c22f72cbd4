"""Bases that drive: GenericBase and DifferentialRobot."""

from dataclasses import dataclass

from learnblock.ice.interface import Interface, Operation
from learnblock.ice.robocomp.layout import Layout, laid_out
from learnblock.ice.types import FLOAT, INT, Bool, Float, Refusal, Structure

FAILED = Refusal("::RoboCompGenericBase::HardwareFailedException")


@dataclass(frozen=True, slots=True)
class BaseState:
    """The pose and the speed of a base.

    RoboComp's plane has z forward and x to the right at alpha 0; alpha is positive clockwise seen
    from above.

    Args:
        isMoving: whether the base is moving.
        x: mm.
        z: mm.
        alpha: rad.
        correctedX: mm, after a correction of the odometry.
        correctedZ: mm.
        correctedAlpha: rad.
        advVx: mm/s to the right.
        advVz: mm/s forward.
        rotV: rad/s.
    """

    isMoving: Bool = False
    x: Float = 0.0
    z: Float = 0.0
    alpha: Float = 0.0
    correctedX: Float = 0.0
    correctedZ: Float = 0.0
    correctedAlpha: Float = 0.0
    advVx: Float = 0.0
    advVz: Float = 0.0
    rotV: Float = 0.0


_STATE_ORDERS = {
    Layout.SINCE_2020: ("x correctedX z correctedZ alpha correctedAlpha advVx advVz rotV isMoving"),
}


def base_state(layout: Layout) -> Structure:
    """TBaseState."""
    return laid_out(BaseState, layout, _STATE_ORDERS)


def generic_base(layout: Layout) -> Interface:
    """The queries that every base answers."""
    return Interface("::RoboCompGenericBase::GenericBase", _questions(layout))


def differential_robot(layout: Layout) -> Interface:
    """A base with two wheels: ``setSpeedBase`` takes mm/s and rad/s, clockwise positive."""
    place = INT, INT, FLOAT
    return Interface(
        "::RoboCompDifferentialRobot::DifferentialRobot",
        (
            *_questions(layout),
            Operation("setSpeedBase", takes=(FLOAT, FLOAT), refuses=(FAILED,)),
            Operation("stopBase", refuses=(FAILED,)),
            Operation("resetOdometer", refuses=(FAILED,)),
            Operation("setOdometer", takes=(base_state(layout),), refuses=(FAILED,)),
            Operation("setOdometerPose", takes=place, refuses=(FAILED,)),
            Operation("correctOdometer", takes=place, refuses=(FAILED,)),
        ),
    )


def _questions(layout: Layout) -> tuple[Operation, ...]:
    return (
        Operation("getBaseState", gives=(base_state(layout),), refuses=(FAILED,)),
        Operation("getBasePose", gives=(INT, INT, FLOAT), refuses=(FAILED,)),
    )
