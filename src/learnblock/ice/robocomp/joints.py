"""Joints: JointMotor and JointMotorPublish."""

from dataclasses import dataclass

from learnblock.ice.interface import Interface, Operation
from learnblock.ice.robocomp.layout import Layout, laid_out
from learnblock.ice.types import (
    STRING,
    Bool,
    Byte,
    Dictionary,
    Float,
    Int,
    Refusal,
    Sequence,
    String,
)


@dataclass(frozen=True, slots=True)
class MotorState:
    """The state of a joint: rad, rad/s, steps (p), steps/s (v), and °C."""

    pos: Float = 0.0
    vel: Float = 0.0
    power: Float = 0.0
    timeStamp: String = ""
    p: Int = 0
    v: Int = 0
    isMoving: Bool = False
    temperature: Int = 0


@dataclass(frozen=True, slots=True)
class MotorParams:
    """The parameters of a joint: positions in rad, speed in rad/s."""

    name: String = ""
    busId: Byte = 0
    minPos: Float = 0.0
    maxPos: Float = 0.0
    maxVelocity: Float = 0.0
    zeroPos: Float = 0.0
    stepsRange: Float = 0.0
    maxDegrees: Float = 0.0
    invertedSign: Bool = False
    offset: Float = 0.0
    unitsRange: Float = 0.0


@dataclass(frozen=True, slots=True)
class BusParams:
    """The bus of the joints; its period in ms."""

    handler: String = ""
    device: String = ""
    numMotors: Int = 0
    baudRate: Int = 0
    basicPeriod: Int = 0


@dataclass(frozen=True, slots=True)
class MotorGoalPosition:
    """The goal of a joint in rad, and its maximum speed in rad/s."""

    name: String = ""
    position: Float = 0.0
    maxSpeed: Float = 0.0


@dataclass(frozen=True, slots=True)
class MotorGoalVelocity:
    """The speed of a joint in rad/s, and its maximum acceleration in rad/s²."""

    name: String = ""
    velocity: Float = 0.0
    maxAcc: Float = 0.0


_STATE_ORDERS = {Layout.ROBOT: "p v temperature isMoving pos vel power timeStamp"}
# The order in RoboComp of 2020 is unknown; it is assumed to be the tool's.
_PARAMS_ORDERS = {
    Layout.ROBOT: (
        "invertedSign busId minPos maxPos maxVelocity zeroPos stepsRange maxDegrees offset"
        " unitsRange name"
    )
}
_BUS_ORDERS = {Layout.ROBOT: "numMotors baudRate basicPeriod handler device"}
_POSITION_ORDERS = {Layout.ROBOT: "position maxSpeed name"}
_VELOCITY_ORDERS = {Layout.ROBOT: "velocity maxAcc name"}

_FAILED, _UNKNOWN, _COLLISION = (
    Refusal(f"::RoboCompJointMotor::{name}Exception")
    for name in ("HardwareFailed", "UnknownMotor", "Collision")
)


def motor_states(layout: Layout) -> Dictionary:
    """MotorStateMap: the joints' states by name."""
    return Dictionary(STRING, laid_out(MotorState, layout, _STATE_ORDERS))


def joint_motor(layout: Layout) -> Interface:
    """The joints of a robot."""
    return Interface("::RoboCompJointMotor::JointMotor", (*_commands(layout), *_questions(layout)))


def joint_motor_publish(layout: Layout) -> Interface:
    """A subscriber to the states of the joints."""
    published = Operation("motorStates", takes=(motor_states(layout),))
    return Interface("::RoboCompJointMotor::JointMotorPublish", (published,))


def _commands(layout: Layout) -> tuple[Operation, ...]:
    position = laid_out(MotorGoalPosition, layout, _POSITION_ORDERS)
    velocity = laid_out(MotorGoalVelocity, layout, _VELOCITY_ORDERS)
    refuses = _UNKNOWN, _FAILED
    return (
        Operation("setPosition", takes=(position,), refuses=(*refuses, _COLLISION)),
        Operation("setVelocity", takes=(velocity,), refuses=refuses),
        Operation("setZeroPos", takes=(STRING,), refuses=refuses),
        Operation("setSyncPosition", takes=(Sequence(position),), refuses=refuses),
        Operation("setSyncVelocity", takes=(Sequence(velocity),), refuses=refuses),
        Operation("setSyncZeroPos", refuses=refuses),
    )


def _questions(layout: Layout) -> tuple[Operation, ...]:
    states = motor_states(layout)
    params = laid_out(MotorParams, layout, _PARAMS_ORDERS)
    bus = laid_out(BusParams, layout, _BUS_ORDERS)
    unknown = (_UNKNOWN,)
    return (
        Operation("getMotorParams", takes=(STRING,), gives=(params,), refuses=unknown),
        Operation("getMotorState", takes=(STRING,), gives=(states.value,), refuses=unknown),
        Operation("getMotorStateMap", takes=(Sequence(STRING),), gives=(states,), refuses=unknown),
        Operation("getAllMotorState", gives=(states,), refuses=unknown),
        Operation("getAllMotorParams", gives=(Sequence(params),)),
        Operation("getBusParams", gives=(bus,)),
    )
