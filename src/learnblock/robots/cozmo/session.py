"""A connected Cozmo: its reports and its commands."""

import logging
from collections.abc import Callable
from typing import Any

import pycozmo
from pycozmo import lights
from pycozmo import protocol_encoder as packets

from learnblock.client import RobotStatus
from learnblock.errors import RobotConnectionError
from learnblock.robots.cozmo import units
from learnblock.robots.cozmo.camera import Frame, ReceivedPicture
from learnblock.robots.cozmo.halt import resolved
from learnblock.robots.cozmo.link import CozmoLink
from learnblock.robots.cozmo.odometry import CozmoOdometry
from learnblock.robots.cozmo.reception import Reception
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

POLL = 0.005
"""Seconds between two checks for an answer."""
CALIBRATION = 3.0
"""The maximum number of seconds for which the robot calibrates its head and lift."""
FIRST_PICTURE = 1.0
"""The maximum number of seconds that a program waits for the first picture before it starts."""
LOUDEST = 65535

# pycozmo's log is for its developers; users get our own errors.
logging.getLogger("pycozmo").addHandler(logging.NullHandler())


class CozmoSession(pycozmo.Client):  # type: ignore[misc] # pycozmo has no types
    """A connection to a robot that is identified and calibrated.

    Args:
        address: its host name or IP address.
        port: its UDP port.
        timeout: how long to wait for an answer, in seconds.
        clock: the clock of its limits.

    Attributes:
        odometry: the robot's pose.

    Raises:
        RobotConnectionError: no robot responds at this address.
    """

    conn: CozmoLink

    def __init__(
        self, address: str, port: int, timeout: float, clock: SteadyClock = MONOTONIC
    ) -> None:
        place = resolved(address, port)
        super().__init__(place, auto_initialize=False)
        # pycozmo's own connection was never started.
        self.conn.sock.close()
        self.conn = CozmoLink(place, clock)
        self.conn.add_child_dispatcher(self)
        self.odometry = CozmoOdometry()
        self._reception = Reception()
        self._place = f"{address}:{port}"
        self._timeout = timeout
        self._clock = clock
        self._reported = False
        self._calibrating: set[Any] = set()
        self._lights: dict[str, Any] = dict.fromkeys(units.LIGHTS, lights.off_light)
        self._picture: ReceivedPicture | None = None
        self._seen: tuple[ReceivedPicture | None, Frame | None] = (None, None)
        self.start()
        try:
            self._introduce()
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Stop the motors and disconnect, in less than 0.5 s."""
        # First, because an animation may be about to move something.
        self.anim_controller.stop()
        if self.conn.is_open:
            self.stop_all_motors()
            self._show_last_picture()
        self.conn.hang_up()
        self.del_all_handlers()

    def _show_last_picture(self) -> None:
        """Show the picture that a program has set as it ended, and for which no frame was left."""
        queue = self.anim_controller.queue
        pictures = [picture for picture in queue.image_queue if picture is not None]
        # An interrupted behaviour still has pictures in the queue.
        if pictures and not queue.pkt_queue:
            self.conn.send(pictures[-1])

    def check(self) -> None:
        """Check that the robot is still responding.

        Raises:
            RobotConnectionError: it has been silent for too long.
        """
        silence = self.conn.silence
        if silence > self._timeout:
            raise RobotConnectionError("cozmo-silent", place=self._place, seconds=round(silence, 1))

    def status(self) -> RobotStatus:
        """The battery and the link quality from the last reports."""
        return RobotStatus(
            battery=round(self.battery_voltage, 2) if self._reported else None,
            link_quality=self._reception.quality,
            silence=self.conn.silence,
            round_trip=self.conn.round_trip,
        )

    # Reports.

    def frame(self) -> Frame | None:
        """The newest undamaged picture; the same object until a new one arrives."""
        newest = self._picture
        previous, frame = self._seen
        if newest is not None and newest is not previous:
            arrived = newest.frame()
            frame = frame if arrived is None else arrived
            self._seen = (newest, frame)
        return frame

    def on_cliff(self) -> bool:
        """Whether there is no floor under its front."""
        return bool(self.robot_status & pycozmo.robot.RobotStatusFlag.CLIFF_DETECTED)

    @property
    def accelerations(self) -> tuple[float, float, float]:
        """The acceleration forward, left and up in mm/s2."""
        return self.accel.x, self.accel.y, self.accel.z

    @property
    def lift(self) -> float:
        """The lift's height in mm."""
        return float(self.lift_position.height.mm)

    # Commands.

    def light(self, slot: str, red: int, green: int, blue: int) -> None:
        """Set the colour of a lamp on its back; 0 to 255."""
        colour = lights.Color(rgb=(red, green, blue)).to_int16()
        self._lights[slot] = packets.LightState(on_color=colour, off_color=colour)
        self.set_backpack_lights(*self._lights.values())

    def prepare(self, *, colour: bool, stop_at_cliff: bool, volume: int) -> None:
        """Start the camera, and set the cliff stop and the volume (in percent)."""
        self.enable_camera(color=colour)
        self.conn.send(packets.EnableStopOnCliff(enable=stop_at_cliff))
        self.set_volume(LOUDEST * volume // 100)
        until = self._after(FIRST_PICTURE)
        while self._picture is None and not until.is_over:
            self._clock.sleep(POLL)

    # Connecting.

    def _introduce(self) -> None:
        until = self._after(self._timeout)
        if not self.conn.establish(self._timeout):
            raise RobotConnectionError("cozmo-no-answer", place=self._place)
        self._enable_robot()
        self._await(lambda: self.serial_number, until)
        self.conn.send(packets.SetOrigin())
        self.conn.send(packets.SyncTime())
        self._await(lambda: self._reported, until)
        self._await(lambda: not self._calibrating, self._after(CALIBRATION))
        self.anim_controller.enable_animations()
        self.anim_controller.start()

    def _after(self, seconds: float) -> Deadline:
        return Deadline.after(seconds, self._clock)

    def _await(self, holds: Callable[[], Any], until: Deadline) -> None:
        while not holds():
            if until.is_over:
                raise RobotConnectionError("cozmo-not-ready", place=self._place)
            self._clock.sleep(min(POLL, until.left))

    def start(self) -> None:
        self.add_handler(packets.MotorCalibration, self._on_calibration)
        super().start()

    def _on_calibration(self, _link: Any, packet: Any) -> None:
        if packet.calib_started:
            self._calibrating.add(packet.motor_id)
        else:
            self._calibrating.discard(packet.motor_id)

    def _on_robot_state(self, cli: Any, pkt: Any) -> None:
        super()._on_robot_state(cli, pkt)
        origin = (pkt.pose_frame_id, pkt.pose_origin_id)
        self._reception.note(pkt.timestamp)
        self.odometry.follow(origin, pkt.pose_x, pkt.pose_y, pkt.pose_angle_rad)
        self._reported = True

    def _on_image_chunk(self, cli: Any, pkt: Any) -> None:
        # A single byte arrives as a list, which pycozmo cannot handle.
        pkt.data = bytes(pkt.data)
        super()._on_image_chunk(cli, pkt)

    def _process_completed_image(self) -> None:
        # Decoded only when a program reads it.
        data = bytes(self._partial_data[: self._partial_size])
        encoding, resolution = self._partial_image_encoding, self._partial_image_resolution
        self._picture = ReceivedPicture(data, encoding, resolution)
