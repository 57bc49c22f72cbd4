"""The emulated robot: it executes packets with the twin, and reports the twin's state."""

import json
import math
from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from pycozmo import protocol_encoder as packets

from learnblock.emulators.cozmo import face, picture, reports
from learnblock.emulators.cozmo.reports import ARM, PIVOT, Reports
from learnblock.emulators.twin import Twin
from learnblock.simulator.colours import RGB
from learnblock.wheels import body_speeds

TRACK = 45.0
"""The distance between the treads in mm (pycozmo.robot)."""
TICK = 0.03
"""Seconds between two reports of its state."""
PICTURE_PERIOD = 1 / 15
"""Seconds between two pictures."""
CALIBRATION = 0.1
"""Seconds for the calibration of head and lift; a real robot takes longer."""

_JOINTS = (packets.MotorID.MOTOR_HEAD, packets.MotorID.MOTOR_LIFT)

_FIRMWARE = {"version": 2381, "build": "DEVELOPMENT"}


class CozmoMachine:
    """An emulated Cozmo, whose body is a twin.

    Args:
        twin: the simulated robot.

    Attributes:
        received: the number of packets received, by name.
        heard: the last frames of sound, each with 744 samples in the robot's encoding.
        felt: the emotions shown so far, in order.
        volume: the volume from 0 to 65535.
    """

    def __init__(self, twin: Twin) -> None:
        self.received: Counter[str] = Counter()
        self.heard: deque[bytes] = deque(maxlen=4500)
        self.felt: list[str] = []
        self.volume = 65535
        self._twin = twin
        self._speeds = (0.0, 0.0)
        self._enabled = self._reporting = self._animates = False
        self._films = self._coloured = False
        self._stops_at_cliffs = True
        self._calibrated_at: float | None = None
        self._on_cliff = False
        self._reports = Reports()
        self._pictures, self._picture_due = 0, 0.0
        self._sound_frames = self._frames_of_this_sound = 0
        self._shown = b""
        self._handlers: dict[type, Callable[[Any], Iterable[Any] | None]] = {
            packets.DriveWheels: self._drive,
            packets.StopAllMotors: lambda _: self.rest(),
            packets.SetHeadAngle: self._set_head,
            packets.SetLiftHeight: self._set_lift,
            packets.LightStateCenter: lambda packet: self._light("Front Center Rear", packet),
            packets.LightStateSide: lambda packet: self._light("Left Right", packet),
            packets.Enable: self._enable,
            packets.SyncTime: self._synchronize,
            packets.SetOrigin: self._set_origin,
            packets.EnableStopOnCliff: self._set_cliff_stop,
            packets.EnableAnimationState: self._animate,
            packets.EnableCamera: self._film,
            packets.EnableColorImages: self._colour,
            packets.SetRobotVolume: self._set_volume,
            packets.OutputAudio: self._sound,
            packets.OutputSilence: lambda _: self._end_sound(),
            packets.DisplayImage: self._show,
        }

    # Called by the server.

    def greet(self) -> Iterable[Any]:
        self._enabled = self._reporting = self._animates = self._films = self._coloured = False
        self._stops_at_cliffs = True
        yield packets.HardwareInfo(serial_number_head=0x02E00001)
        yield packets.FirmwareSignature(signature=json.dumps(_FIRMWARE))

    def handle(self, packet: Any) -> Iterable[Any]:
        self.received[type(packet).__name__] += 1
        handler = self._handlers.get(type(packet))
        try:
            return (handler(packet) if handler else None) or ()
        except (OverflowError, ValueError):
            # A speed such as NaN; the robot ignores the packet.
            return ()

    def tick(self) -> Iterator[Any]:
        now = self._twin.time
        if self._calibrated_at is not None and now >= self._calibrated_at:
            self._calibrated_at = None
            yield from (packets.MotorCalibration(motor_id=motor) for motor in _JOINTS)
        if self._reporting:
            yield self._state(now)
        if self._animates:
            yield packets.AnimationState(
                timestamp=self._milliseconds(), num_audio_frames_played=self._sound_frames
            )
        if self._films and now >= self._picture_due:
            self._picture_due = max(self._picture_due + PICTURE_PERIOD, now)
            yield from self._picture()

    def rest(self) -> None:
        self._set_speeds(0.0, 0.0)
        with self._twin.body() as body:
            for key in ("ARM", "CAMERA"):
                body.set_joint(key, body.joint(key))

    # The effects of packets.

    def _enable(self, _packet: Any) -> Iterable[Any]:
        if self._enabled:
            return ()
        self._enabled = True
        self._calibrated_at = self._twin.time + CALIBRATION
        return (
            packets.BodyInfo(serial_number=0x45A00001, body_hw_version=5, body_color=2),
            *(packets.MotorCalibration(motor_id=motor, calib_started=True) for motor in _JOINTS),
        )

    def _synchronize(self, _packet: Any) -> None:
        self._reporting = self._enabled

    def _animate(self, _packet: Any) -> None:
        self._animates = self._enabled

    def _film(self, packet: Any) -> None:
        self._films = packet.image_send_mode == packets.ImageSendMode.Stream

    def _colour(self, packet: Any) -> None:
        self._coloured = packet.enable

    def _set_cliff_stop(self, packet: Any) -> None:
        self._stops_at_cliffs = packet.enable

    def _set_volume(self, packet: Any) -> None:
        self.volume = packet.level

    def _set_origin(self, packet: Any) -> None:
        """Make its current pose the origin of its reports."""
        with self._twin.body() as body:
            self._reports.set_origin(body.pose, packet.pose_frame_id, packet.pose_origin_id)

    def _drive(self, packet: Any) -> None:
        self._set_speeds(packet.lwheel_speed_mmps, packet.rwheel_speed_mmps)

    def _set_speeds(self, left: float, right: float) -> None:
        self._speeds = (left, right)
        with self._twin.body() as body:
            body.drive(*body_speeds((left, right), TRACK))

    def _set_head(self, packet: Any) -> Iterable[Any]:
        with self._twin.body() as body:
            body.set_joint("CAMERA", math.degrees(packet.angle_rad))
        return (packets.AcknowledgeAction(action_id=packet.action_id),)

    def _set_lift(self, packet: Any) -> Iterable[Any]:
        sine = min(max((packet.height_mm - PIVOT) / ARM, -1.0), 1.0)
        with self._twin.body() as body:
            body.set_joint("ARM", math.degrees(math.asin(sine)))
        return (packets.AcknowledgeAction(action_id=packet.action_id),)

    def _light(self, slots: str, packet: Any) -> None:
        with self._twin.body() as body:
            for slot, state in zip(slots.split(), packet.states, strict=True):
                body.set_led(slot, _rgb(state.on_color))

    def _sound(self, packet: Any) -> None:
        self.heard.append(bytes(packet.samples))
        self._sound_frames += 1
        self._frames_of_this_sound += 1

    def _end_sound(self) -> None:
        if self._frames_of_this_sound:
            with self._twin.body() as body:
                body.note("Speaker", "sound", self._frames_of_this_sound)
            self._frames_of_this_sound = 0

    def _show(self, packet: Any) -> None:
        image = bytes(packet.image)
        if image == self._shown:
            # The picture is sent 30 times a second.
            return
        self._shown = image
        try:
            name = face.emotion(face.pixels(image))
        except ValueError:
            return
        with self._twin.body() as body:
            if name is None:
                body.note("Display", "image")
            elif name != body.emotion:
                body.show_emotion(name)
                self.felt.append(name)

    # Reports.

    def _milliseconds(self) -> int:
        return int(self._twin.time * 1000)

    def _state(self, now: float) -> Any:
        with self._twin.body() as body:
            self._check_cliff(reports.is_on_cliff(body))
            return self._reports.state(body, now, self._speeds)

    def _check_cliff(self, on_cliff: bool) -> None:  # noqa: FBT001 - it is on one or it is not
        """Stop at the edge of the floor; the next command may drive on."""
        if on_cliff and not self._on_cliff and self._stops_at_cliffs:
            self._set_speeds(0.0, 0.0)
        self._on_cliff = on_cliff

    def _picture(self) -> Iterable[Any]:
        self._pictures += 1
        with self._twin.body() as body:
            frame = body.frame()
        return picture.pieces(
            frame,
            colour=self._coloured,
            number=self._pictures,
            timestamp=self._milliseconds(),
        )


def _rgb(colour: int) -> RGB:
    """Convert five bits each of red, green and blue to values from 0 to 255."""
    red, green, blue = ((colour >> shift & 31) * 255 // 31 for shift in (10, 5, 0))
    return red, green, blue
