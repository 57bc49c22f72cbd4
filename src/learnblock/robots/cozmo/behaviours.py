"""Cozmo's twelve behaviours: sequences of faces, movements of head, lift and treads, and notes.

The original animations belong to Cozmo's app and cannot be distributed. These are our own, and much
simpler.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from learnblock.devices import Emotion


@dataclass(frozen=True, slots=True)
class BehaviourStep:
    """A step of a behaviour; None leaves a part of the robot unchanged.

    Args:
        seconds: the duration.
        face: the emotion on the screen.
        head: degrees, up is positive.
        lift: degrees of the lift's arm.
        drive: mm/s forward, and degrees/s to the right.
        notes: frequencies in hertz, played in turn; 0 is a rest.
    """

    seconds: float
    face: Emotion | None = None
    head: float | None = None
    lift: float | None = None
    drive: tuple[float, float] | None = None
    notes: Sequence[float] = ()


_STILL = (0.0, 0.0)

#: Each ends near the pose where it started.
BEHAVIOURS: Mapping[str, Sequence[BehaviourStep]] = {
    "Bored": (
        BehaviourStep(0.8, face=Emotion.NEUTRAL, head=-20, drive=(0, -40)),
        BehaviourStep(0.8, head=20, drive=(0, 40)),
        BehaviourStep(0.8, face=Emotion.SADNESS, head=-25, drive=_STILL, notes=(330, 262, 196)),
    ),
    "Cat": (
        BehaviourStep(0.5, face=Emotion.JOY, head=15, notes=(523, 784, 659)),
        BehaviourStep(0.6, lift=30, drive=(0, 30)),
        BehaviourStep(0.6, lift=-10, drive=(0, -30), notes=(587, 880, 698)),
        BehaviourStep(0.3, drive=_STILL),
    ),
    "Dances": (
        BehaviourStep(0.4, face=Emotion.JOY, head=30, lift=40, drive=(0, 120), notes=(523, 659)),
        BehaviourStep(0.4, head=0, lift=-10, drive=(0, -120), notes=(784, 659)),
        BehaviourStep(0.4, head=30, lift=40, drive=(0, -120), notes=(523, 659)),
        BehaviourStep(0.4, head=0, lift=-10, drive=(0, 120), notes=(784, 1047)),
        BehaviourStep(0.3, drive=_STILL),
    ),
    "Dog": (
        BehaviourStep(0.3, face=Emotion.JOY, head=20, drive=(40, 0), notes=(220, 165)),
        BehaviourStep(0.3, head=5, drive=(-40, 0)),
        BehaviourStep(0.3, head=20, drive=(40, 0), notes=(220, 165)),
        BehaviourStep(0.3, head=5, drive=(-40, 0)),
        BehaviourStep(0.3, drive=_STILL),
    ),
    "Duck": (
        BehaviourStep(
            0.3, face=Emotion.SURPRISE, head=10, lift=20, drive=(20, 60), notes=(349, 330)
        ),
        BehaviourStep(0.3, lift=-10, drive=(-20, -60), notes=(349, 330)),
        BehaviourStep(0.3, head=-5, lift=20, drive=(20, -60), notes=(349, 330)),
        BehaviourStep(0.3, lift=-10, drive=(-20, 60)),
        BehaviourStep(0.3, drive=_STILL),
    ),
    "Elephant": (
        BehaviourStep(0.6, face=Emotion.ANGER, head=-10, lift=-10, notes=(147,)),
        BehaviourStep(0.8, head=40, lift=45, drive=(15, 0), notes=(392, 523, 587)),
        BehaviourStep(0.8, head=0, lift=-10, drive=(-15, 0)),
        BehaviourStep(0.3, drive=_STILL),
    ),
    "Idle": (
        BehaviourStep(0.7, face=Emotion.NEUTRAL, head=10),
        BehaviourStep(0.7, head=-5, drive=(0, 15)),
        BehaviourStep(0.7, head=0, drive=(0, -15)),
        BehaviourStep(0.3, drive=_STILL),
    ),
    "Sheep": (
        BehaviourStep(0.5, face=Emotion.NEUTRAL, head=5, notes=(294, 277, 294, 277, 294)),
        BehaviourStep(0.5, head=-15),
        BehaviourStep(0.5, head=5, notes=(294, 277, 294, 277, 294)),
    ),
    "Sleep": (
        BehaviourStep(1.0, face=Emotion.SADNESS, head=-10, lift=-10, notes=(196, 0, 147, 0)),
        BehaviourStep(1.0, face=Emotion.NONE, head=-25, notes=(131, 0, 98, 0)),
        BehaviourStep(1.0, notes=(98, 0, 0, 0)),
    ),
    "Sneezes": (
        BehaviourStep(0.5, face=Emotion.DISGUST, head=25, notes=(392, 440)),
        BehaviourStep(0.5, head=40, notes=(494, 523)),
        BehaviourStep(0.2, face=Emotion.SURPRISE, head=-25, drive=(-60, 0), notes=(988,)),
        BehaviourStep(0.2, head=0, drive=(60, 0)),
        BehaviourStep(0.3, face=Emotion.NEUTRAL, drive=_STILL),
    ),
    "Vampire": (
        BehaviourStep(0.8, face=Emotion.ANGER, head=-20, lift=45, notes=(131, 139, 131, 139)),
        BehaviourStep(0.6, head=25, drive=(40, 0), notes=(156, 165)),
        BehaviourStep(0.6, lift=-10, drive=(-40, 0)),
        BehaviourStep(0.3, drive=_STILL),
    ),
    "Zombie": (
        BehaviourStep(0.6, face=Emotion.FEAR, head=-15, lift=30, drive=(15, 20), notes=(110, 104)),
        BehaviourStep(0.6, lift=15, drive=(15, -20), notes=(98, 104)),
        BehaviourStep(0.6, lift=30, drive=(-15, -20), notes=(110, 104)),
        BehaviourStep(0.6, lift=-10, drive=(-15, 20)),
        BehaviourStep(0.3, drive=_STILL),
    ),
}
