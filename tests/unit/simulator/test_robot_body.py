import math

import msgspec
import numpy as np
import pytest

from learnblock.errors import UnknownNameError
from learnblock.simulator import RobotBody, RobotDescription, World, load_robot, load_world
from learnblock.simulator.camera import CameraView
from learnblock.simulator.robot_description import (
    Body,
    Camera,
    DistanceSensor,
    Gyroscope,
    LightSensor,
    Wheels,
)
from learnblock.simulator.world_description import Box, Floor, Lamp, Tag, WorldDescription

BODY = Body(shape="disc", radius=50, height=80, mass=0.5)
WHEELS = Wheels(radius=20, track=100, maximum_speed=300, error=0)


def robot_with(**devices: object) -> RobotDescription:
    return RobotDescription(body=BODY, wheels=WHEELS, **devices)  # type: ignore[arg-type]


def in_world(
    description: RobotDescription,
    world: WorldDescription | None = None,
    start: tuple[float, float, float] = (0, 0, 0),
) -> tuple[World, RobotBody]:
    made = World(world or WorldDescription())
    return made, made.add_robot(description, start=start)


def run(world: World, seconds: float) -> None:
    for _ in range(round(seconds / world.dt)):
        world.step()


def ranger(**values: object) -> RobotDescription:
    sensor = {"direction": 0.0, "sides": ("front",), "x": 50.0, "maximum": 1000.0} | values
    return robot_with(distance=(msgspec.convert(sensor, DistanceSensor),))


@pytest.mark.parametrize(
    ("direction", "distance"),
    [(0, 650), (90, 700), (180, 750), (-90, 700), (60, 700 / math.cos(math.radians(30)))],
)
def test_a_distance_sensor_measures_to_the_wall_in_its_direction(
    direction: float, distance: float
) -> None:
    world = WorldDescription(floor=Floor(size=(1400.0, 1400.0)))
    _, robot = in_world(ranger(direction=direction), world)

    assert robot.distances()["front"] == pytest.approx([distance], abs=0.1)


def test_nothing_within_range_reads_2000() -> None:
    _, robot = in_world(ranger(maximum=600))

    assert robot.distances() == {"front": [2000.0], "left": [], "right": [], "back": []}


def test_an_object_too_near_reads_as_the_minimum() -> None:
    _, robot = in_world(ranger(minimum=30), start=(940, 0, 0))

    assert robot.distances()["front"] == [30.0]


def test_a_beam_detects_an_object_beside_its_middle() -> None:
    post = WorldDescription(box=(Box(x=450.0, y=-70.0, length=20.0, width=20.0),))
    _, narrow = in_world(ranger(maximum=600), post)
    _, wide = in_world(ranger(maximum=600, beam=20), post)

    assert narrow.distances()["front"] == [2000.0]
    assert wide.distances()["front"][0] == pytest.approx(400, abs=15)


def test_noise_grows_with_the_distance_and_is_the_same_throughout_a_step() -> None:
    world, robot = in_world(ranger(noise=0.02))
    readings = []
    for _ in range(200):
        assert robot.distances() == robot.distances()
        readings.append(robot.distances()["front"][0])
        world.step()

    assert np.mean(readings) == pytest.approx(950, abs=6)
    assert np.std(readings) == pytest.approx(19, abs=4)


def test_robots_see_each_other_and_not_themselves() -> None:
    world, robot = in_world(ranger(x=0), start=(0, 0, 0))
    world.add_robot(robot_with(), "other", (300, 0, 0))

    assert robot.distances()["front"] == pytest.approx([250], abs=0.1)


def test_a_reading_of_ebo_appears_on_each_of_its_sides() -> None:
    _, robot = in_world(load_robot("ebo"), start=(600, 0, 0))
    distances = robot.distances()

    assert {side: len(readings) for side, readings in distances.items()} == {
        "front": 3,
        "left": 2,
        "right": 2,
        "back": 0,
    }
    assert distances["left"][1] == distances["front"][0]
    assert distances["front"][2] == distances["right"][0]


def test_thymio_sees_a_wall_behind_it_and_no_farther_than_its_range() -> None:
    _, robot = in_world(load_robot("thymio"), start=(-900, 0, 0))
    distances = robot.distances()

    assert distances["back"] == pytest.approx([70, 70], rel=0.1)
    assert distances["front"] == [2000, 2000, 2000]


def test_the_ground_sensors_of_thymio_see_the_line_and_its_edge() -> None:
    world = World(load_world("line"))
    robot = world.add_robot(load_robot("thymio"), start=(200, -500, 180))
    on_line = robot.ground()
    robot.place(200, -520, 180)
    beside = robot.ground()

    assert on_line["central"] is None
    assert max(on_line["left"] or 0, on_line["right"] or 0) < 50
    # It faces west, so left is south, off the line.
    assert (beside["left"] or 0) > 50 > (beside["right"] or 0)


def test_cozmo_sees_a_cliff_at_the_edge_and_not_a_line() -> None:
    table = WorldDescription(floor=Floor(border=0.0))
    _, robot = in_world(load_robot("cozmo"), table)
    inside = robot.ground()["central"]
    robot.place(970, 0, 0)

    assert inside == 100
    assert robot.ground()["central"] == 0


def test_a_gyroscope_counts_full_turns_clockwise_until_it_is_reset() -> None:
    world, robot = in_world(robot_with(gyroscope=Gyroscope()))
    robot.drive(0, 180)
    run(world, 5)
    turned = robot.gyroscope()
    robot.reset_gyroscope()

    assert turned == pytest.approx(900, abs=20)
    assert robot.gyroscope() == 0


def test_a_gyroscope_drifts_slowly() -> None:
    world, robot = in_world(robot_with(gyroscope=Gyroscope(drift=0.1)))
    run(world, 10)
    early = robot.gyroscope()
    run(world, 10)

    assert early != 0
    assert robot.gyroscope() == pytest.approx(2 * early)


def test_an_accelerometer_at_rest_measures_gravity() -> None:
    world, robot = in_world(load_robot("cozmo"))
    run(world, 0.1)

    assert robot.acceleration() == pytest.approx((0, 0, 9.81), abs=0.2)


def test_an_accelerometer_measures_a_start_forward_and_a_crash_backward() -> None:
    world, robot = in_world(load_robot("cozmo"), start=(800, 0, 90))
    robot.place(800, 0, 0)
    robot.drive(200, 0)
    run(world, 0.1)
    starting = robot.acceleration()[0]
    sums = []
    for _ in range(200):
        world.step()
        sums.append(robot.acceleration()[0])

    assert starting == pytest.approx(0.8, abs=0.2)
    assert min(sums) < -5


def test_the_bumper_of_the_ev3_is_pressed_by_a_wall() -> None:
    world, robot = in_world(load_robot("ev3"), start=(800, 0, 0))
    before = robot.bumper()
    robot.drive(100, 0)
    run(world, 2)
    pressed = robot.bumper()
    robot.drive(-100, 0)
    run(world, 1)

    assert [before, pressed, robot.bumper()] == [False, True, False]


def test_a_light_sensor_measures_the_lamp_above_it() -> None:
    world = WorldDescription(ambient_light=100.0, light=(Lamp(x=500.0, y=0.0, brightness=600.0),))
    _, robot = in_world(robot_with(light=LightSensor()), world)
    away = robot.light()
    robot.place(500, 0, 0)

    assert robot.light() == 700
    assert away == pytest.approx(100 + 600 / 2)


def test_light_never_exceeds_1023() -> None:
    lamps = (Lamp(x=0.0, y=0.0, brightness=1000.0), Lamp(x=0.0, y=0.0, brightness=1000.0))
    _, robot = in_world(robot_with(light=LightSensor()), WorldDescription(light=lamps))

    assert robot.light() == 1023


def test_a_joint_moves_at_its_speed_to_its_limit() -> None:
    world, robot = in_world(load_robot("ebo"))
    robot.set_joint("CAMERA", -90)
    run(world, 0.1)
    on_the_way = robot.joint("CAMERA")
    run(world, 1)

    assert on_the_way == pytest.approx(-18)
    assert robot.joint("CAMERA") == -45


def test_a_joint_reversed_on_its_way_does_not_jump() -> None:
    world, robot = in_world(load_robot("ebo"))
    robot.set_joint("CAMERA", 40)
    run(world, 0.1)
    robot.set_joint("CAMERA", -40)

    assert robot.joint("CAMERA") == pytest.approx(18)


def test_a_frame_stays_the_newest_until_the_cameras_rate_allows_another() -> None:
    world, robot = in_world(load_robot("ebo"))
    first = robot.frame()
    robot.drive(100, 0)
    frames = []
    for _ in range(4):
        frames.append(robot.frame())
        world.step()

    assert first.shape == (240, 320, 3)
    assert first.dtype == np.uint8
    assert [frame is first for frame in frames] == [True, True, True, False]


def test_a_camera_that_sees_nothing_new_keeps_its_frame() -> None:
    world, robot = in_world(load_robot("ebo"))
    other = world.add_robot(load_robot("ebo"), "other", start=(400, 0, 0))
    first = robot.frame()
    run(world, 1)
    unmoved = robot.frame()
    other.drive(100, 0)
    run(world, 1)

    assert unmoved is first
    assert not np.array_equal(robot.frame(), first)


def test_a_picture_is_drawn_only_when_it_is_looked_at_and_shows_something_new(monkeypatch) -> None:
    drawn = []
    draw = CameraView.picture
    monkeypatch.setattr(CameraView, "picture", lambda view: drawn.append(view) or draw(view))
    world, robot = in_world(load_robot("ebo"))
    robot.drive(100, 0)
    run(world, 1)
    assert len(drawn) == 0

    robot.drive(0, 0)
    run(world, 1)
    for _ in range(100):
        robot.frame()
        world.step()
    assert len(drawn) == 1


def test_a_frame_is_read_only() -> None:
    _, robot = in_world(load_robot("ebo"))

    with pytest.raises(ValueError, match="read-only"):
        robot.frame()[0, 0] = 0


def test_a_camera_on_a_joint_sees_the_line_when_it_is_tilted_down() -> None:
    world = World(load_world("line"))
    robot = world.add_robot(load_robot("ebo"))
    ahead = (robot.frame()[15:225, 120:200].max(axis=2) < 50).sum()
    robot.set_joint("CAMERA", -30)
    run(world, 1)
    middle = robot.frame()[15:225, 120:200].max(axis=2) < 50

    assert middle.mean() > 0.9
    assert ahead < middle.sum()


def test_a_camera_that_is_turned_right_sees_the_tag_move_left() -> None:
    world = WorldDescription(tag=(Tag(id=1, x=500.0, y=0.0, heading=180.0),))
    _, robot = in_world(load_robot("ebo"), world)
    columns = []
    for heading in (0, 10):
        robot.place(0, 0, heading)
        robot._frames.clear()
        dark = robot.frame().max(axis=2) < 40
        columns.append(np.flatnonzero(dark.any(axis=0)).mean())

    # Columns turn by the focal length times the tangent of the angle, seen from the lens.
    assert columns[0] == pytest.approx(159.5, abs=5)
    assert columns[1] - columns[0] == pytest.approx(-480 * math.tan(math.radians(11.2)), rel=0.1)


def test_camera_noise_depends_only_on_the_step() -> None:
    camera = Camera(z=80, focal=300, noise=5)
    frames = []
    for others in (0, 1):
        world, robot = in_world(robot_with(camera=(camera,)))
        for i in range(others):
            world.add_robot(robot_with(), f"other {i}", (-500, 0, 0))
        run(world, 0.05)
        frames.append(robot.frame())

    assert np.array_equal(*frames)
    assert frames[0][:40].std() > 2


def test_an_emotion_without_a_screen_is_a_colour() -> None:
    _, robot = in_world(load_robot("thymio"))
    robot.show_emotion("surprise")

    assert robot.emotion == "surprise"
    assert robot.leds == dict.fromkeys(("Up", "Left", "Right"), (255, 166, 0))


def test_an_emotion_on_a_screen_leaves_the_leds() -> None:
    _, robot = in_world(load_robot("cozmo"))
    robot.show_emotion("joy")

    assert robot.emotion == "joy"
    assert set(robot.leds.values()) == {(0, 0, 0)}


def test_an_led_takes_a_colour_within_0_and_255() -> None:
    _, robot = in_world(load_robot("thymio"))
    robot.set_led("Up", (300, 12, -4))

    assert robot.leds["Up"] == (255, 12, 0)


def test_commands_to_other_devices_are_logged_with_their_time() -> None:
    world, robot = in_world(load_robot("cozmo"))
    run(world, 0.5)
    robot.note("Speaker", "tone", 440, 200)

    assert robot.log == [(0.5, "Speaker", "tone", (440, 200))]


@pytest.mark.parametrize(
    ("read", "message"),
    [
        (lambda robot: robot.gyroscope(), "no device 'Gyroscope'"),
        (lambda robot: robot.reset_gyroscope(), "no device 'Gyroscope'"),
        (lambda robot: robot.acceleration(), "no device 'Accelerometer'"),
        (lambda robot: robot.bumper(), "no device 'Bumper'"),
        (lambda robot: robot.light(), "no device 'LightSensor'"),
        (lambda robot: robot.joint("CAMRA"), "no joint 'CAMRA'. Did you mean 'CAMERA'?"),
        (lambda robot: robot.frame("ROBO"), "no camera 'ROBO'. Did you mean 'ROBOT'?"),
        (lambda robot: robot.show_emotion("joi"), "no emotion 'joi'. Did you mean 'joy'?"),
        (lambda robot: robot.set_led("Up", (0, 0, 0)), "no LED 'Up'"),
    ],
)
def test_a_missing_device_is_reported_by_name(read: object, message: str) -> None:
    _, robot = in_world(load_robot("ebo"))

    with pytest.raises(UnknownNameError, match=message.replace("?", r"\?")):
        read(robot)  # type: ignore[operator]
