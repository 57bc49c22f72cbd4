import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from learnblock.errors import FrameError, TagSizeError
from learnblock.i18n import Phrase
from learnblock.perception.detectors.tags import crossing, detect_tags
from learnblock.simulator.textures import tag

# A tag's black square takes eight tenths of its poster.
QUIET_ZONE = 1.25


@pytest.fixture(scope="module")
def picture_of():
    """Return a function that draws each tag once."""
    drawn = {}

    def picture(number):
        return drawn.setdefault(number, tag(number))

    return picture


def numbers_in(frame):
    return [found.id for found in detect_tags(frame)]


def on_sheet(*placed):
    """Return a grey frame with tags of 80 pixels at (number, left, top)."""
    frame = np.full((240, 320, 3), 200, np.uint8)
    for number, left, top in placed:
        frame[top : top + 80, left : left + 80] = tag(number)
    return frame


def test_three_of_four_views_near_far_and_askew_are_read_and_none_wrongly(photograph, picture_of):
    generator = np.random.default_rng(2026)
    read = wrong = 0
    for _ in range(300):
        number = int(generator.integers(587))
        frame = photograph(
            picture_of(number),
            100 * QUIET_ZONE,
            distance=generator.uniform(150, 2200),
            angle=generator.uniform(-70, 70),
            raised=generator.uniform(-20, 20),
            heading=generator.uniform(-8, 8),
            pitch=generator.uniform(-4, 4),
            focal=290,
            sigma=3,
            generator=generator,
        )
        found = numbers_in(frame)
        read += number in found
        wrong += any(other != number for other in found)
    assert wrong == 0
    assert read >= 0.73 * 300


def test_a_tag_of_80_mm_is_read_in_every_view_up_to_a_metre_and_30_degrees(photograph, picture_of):
    generator = np.random.default_rng(80)
    for _ in range(50):
        number = int(generator.integers(587))
        distance, angle = generator.uniform(250, 1000), generator.uniform(-30, 30)
        frame = photograph(
            picture_of(number),
            80 * QUIET_ZONE,
            distance=distance,
            angle=angle,
            generator=generator,
        )
        assert [number] == numbers_in(frame), f"{distance:.0f} mm, {angle:.0f} degrees"


def margin(size, distance, angle, focal):
    """Return the pixels between a tag's black square straight ahead and the nearest frame edge."""
    half = size / 2
    ahead = distance - half * abs(math.sin(math.radians(angle)))
    high = focal * half / ahead
    wide = focal * half * math.cos(math.radians(angle)) / ahead
    return min(119.5 - high, 159.5 - wide)


@pytest.mark.parametrize("focal", [290, 480])
@pytest.mark.parametrize(("number", "angle"), [(8, 0), (123, 15), (586, -35)])
def test_an_approach_reads_the_tag_in_every_frame_until_it_no_longer_fits(
    photograph, picture_of, focal, number, angle
):
    generator = np.random.default_rng(number)
    missed = []
    # OpenCV ignores everything within three pixels of the frame's edge.
    path = [d for d in range(900, 100, -4) if margin(120, d, angle, focal) > 3.5]
    for distance in path:
        frame = photograph(
            picture_of(number),
            120 * QUIET_ZONE,
            distance=distance,
            angle=angle,
            focal=focal,
            generator=generator,
        )
        if numbers_in(frame) != [number]:
            missed.append(distance)
    assert missed == []
    assert len(path) > 120


@pytest.mark.parametrize(("distance", "tolerance"), [(200, 0.01), (500, 0.02), (1000, 0.04)])
def test_the_distance_is_given_if_lens_and_size_are_known(
    photograph, picture_of, distance, tolerance
):
    generator = np.random.default_rng(3)
    frame = photograph(
        picture_of(8), 80 * QUIET_ZONE, distance=distance, angle=20, generator=generator
    )
    (found,) = detect_tags(frame, focal=480, size=80)
    assert distance == pytest.approx(found.distance, rel=tolerance)


@pytest.mark.parametrize("angle", [-35, 0, 20, 40])
def test_the_pose_has_the_position_and_rotation_of_a_tag(photograph, picture_of, angle):
    generator = np.random.default_rng(3)
    frame = photograph(
        picture_of(8),
        80 * QUIET_ZONE,
        distance=400,
        angle=angle,
        aside=30,
        raised=20,
        generator=generator,
    )
    pose = detect_tags(frame, focal=480, size=80)[0].pose
    assert (pose.x, pose.y, pose.z) == pytest.approx((30, 20, 400), abs=8)
    assert (pose.yaw, pose.pitch, pose.roll) == pytest.approx((-angle, 0, 0), abs=6)


def test_without_lens_or_size_there_is_no_distance():
    frame = on_sheet((5, 100, 80))
    assert [
        detect_tags(frame, focal=480)[0].distance,
        detect_tags(frame, size=80)[0].distance,
    ] == [None, None]


def test_the_center_of_a_slanted_tag_is_the_image_of_its_middle(photograph, picture_of):
    generator = np.random.default_rng(1)
    frame = photograph(picture_of(8), 150, distance=300, angle=50, generator=generator)
    assert detect_tags(frame)[0].center == pytest.approx((159.5, 119.5), abs=0.6)


def test_tags_come_by_number_then_from_left_to_right():
    found = detect_tags(on_sheet((9, 10, 10), (4, 120, 130), (4, 10, 130), (7, 230, 10)))
    expected = [(4, 49), (4, 159), (7, 269), (9, 49)]
    assert expected == [(seen.id, int(seen.center[0])) for seen in found]


def test_a_detection_knows_the_size_of_a_frame_twice_as_large(photograph, picture_of):
    generator = np.random.default_rng(1)
    frame = photograph(picture_of(8), 100, distance=1500, scale=2, generator=generator)
    (found,) = detect_tags(frame)
    assert (found.frame_width, found.frame_height) == (640, 480)


def test_a_frame_without_tags_has_none():
    assert detect_tags(np.full((240, 320, 3), 128, np.uint8)) == ()


@pytest.mark.parametrize("seed", range(5))
def test_pure_noise_contains_no_tag(seed):
    frame = np.random.default_rng(seed).integers(0, 256, (240, 320, 3), np.uint8)
    assert detect_tags(frame) == ()


@pytest.mark.parametrize(("focal", "size", "wrong"), [(0, 80, ("focal", 0)), (9, -1, ("size", -1))])
def test_a_lens_or_tag_without_size_is_refused(focal, size, wrong):
    with pytest.raises(TagSizeError) as refused:
        detect_tags(on_sheet(), focal=focal, size=size)
    name, value = wrong
    assert refused.value.phrase == Phrase("perception-tag-size", name=name, value=value)


def test_anything_but_a_picture_is_refused():
    with pytest.raises(FrameError):
        detect_tags(None)


columns = st.floats(0, 1920, width=32)


@given(st.lists(st.tuples(columns, columns), min_size=4, max_size=4))
def test_the_diagonals_meet_where_numpy_says_to_the_last_bit(corners):
    a, b, c, d = np.column_stack([np.array(corners), np.ones(4)])
    meeting = np.cross(np.cross(a, c), np.cross(b, d))
    assume(meeting[2])

    assert crossing(corners) == (meeting[0] / meeting[2], meeting[1] / meeting[2])
