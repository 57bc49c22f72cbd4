"""Plays pictures, sounds and behaviours on Cozmo at thirty frames per second."""

from collections.abc import Sequence
from itertools import zip_longest
from typing import Any

from pycozmo import protocol_encoder as packets
from pycozmo.anim_controller import AnimationController

from learnblock.errors import UnknownNameError
from learnblock.robots.cozmo import face, sound, units
from learnblock.robots.cozmo.behaviours import BEHAVIOURS, BehaviourStep

FRAMES_A_SECOND = 30


class Stage:
    """Adds pictures, sounds and behaviours to the queue of pycozmo's animation controller.

    Args:
        controller: the session's animation controller.
    """

    def __init__(self, controller: AnimationController) -> None:
        self._controller = controller

    def show(self, image: bytes) -> None:
        """Show a picture until another one is shown."""
        self._controller.display_image(packets.DisplayImage(image=image))

    def play(self, samples: sound.Samples) -> None:
        """Play a sound after those already in the queue."""
        self._controller.play_audio(_audio(samples))

    def act(self, name: str) -> None:
        """Play a behaviour in the background.

        Raises:
            UnknownNameError: there is no such behaviour.
        """
        if name not in BEHAVIOURS:
            raise UnknownNameError("behaviour", name, BEHAVIOURS)
        self._align()
        for step in BEHAVIOURS[name]:
            for frame in _frames(step):
                self._controller.play_anim_frame(*frame)

    def end_moves(self) -> None:
        """Stop the movements of a behaviour because the program drives the robot."""
        queue = self._controller.queue
        with queue.lock:
            queue.pkt_queue.clear()

    def _align(self) -> None:
        """Delay pictures and movements until the queued sounds have been played."""
        queue = self._controller.queue
        with queue.lock:
            waiting = (queue.audio_queue, queue.image_queue, queue.pkt_queue)
            longest = max(map(len, waiting))
            for track in waiting:
                track.extend([None] * (longest - len(track)))


def _frames(step: BehaviourStep) -> list[tuple[Any, Any, Any]]:
    """The sound, picture and movements of each frame of a step."""
    count = max(1, round(step.seconds * FRAMES_A_SECOND))
    image = None if step.face is None else packets.DisplayImage(image=face.emotion(step.face))
    notes = _audio(_melody(step))[:count]
    return list(zip_longest(notes, [image], [_moves(step)] + [None] * (count - 1)))


def _melody(step: BehaviourStep) -> sound.Samples:
    length = step.seconds / max(1, len(step.notes))
    return sound.joined([sound.tone(hertz, length) for hertz in step.notes])


def _moves(step: BehaviourStep) -> Sequence[Any]:
    moves: list[Any] = []
    if step.head is not None:
        moves.append(packets.SetHeadAngle(angle_rad=units.head_angle(step.head)))
    if step.lift is not None:
        moves.append(packets.SetLiftHeight(height_mm=units.lift_height(step.lift)))
    if step.drive is not None:
        left, right = units.treads(*step.drive)
        moves.append(packets.DriveWheels(lwheel_speed_mmps=left, rwheel_speed_mmps=right))
    return moves


def _audio(samples: sound.Samples) -> list[Any]:
    return [packets.OutputAudio(samples=content) for content in sound.packed(samples)]
