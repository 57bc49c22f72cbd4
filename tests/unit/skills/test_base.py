import pytest

from learnblock.devices import Base, Gyroscope
from learnblock.errors import DeviceValueError, StillTurningError
from learnblock.i18n import Phrase
from learnblock.testing import FakeRobot


@pytest.mark.parametrize(
    ("skill", "args", "speed"),
    [
        ("move_straight", (), (40, 0)),
        ("move_straight", (-25,), (-25, 0)),
        ("move_left", (), (20, -15)),
        ("move_right", (), (20, 15)),
        ("turn_left", (), (0, -23)),
        ("turn_right", (), (0, 23)),
        ("set_move", (30, -5), (30, -5)),
        ("stop_bot", (), (0, 0)),
    ],
)
def test_a_driving_skill_sets_both_speeds(robot, skill, args, speed):
    getattr(robot, skill)(*args)

    assert [("Base.move", *speed)] == robot.commands


def test_speeds_can_be_given_by_name(robot):
    robot.move_left(rotSpeed=-30, advSpeed=80)

    assert [("Base.move", 80, -30)] == robot.commands


def test_the_robot_keeps_driving_while_the_program_waits(robot):
    robot.move_straight()
    robot.sleep(5)

    assert pytest.approx((200, 0, 0)) == robot.wheels.pose


@pytest.mark.parametrize("angle", [90, -90, 33.3, -5, 720])
def test_turning_with_a_gyroscope_ends_within_a_degree_and_stops(robot, angle):
    robot.turn(angle)

    assert angle == pytest.approx(robot.wheels.pose[2], abs=1)
    assert ("Base.move", 0, 0) == robot.commands[-1]


def test_turning_speeds_up_and_slows_down_gently(robot):
    robot.turn(90)

    speeds = [rot for _, _, rot in robot.commands if rot]
    fastest = speeds.index(120)
    assert list(range(5, 120, 5)) == speeds[:fastest]
    assert sorted(speeds[fastest:], reverse=True) == speeds[fastest:]
    assert 10 == speeds[-1]


def test_turning_by_zero_does_not_move(robot):
    robot.turn(0)

    assert 0 == robot.wheels.pose[2]


def test_a_robot_that_rocks_too_far_turns_back(robot):
    def rock(seconds: float) -> None:
        sleep(seconds)
        # The first time the robot comes to rest after turning, it is pushed by ten degrees.
        if seconds == pytest.approx(0.2) and robot.wheels.pose[2] and not pushes:
            pushes.append(10)
            robot.wheels.pose = (0, 0, robot.wheels.pose[2] + 10)

    pushes: list[float] = []
    sleep, robot.clock.sleep = robot.clock.sleep, rock
    robot.turn(45)

    assert [10] == pushes
    assert robot.wheels.pose[2] == pytest.approx(45, abs=1)


def test_a_stuck_robot_raises_instead_of_waiting_forever(robot):
    robot.wheels.stuck = True

    with pytest.raises(StillTurningError) as caught:
        robot.turn(90)
    assert caught.value.phrase == Phrase("skill-still-turning", turned=0, angle=90, seconds=3)
    assert ("Base.move", 0, 0) == robot.commands[-1]


def test_without_a_gyroscope_a_turn_follows_the_wheels():
    with FakeRobot(only=[Base]) as robot:
        robot.turn(-90)

        assert robot.wheels.pose[2] == pytest.approx(-90, abs=1)
        assert ("Base.move", 0, 0) == robot.commands[-1]


@pytest.mark.parametrize(
    ("skill", "angle"), [("turn_90_left", -90), ("turn_90_right", 90), ("turn_back", 180)]
)
def test_quarter_and_half_turns_are_closed_loops(robot, skill, angle):
    getattr(robot, skill)()

    assert angle == pytest.approx(robot.wheels.pose[2], abs=1)


@pytest.mark.parametrize("angle", ["a lot", None, float("nan"), True])
def test_an_angle_that_is_not_a_number_is_refused_by_name(robot, angle):
    with pytest.raises(DeviceValueError, match="'angle' must be a"):
        robot.turn(angle)


def test_the_orientation_is_relative_to_the_last_reset(robot):
    robot.turn(50)
    robot.reset_orientation()
    robot.set_orientation(-90)

    assert robot.wheels.pose[2] == pytest.approx(50 - 90, abs=3)


def test_a_reset_is_seen_at_once_although_no_time_passes(robot):
    robot.turn(50)
    robot.reset_orientation()

    assert 0 == robot.read(Gyroscope, "Z_AXIS")


@pytest.mark.parametrize(
    ("start", "angle", "end"), [(270, 360, 360), (10, 350, -10), (0, 180, 180)]
)
def test_an_orientation_is_reached_by_the_shorter_way(robot, start, angle, end):
    robot.wheels.pose = (0, 0, start)
    robot.set_orientation(angle)

    assert end == pytest.approx(robot.wheels.pose[2], abs=2)


def test_an_orientation_is_reached_at_five_to_fifteen_degrees_per_second(robot):
    robot.set_orientation(90)

    speeds = [rot for _, _, rot in robot.commands if rot]
    assert (15, 5) == (max(speeds), min(speeds))


def test_the_paper_s_square_ends_where_it_began(robot):
    angle = 90
    robot.reset_orientation()
    for _ in range(4):
        robot.move_straight()
        robot.sleep(5)
        robot.stop_bot()
        robot.set_orientation(angle)
        angle += 90

    x, y, heading = robot.wheels.pose
    assert (0, 0) == (pytest.approx(x, abs=15), pytest.approx(y, abs=15))
    assert heading == pytest.approx(360, abs=2)


def test_without_a_gyroscope_the_orientation_follows_the_wheels():
    with FakeRobot(only=[Base]) as robot:
        robot.turn(30)
        robot.reset_orientation()
        robot.set_orientation(180)
        robot.set_orientation(270)

        assert robot.wheels.pose[2] % 360 == pytest.approx(300, abs=4)


def test_a_stuck_robot_cannot_be_oriented(robot):
    robot.wheels.stuck = True

    with pytest.raises(StillTurningError, match="turned only 0 of -30 degrees"):
        robot.set_orientation(-30)


def test_slowing_down_takes_a_tenth_of_a_second_per_step(robot):
    robot.set_move(40, -15)
    robot.slow_down(5, 3)

    assert ("Base.move", 35, -12) == robot.commands[-1]
    assert 0.1 == robot.clock.time()


@pytest.mark.parametrize("speed", [(3, -1), (-3, 1), (2, 0), (0, -2)])
def test_slowing_down_never_reverses(robot, speed):
    robot.set_move(*speed)
    robot.slow_down(10, 10)

    assert ("Base.move", 0, 0) == robot.commands[-1]


def test_slowing_down_a_stopped_robot_takes_no_time(robot):
    robot.slow_down()

    assert 0 == robot.clock.time()
    assert [] == robot.commands


@pytest.mark.parametrize(
    ("speed", "questions"),
    [
        ((40.5, 0.0), {"is_moving_straight"}),
        ((-40, 0), {"is_moving_straight"}),
        ((20, -15.5), {"is_moving_left"}),
        ((20, 15), {"is_moving_right"}),
        ((0, -0.5), {"is_turning", "is_turning_left"}),
        ((0, 23), {"is_turning", "is_turning_right"}),
        ((0, 0), set()),
    ],
)
def test_questions_about_movement_use_the_last_command(robot, speed, questions):
    asked = [
        "is_moving_straight",
        "is_moving_left",
        "is_moving_right",
        "is_turning",
        "is_turning_left",
        "is_turning_right",
    ]
    robot.set_move(*speed)

    assert questions == {question for question in asked if getattr(robot, question)()}


def test_the_heading_counts_since_its_reset(robot):
    robot.turn(30)
    robot.reset_orientation()
    robot.turn(-90)

    assert robot.get_heading() == pytest.approx(-90, abs=1)
