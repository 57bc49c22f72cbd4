"""A robot's body on its wheels: its motion, and its contact with other objects."""

import math
from collections.abc import Callable

import pymunk

from learnblock.simulator import robot_description
from learnblock.simulator.chipmunk import angle_of, position_of, set_rotation, set_velocity
from learnblock.simulator.geometry import Point, Pose, forward, wrapped
from learnblock.simulator.physics import DT, GRAVITY, ROBOT, Physics, motion
from learnblock.wheels import Odometry, Wheels, accelerated, body_speeds

TYRE_FRICTION = 0.9
"""The friction of rubber on a dry floor, which limits how hard a robot can push."""
SLIP_PERIOD = 10
"""Steps for which a wheel loses the same part of its rotation: 0.1 s."""


class Chassis:
    """Two driven wheels under a hull.

    The wheels set a target velocity, and the tyres pull the body to it with at most their grip,
    so a wall stops it and a box is pushed if it is not too heavy.

    Args:
        physics: the physics in which it moves.
        description: the description of the robot.
        name: the name in events.
        group: unique to the robot; makes the rays of its sensors pass through its hull.
        errors: the relative errors of the diameters of the left and the right wheel.
        slip: the parts of its rotation that each wheel loses, by the number of periods since the
            start; None on a floor without slip.
    """

    def __init__(
        self,
        physics: Physics,
        description: robot_description.RobotDescription,
        name: str,
        group: int,
        errors: Wheels,
        *,
        slip: Callable[[int], Wheels] | None = None,
    ) -> None:
        hull, self._wheels = description.body, description.wheels
        self._factors = 1 + errors[0], 1 + errors[1]
        self._reach = hull.reach
        shape_of = _disc if hull.shape == "disc" else _box
        self._body, shape = shape_of(hull)
        self._control = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        #: Makes the rays of its own sensors pass through.
        self.filter = shape.filter = pymunk.ShapeFilter(group=group)
        shape.collision_type = ROBOT
        physics.space.add(self._body)
        physics.add(shape, name)
        force = TYRE_FRICTION * hull.mass * GRAVITY
        physics.brake(self._body, self._control, force, force * self._wheels.track / 2)
        self._drivetrain = self._wheels.drivetrain
        self._space = physics.space
        self._target: Wheels = (0.0, 0.0)
        #: The command that set the target.
        self._command = (0.0, 0.0)
        self._speeds: Wheels = (0.0, 0.0)
        #: The distance each wheel has rolled, mm, as counted by an encoder.
        self.rolled: Wheels = (0.0, 0.0)
        self._odometry = Odometry(self._wheels.track)
        self._counted: Wheels = (0.0, 0.0)
        self._slip = slip
        self._lost: Wheels = (0.0, 0.0)
        self._steps = 0
        self._adv = 0.0
        self._omega = 0.0
        self._x = self._y = self._angle = 0.0
        self._pose: Pose | None = None
        self._ahead: Point | None = None
        self._moved = self._moved_before = (0.0, 0.0)
        self.distance_driven = 0.0

    @property
    def pose(self) -> Pose:
        """The pose of the robot; the heading is from -180 to 180."""
        # Many sensors use it within one step.
        if self._pose is None:
            self._pose = Pose(self._x, self._y, wrapped(self.turned))
        return self._pose

    @property
    def turned(self) -> float:
        """The heading in degrees, including full turns."""
        return -math.degrees(self._angle)

    @property
    def acceleration(self) -> tuple[float, float]:
        """The acceleration forward and to the left, m/s², over the last two steps."""
        x, y = self._moved[0] - self._moved_before[0], self._moved[1] - self._moved_before[1]
        angle = self._angle
        scale = 1e-3 / DT**2
        along, across = math.cos(angle), math.sin(angle)
        return (x * along + y * across) * scale, (y * along - x * across) * scale

    @property
    def odometry(self) -> tuple[float, float, float]:
        """The pose by the wheels' encoders, relative to the start; see `Odometry`."""
        # Computed each time, because reading it must not change its last digits.
        now = self._odometry.copy()
        now.roll(*self._uncounted)
        return now.pose

    def touches(self, place: Point, radius: float) -> bool:
        """Whether its hull is within so many mm of a place."""
        if math.hypot(place[0] - self._x, place[1] - self._y) > radius + self._reach:
            return False
        return any(shape.point_query(place).distance <= radius for shape in self._body.shapes)

    def to_world(self, x: float, y: float) -> Point:
        """The world coordinates of a point on the robot (mm forward and left of its middle)."""
        if self._ahead is None:
            self._ahead = forward(self.pose.heading)
        along, across = self._ahead
        return self._x + x * along - y * across, self._y + x * across + y * along

    def place(self, pose: Pose) -> None:
        """Lift it to `pose` and set it down at rest; the distance driven is unchanged."""
        self._body.position = self._x, self._y = pose.x, pose.y
        # The nearest angle in that direction, so that `turned` does not jump by full turns.
        self._angle -= math.radians(wrapped(pose.heading - self.turned))
        self._body.angle = self._angle
        self._body.velocity = self._control.velocity = 0.0, 0.0
        self._body.angular_velocity = self._control.angular_velocity = 0.0
        self._speeds = (0.0, 0.0)
        self._adv = self._omega = 0.0
        self._pose = self._ahead = None
        self._moved = self._moved_before = (0.0, 0.0)
        self._space.reindex_shapes_for_body(self._body)

    @property
    def motion(self) -> tuple[object, ...]:
        """How it moves now: where its body and its wheels are, and how fast."""
        return motion(self._body), self.rolled, self.distance_driven

    @property
    def speed(self) -> tuple[float, float]:
        """(mm/s forward, degrees/s clockwise) at which its wheels turn now."""
        return body_speeds(self._speeds, self._wheels.track)

    def drive(self, adv: float, rot: float) -> None:
        """Set the target speeds, mm/s and degrees/s clockwise, as far as the wheels allow."""
        if (adv, rot) == self._command:
            # A loop may command the same a hundred times per second.
            return
        self._command = adv, rot
        self._target = self._drivetrain.wheels(adv, rot)

    def before_step(self) -> None:
        """Set the direction in which the tyres pull."""
        accelerates = self._speeds != self._target
        if accelerates:
            self._count()
            change = self._wheels.acceleration * DT
            self._speeds = accelerated(self._speeds, self._target, change)
        left, right = self._speeds
        if left != 0.0 or right != 0.0:
            self.rolled = self.rolled[0] + left * DT, self.rolled[1] + right * DT
        if accelerates or (self._slip and self._steps % SLIP_PERIOD == 0):
            self._pull()
        self._steps += 1
        if self._adv != 0.0:
            # The heading halfway through the next step, in which this velocity takes effect:
            # with it a driven circle neither grows nor shrinks.
            angle = self._angle + 1.5 * DT * self._omega
            adv = self._adv
            set_velocity(self._control, (adv * math.cos(angle), adv * math.sin(angle)))

    def after_step(self) -> None:
        """Update pose, distance and acceleration after a step."""
        x, y = position_of(self._body)
        moved = x - self._x, y - self._y
        self._moved_before, self._moved = self._moved, moved
        self.distance_driven += math.hypot(*moved)
        self._x, self._y, self._angle = x, y, angle_of(self._body)
        self._pose = self._ahead = None

    def _count(self) -> None:
        """Process what the wheels have rolled at their speeds so far."""
        self._odometry.roll(*self._uncounted)
        self._counted = self.rolled

    @property
    def _uncounted(self) -> Wheels:
        return self.rolled[0] - self._counted[0], self.rolled[1] - self._counted[1]

    def _pull(self) -> None:
        """Set the velocity to which the tyres pull, from the speeds of the wheels."""
        if self._slip and self._steps % SLIP_PERIOD == 0:
            self._lost = self._slip(self._steps // SLIP_PERIOD)
        (left, right), factors, lost = self._speeds, self._factors, self._lost
        left = left * factors[0] * (1 - lost[0])
        right = right * factors[1] * (1 - lost[1])
        self._adv = (left + right) / 2
        self._omega = (right - left) / self._wheels.track
        set_rotation(self._control, self._omega)
        if self._adv == 0.0:
            self._control.velocity = 0.0, 0.0


def _disc(hull: robot_description.Body) -> tuple[pymunk.Body, pymunk.Shape]:
    radius = hull.radius or 0.0
    body = pymunk.Body(hull.mass, pymunk.moment_for_circle(hull.mass, 0, radius))
    return body, pymunk.Circle(body, radius)


def _box(hull: robot_description.Body) -> tuple[pymunk.Body, pymunk.Shape]:
    body = pymunk.Body(hull.mass, pymunk.moment_for_poly(hull.mass, hull.outline))
    return body, pymunk.Poly(body, hull.outline)
