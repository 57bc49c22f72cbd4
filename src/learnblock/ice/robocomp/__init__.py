"""RoboComp's interfaces as tables: operations, types, and orders of members.

Names and spelling are RoboComp's. There are three layouts, which differ in the order of members
(`Layout`). Neither end reports its layout, and with the wrong one a call is refused or returns
wrong values.

    >>> joints = interfaces(Layout.ROBOT)["jointmotor"]
    >>> joints.type_id
    '::RoboCompJointMotor::JointMotor'
"""

from collections.abc import Mapping

from learnblock.ice.interface import Interface
from learnblock.ice.robocomp.bases import BaseState, differential_robot, generic_base
from learnblock.ice.robocomp.cameras import rgbd
from learnblock.ice.robocomp.components import common_behavior
from learnblock.ice.robocomp.expressions import Image, display, emotional_motor
from learnblock.ice.robocomp.joints import (
    MotorGoalPosition,
    MotorState,
    joint_motor,
    joint_motor_publish,
)
from learnblock.ice.robocomp.layout import Layout
from learnblock.ice.robocomp.ranges import LaserConfData, LaserReading, laser, ultrasound
from learnblock.ice.robocomp.recognition import apriltag, detection_component, emotion_recognition

__all__ = [
    "BaseState",
    "Image",
    "LaserConfData",
    "LaserReading",
    "Layout",
    "MotorGoalPosition",
    "MotorState",
    "interfaces",
]


def interfaces(layout: Layout) -> Mapping[str, Interface]:
    """Every interface, by the usual identity of its objects."""
    return {
        "apriltag": apriltag(),
        "commonbehavior": common_behavior(),
        "detectioncomponent": detection_component(),
        "differentialrobot": differential_robot(layout),
        "display": display(),
        "emotionalmotor": emotional_motor(layout),
        "emotionrecognition": emotion_recognition(),
        "genericbase": generic_base(layout),
        "jointmotor": joint_motor(layout),
        "jointmotorpublish": joint_motor_publish(layout),
        "laser": laser(layout),
        "rgbd": rgbd(layout),
        "ultrasound": ultrasound(),
    }
