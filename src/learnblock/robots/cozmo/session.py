"""A Cozmo that has been reached: what it reports, and what it can be told."""

import logging
import threading
from collections.abc import Callable
from time import monotonic
from typing import Any

import pycozmo
from pycozmo import lights
from pycozmo import protocol_encoder as packets

from learnblock.errors import RobotConnectionError
from learnblock.robots.cozmo import units
from learnblock.robots.cozmo.camera import Frame, Picture
from learnblock.robots.cozmo.halt import named, resolved, unanswered
from learnblock.robots.cozmo.link import Link
from learnblock.robots.cozmo.odometry import Odometry

POLL = 0.005
"""Seconds after which it is looked whether the robot has answered."""
CALIBRATION = 3.0
"""Seconds that it may take the robot to find out where its head and its lift are."""
FIRST_PICTURE = 1.0
"""Seconds for which a program waits for the camera to begin; then it starts without."""
LOUDEST = 65535

# What pycozmo notes is for its developers; users are told by our own errors.
logging.getLogger("pycozmo").addHandler(logging.NullHandler())


class Session(pycozmo.Client):  # type: ignore[misc] # pycozmo has no types
    """A connection to a robot that has said who it is and how it stands.

    Args:
        address: a name or number in the network.
        port: of UDP.
        patience: seconds within which the robot must have answered.

    Attributes:
        odometry: where it is.

    Raises:
        RobotConnectionError: no robot answers there.
    """

    conn: Link

    def __init__(self, address: str, port: int, patience: float) -> None:
        place = resolved(address, port)
        super().__init__(place, auto_initialize=False)
        # The connection that it has made itself was never started.
        self.conn.sock.close()
        self.conn = Link(place)
        self.conn.add_child_dispatcher(self)
        self.odometry = Odometry()
        self._name = named(address, port)
        self._patience = patience
        self._reported = False
        self._calibrating: set[Any] = set()
        self._lights: dict[str, Any] = dict.fromkeys(units.LIGHTS, lights.off_light)
        self._picture: Picture | None = None
        self._seen: tuple[Picture | None, Frame | None] = (None, None)
        self.start()
        try:
            self._introduce()
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Stop the motors and let go of the robot, in less than 0.5 s."""
        # First, since it may be about to move something.
        self.anim_controller.stop()
        if self.conn.is_open:
            self.stop_all_motors()
        self.conn.hang_up()
        self.del_all_handlers()

    def check(self) -> None:
        """Say so if the robot has not been heard for too long.

        Raises:
            RobotConnectionError: that is so.
        """
        silence = self.conn.silence
        if silence > self._patience:
            raise RobotConnectionError(
                f"{self._name} has been silent for {silence:.1f} s: is it still on and in reach,"
                " and has no other program taken it over?"
            )

    # What it reports.

    def frame(self) -> Frame | None:
        """The newest picture that arrived undamaged: the same object until there is another."""
        newest = self._picture
        seen, frame = self._seen
        if newest is not None and newest is not seen:
            arrived = newest.frame()
            frame = frame if arrived is None else arrived
            self._seen = (newest, frame)
        return frame

    def on_cliff(self) -> bool:
        """Whether there is no floor beneath its front."""
        return bool(self.robot_status & pycozmo.robot.RobotStatusFlag.CLIFF_DETECTED)

    @property
    def accelerations(self) -> tuple[float, float, float]:
        """mm/s2 forward, left and up."""
        return self.accel.x, self.accel.y, self.accel.z

    @property
    def lift(self) -> float:
        """The lift's height, mm."""
        return float(self.lift_position.height.mm)

    # What it is told.

    def light(self, slot: str, red: int, green: int, blue: int) -> None:
        """Light one of the lamps on its back; 0 to 255."""
        colour = lights.Color(rgb=(red, green, blue)).to_int16()
        self._lights[slot] = packets.LightState(on_color=colour, off_color=colour)
        self.set_backpack_lights(*self._lights.values())

    def prepare(self, *, colour: bool, stop_at_cliff: bool, volume: int) -> None:
        """Have it send pictures, mind where the floor ends, and speak as loud as that, of 100."""
        self.enable_camera(color=colour)
        self.conn.send(packets.EnableStopOnCliff(enable=stop_at_cliff))
        self.set_volume(LOUDEST * volume // 100)
        until = monotonic() + FIRST_PICTURE
        while self._picture is None and monotonic() < until:
            threading.Event().wait(POLL)

    # How it is met.

    def _introduce(self) -> None:
        until = monotonic() + self._patience
        if not self.conn.establish(self._patience):
            raise unanswered(self._name, self._patience)
        self._enable_robot()
        self._await(lambda: self.serial_number, until)
        self.conn.send(packets.SetOrigin())
        self.conn.send(packets.SyncTime())
        self._await(lambda: self._reported, until)
        self._await(lambda: not self._calibrating, monotonic() + CALIBRATION)
        self.anim_controller.enable_animations()
        self.anim_controller.start()

    def _await(self, holds: Callable[[], Any], until: float) -> None:
        while not holds():
            if monotonic() > until:
                raise RobotConnectionError(
                    f"{self._name} answers, but did not get ready in time: is the network slow?"
                    " If not, switch the robot off and on"
                )
            threading.Event().wait(POLL)

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
        self.odometry.follow(origin, pkt.pose_x, pkt.pose_y, pkt.pose_angle_rad)
        self._reported = True

    def _on_image_chunk(self, cli: Any, pkt: Any) -> None:
        # A single byte comes as a list, with which pycozmo cannot go on.
        pkt.data = bytes(pkt.data)
        super()._on_image_chunk(cli, pkt)

    def _process_completed_image(self) -> None:
        # Decoded when somebody asks for it.
        data = bytes(self._partial_data[: self._partial_size])
        encoding, resolution = self._partial_image_encoding, self._partial_image_resolution
        self._picture = Picture(data, encoding, resolution)
