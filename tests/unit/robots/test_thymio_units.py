"""The meaning of a Thymio's numbers, and bytes that are not messages."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import DeviceValueError
from learnblock.robots.thymio import units
from learnblock.robots.thymio.frames import Frames, encoded, signed
from learnblock.robots.thymio.link import GarbledError
from learnblock.robots.thymio.node import READ, AsebaNode
from learnblock.robots.thymio.program import COMMANDS, EVENTS, NATIVES, source
from learnblock.robots.thymio.suite import Packets

KNOWN = {"track": 94.0, "unit": 0.332}


def test_forward_turns_both_wheels_alike():
    assert units.wheels(33.2, 0, **KNOWN) == (100, 100)


def test_clockwise_turns_the_left_wheel_forward():
    left, right = units.wheels(0, 45, **KNOWN)
    assert (left, right) == (111, -111)


def test_backward_is_negative():
    assert units.wheels(-50, 0, **KNOWN) == (-151, -151)


def test_a_curve_that_is_too_fast_keeps_its_shape():
    slow = units.wheels(40, 30, **KNOWN)
    fast = units.wheels(400, 300, **KNOWN)
    assert max(fast) == 500
    assert fast[1] / fast[0] == pytest.approx(slow[1] / slow[0], abs=0.01)


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6))
def test_no_motor_gets_more_than_its_maximum_speed(adv, rot):
    assert all(-500 <= speed <= 500 for speed in units.wheels(adv, rot, **KNOWN))


@pytest.mark.parametrize(
    ("reading", "mm"),
    [(0, 2000.0), (1, 140.0), (1360, 130.0), (1908, 100.0), (3862, 35.0), (4504, 0.0), (9999, 0.0)],
)
def test_a_distance_is_in_mm_and_2000_means_nothing(reading, mm):
    assert units.distance(reading) == pytest.approx(mm, abs=0.1)


def test_distances_are_on_their_sides_from_left_to_right():
    readings = [4504, 3704, 0, 3028, 1908, 2408, 1360]
    assert units.distances(readings) == {
        "left": [0.0, 40.0],
        "front": [40.0, 2000.0, 60.0],
        "right": [60.0, 100.0],
        "back": [80.0, 130.0],
    }


def test_the_ground_runs_from_0_to_100_and_has_no_middle():
    assert units.ground([0, 505]) == {"left": 0.0, "central": None, "right": 50.5}
    assert units.ground([1023, -3]) == {"left": 100.0, "central": None, "right": 0.0}


def test_gravity_is_felt_upwards_at_rest():
    assert units.acceleration([0, 0, 23]) == pytest.approx((0, 0, 9.81))


def test_a_robot_that_leans_to_the_left_is_supported_from_the_right():
    _, left, _ = units.acceleration([23, 0, 0])
    assert left == pytest.approx(-9.81)


def test_a_robot_that_leans_back_is_supported_from_behind():
    forward, _, _ = units.acceleration([0, 23, 0])
    assert forward == pytest.approx(9.81)


def test_lamps_have_32_levels():
    assert [units.level(value) for value in (0, 1, 128, 255)] == [0, 0, 16, 32]


@pytest.mark.parametrize(
    ("tone", "numbers"),
    [
        ((440, 1000), (440, 60)),
        ((440.4, 1), (440, 1)),
        ((440, 0), (440, -1)),
        ((1e9, 1e9), (32767, 32767)),
        ((-5, 100), (0, 6)),
    ],
)
def test_a_tone_is_in_sixtieths_of_a_second_and_no_time_is_silence(tone, numbers):
    assert units.tone(*tone) == numbers


def test_an_unknown_sound_is_rejected_with_the_nearest_name():
    with pytest.raises(DeviceValueError, match="Did you mean 'friendly'"):
        units.sound("frendly")


def test_numbers_are_signed():
    assert [signed(word) for word in (0, 500, 0x7FFF, 0x8000, 0xFE0C, 0xFFFF)] == [
        0,
        500,
        32767,
        -32768,
        -500,
        -1,
    ]


def test_a_message_survives_being_cut_anywhere():
    frame = encoded(0x9005, 7, -1, 500)
    for cut in range(len(frame)):
        frames = Frames()
        assert list(frames.feed(frame[:cut])) == []
        (message,) = frames.feed(frame[cut:])
        assert (message.var_offset, [signed(word) for word in message.var_data]) == (7, [-1, 500])


@given(st.binary(max_size=3000))
def test_any_bytes_are_messages_or_garbled(data):
    node = AsebaNode(1)
    try:
        for message in Frames().feed(data):
            node.take(message)
    except GarbledError:
        return


KINDS = st.sampled_from([0x9000, 0x9001, 0x9002, 0x9003, 0x9005, 0x900A, 0x900C, 0x900D, 3, 7])


@given(st.lists(st.tuples(KINDS, st.lists(st.integers(0, 0xFFFF), max_size=40)), max_size=20))
def test_messages_of_known_kinds_with_any_numbers_describe_a_node_or_are_garbled(messages):
    node = AsebaNode(1)
    try:
        for message in Frames().feed(b"".join(encoded(kind, *words) for kind, words in messages)):
            node.take(message)
    except GarbledError:
        return
    assert node.complete or isinstance(node.lacking, list)
    assert isinstance(node.name, str)


@given(st.binary(max_size=3000))
def test_any_bytes_from_the_suite_are_packets_or_garbled(data):
    try:
        packets = list(Packets().feed(data))
    except GarbledError:
        return
    assert sum(4 + len(packet) for packet in packets) <= len(data)


def test_the_source_for_the_suite_answers_every_command_and_calls_every_function():
    text = source()
    assert [f"onevent {event.name}\n" in text for event in COMMANDS] == [True] * len(COMMANDS)
    assert [f"call {native}(" in text for native in NATIVES.values()] == [True] * len(NATIVES)


def test_the_number_of_an_event_is_its_position():
    assert [event.number for event in EVENTS] == list(range(len(EVENTS)))


def test_the_read_variables_have_the_expected_sizes():
    assert (READ["prox.horizontal"], READ["prox.ground.delta"], READ["acc"]) == (7, 2, 3)
