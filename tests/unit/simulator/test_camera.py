import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gate import examples
from learnblock.simulator.camera import CameraModel, CameraPose, Surface, canvas, render
from learnblock.simulator.camera.facet import Facet
from learnblock.simulator.camera.mip_chain import MipChain

MODEL = CameraModel(320, 240, 290)
BLACK = (0, 0, 0)
WHITE = np.full((1, 1, 3), 255, np.uint8)
AT_ORIGIN = CameraPose(0, 0, 0)


def plain(*colour):
    return np.full((1, 1, 3), colour, np.uint8)


def facing_west(x, *, width=100.0, height=100.0, y=0.0, z=0.0, texture=WHITE, **options):
    """Return an upright quad whose front faces a camera at the origin that faces east."""
    left, right, top, bottom = y + width / 2, y - width / 2, z + height / 2, z - height / 2
    corners = [(x, left, top), (x, right, top), (x, right, bottom), (x, left, bottom)]
    return Surface(np.array(corners), texture, **options)


def ground(texture, half=2000.0):
    corners = [(-half, half, 0), (half, half, 0), (half, -half, 0), (-half, -half, 0)]
    return Surface(np.array(corners, float), texture, "floor")


def random_quad(generator):
    """Return a rectangle in front of the camera, turned in any direction."""
    turn, _ = np.linalg.qr(generator.normal(size=(3, 3)))
    side, down = turn[0] * generator.uniform(30, 200), turn[1] * generator.uniform(30, 200)
    middle = np.array([generator.uniform(500, 1500), *generator.uniform(-150, 150, 2)])
    corners = [middle - side - down, middle + side - down, middle + side + down]
    return np.array([*corners, middle - side + down])


def pixel_of(point, model, pose):
    """Compute the pinhole equations by bearing and elevation instead of matrices."""
    east, north, up = point[0] - pose.x, point[1] - pose.y, point[2] - pose.z
    heading, pitch = math.radians(pose.heading), math.radians(pose.pitch)
    ahead = east * math.cos(heading) - north * math.sin(heading)
    right = -east * math.sin(heading) - north * math.cos(heading)
    forward = ahead * math.cos(pitch) + up * math.sin(pitch)
    above = up * math.cos(pitch) - ahead * math.sin(pitch)
    return (
        (model.width - 1) / 2 + model.focal * right / forward,
        (model.height - 1) / 2 - model.focal * above / forward,
    )


def distance_inside(outline, model):
    """Return each pixel's distance from the line of the nearest side; negative is outside."""
    rows, columns = np.mgrid[0 : model.height, 0 : model.width]
    sides = []
    for (x, y), (to_x, to_y) in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        cross = (to_x - x) * (rows - y) - (to_y - y) * (columns - x)
        sides.append(cross / math.hypot(to_x - x, to_y - y))
    inside = np.min(sides, axis=0)
    return inside if inside.max() > 0 else -np.max(sides, axis=0)


@pytest.mark.parametrize("seed", range(40))
def test_a_quad_covers_its_closed_form_projection_to_within_a_pixel(seed):
    generator = np.random.default_rng(seed)
    corners = random_quad(generator)
    pose = CameraPose(*generator.uniform(-50, 50, 3), *generator.uniform(-10, 10, 2))
    outline = np.array([pixel_of(corner, MODEL, pose) for corner in corners])
    inside = distance_inside(outline, MODEL)
    seen = render([Surface(corners, WHITE)], MODEL, pose, BLACK)[..., 0] > 0
    assert seen[inside > 1].all()
    assert not seen[inside < -1].any()


def test_the_size_in_the_picture_is_focal_times_size_over_distance():
    row = render([facing_west(1000, width=400)], MODEL, AT_ORIGIN, BLACK)[120, :, 0]
    assert pytest.approx(np.count_nonzero(row), abs=1) == 400 * 290 / 1000


def test_an_object_straight_ahead_is_in_the_middle_of_the_picture():
    seen = render([facing_west(1000)], MODEL, AT_ORIGIN, BLACK)[..., 0]
    rows, columns = np.nonzero(seen)
    assert (rows.mean(), columns.mean()) == (119.5, 159.5)


@pytest.mark.parametrize(
    ("pose", "column", "row"),
    [
        (CameraPose(0, 0, 0, heading=10), -1, 0),
        (CameraPose(0, 0, 0, heading=-10), 1, 0),
        (CameraPose(0, 0, 0, pitch=10), 0, 1),
        (CameraPose(0, 0, 0, pitch=-10), 0, -1),
        (CameraPose(0, 100, 0), 1, 0),
        (CameraPose(0, 0, 100), 0, 1),
    ],
)
def test_turning_right_moves_objects_left_and_tilting_up_moves_them_down(pose, column, row):
    rows, columns = np.nonzero(render([facing_west(1000)], MODEL, pose, BLACK)[..., 0])
    moved = (np.sign(round(columns.mean() - 159.5)), np.sign(round(rows.mean() - 119.5)))
    assert (column, row) == moved


@pytest.mark.parametrize("angle", [-60, -30, 0, 30, 60])
def test_a_texture_is_seen_in_perspective(angle):
    halves = np.zeros((64, 64, 3), np.uint8)
    halves[:, :32] = (255, 0, 0)
    halves[:, 32:] = (0, 0, 255)
    dx, dy = 200 * math.sin(math.radians(angle)), 200 * math.cos(math.radians(angle))
    corners = [(800 - dx, dy, 150), (800 + dx, -dy, 150), (800 + dx, -dy, -150)]
    surface = Surface(np.array([*corners, (800 - dx, dy, -150)]), halves)
    row = render([surface], MODEL, AT_ORIGIN, BLACK)[120].astype(int)
    middle = np.count_nonzero(np.cumsum((row[:, 2] > row[:, 0]) > 0) == 0)
    assert pixel_of((800, 0, 0), MODEL, AT_ORIGIN)[0] == pytest.approx(middle - 0.5, abs=1)


def test_the_front_shows_the_texture_upright_and_unmirrored():
    quarters = np.zeros((2, 2, 3), np.uint8)
    quarters[0, 0], quarters[0, 1], quarters[1, 1] = (255, 0, 0), (0, 255, 0), (0, 0, 255)
    seen = render([facing_west(300, texture=quarters)], MODEL, AT_ORIGIN)
    brightest = seen[[82, 82, 157], [122, 197, 197]].argmax(axis=1)
    assert brightest.tolist() == [0, 1, 2]


def test_the_back_of_a_two_sided_surface_is_mirrored():
    halves = np.zeros((2, 2, 3), np.uint8)
    halves[:, 0], halves[:, 1] = (255, 0, 0), (0, 0, 255)
    seen = render([facing_west(300, texture=halves)], MODEL, CameraPose(600, 0, 0, heading=180))
    assert seen[120, [122, 197]].argmax(axis=1).tolist() == [2, 0]


def test_the_back_of_a_one_sided_surface_is_not_drawn():
    surface = facing_west(300, two_sided=False)
    assert not render([surface], MODEL, CameraPose(600, 0, 0, heading=180), BLACK).any()


@pytest.mark.parametrize("order", [1, -1])
def test_the_nearer_surface_hides_the_farther_in_any_order(order):
    surfaces = [
        facing_west(500, texture=plain(255, 0, 0)),
        facing_west(1000, width=800, texture=plain(0, 0, 255)),
    ]
    row = render(surfaces[::order], MODEL, AT_ORIGIN, BLACK)[120]
    assert (row[160].argmax(), row[100].argmax()) == (0, 2)


def test_a_poster_one_mm_in_front_of_a_wall_is_fully_visible_from_two_metres():
    poster = facing_west(1999, texture=plain(255, 0, 0), width=300, height=300)
    wall = facing_west(2000, texture=plain(0, 0, 255), width=4000, height=4000)
    pose = CameraPose(0, 0, 0, heading=7, pitch=3)
    alone = render([poster], MODEL, pose, BLACK)[..., 0] > 0
    together = render([wall, poster], MODEL, pose, BLACK)[..., 0] > 0
    assert np.array_equal(alone, together)


def test_of_two_surfaces_that_cross_each_is_seen_where_it_is_nearer():
    halves = [(500, 300, 100), (1500, -300, 100), (1500, -300, -100), (500, 300, -100)]
    falling = Surface(np.array(halves, float), plain(255, 0, 0))
    rising = Surface(np.array(halves, float) * (1, -1, 1), plain(0, 0, 255))
    row = render([falling, rising], MODEL, AT_ORIGIN, BLACK)[120].astype(int)
    nearer_left, nearer_right = row[80:159], row[161:240]
    assert (nearer_left[:, 0] > nearer_left[:, 2]).all()
    assert (nearer_right[:, 2] > nearer_right[:, 0]).all()


def test_a_floor_below_the_camera_reaches_from_the_horizon_to_the_lower_edge():
    seen = render([ground(WHITE, half=1e6)], MODEL, CameraPose(0, 0, 50), BLACK)[..., 0] > 0
    assert not seen[:120].any()
    assert seen[121:].all()


def test_objects_behind_the_camera_are_not_visible():
    assert not render([facing_west(-500)], MODEL, AT_ORIGIN, BLACK).any()


def test_a_wall_that_passes_the_camera_is_cut_at_the_lens():
    corners = [(-1000, 50, 500), (1000, 50, 500), (1000, 50, -500), (-1000, 50, -500)]
    seen = render([Surface(np.array(corners, float), WHITE)], MODEL, AT_ORIGIN, BLACK)[..., 0] > 0
    horizon = pixel_of((1000, 50, 0), MODEL, AT_ORIGIN)[0]
    assert seen[120, : math.floor(horizon)].all()
    assert not seen[120, math.ceil(horizon) + 1 :].any()


@pytest.mark.parametrize("seed", range(20))
def test_no_crack_opens_between_neighbouring_surfaces_or_levels_of_a_texture(seed):
    generator = np.random.default_rng(seed)
    board = generator.integers(100, 255, (512, 512, 3), np.uint8)
    tiles = [
        Surface(
            np.array([(x, y + 500, 0), (x + 500, y + 500, 0), (x + 500, y, 0), (x, y, 0)], float),
            board,
        )
        for x in range(-2000, 2000, 500)
        for y in range(-2000, 2000, 500)
    ]
    pose = CameraPose(
        *generator.uniform(-400, 400, 2),
        generator.uniform(50, 300),
        generator.uniform(-180, 180),
        -50,
    )
    assert render(tiles, MODEL, pose, BLACK).any(axis=2).all()


def test_a_fine_pattern_far_away_becomes_its_mean():
    stripes = np.zeros((1024, 1024, 3), np.uint8)
    stripes[::2] = 200
    pose = CameraPose(0, 0, 0, 1.3, 0.7)
    striped = render([facing_west(2000, width=300, height=300, texture=stripes)], MODEL, pose)
    grey = render(
        [facing_west(2000, width=300, height=300, texture=plain(100, 100, 100))], MODEL, pose
    )
    assert np.abs(grey.astype(int) - striped).max() < 6


@pytest.mark.parametrize("heading", [-25, 0, 15])
def test_a_thin_line_far_away_on_the_floor_has_no_gaps(heading):
    texture = np.full((2000, 2000, 3), 240, np.uint8)
    texture[:, 1290:1320] = 0
    ground_1_mm = ground(texture, half=1000.0)
    pose = CameraPose(-900, 0, 60, heading)
    columns = render([ground_1_mm], MODEL, pose, (240, 240, 240))[..., 0].min(axis=0)
    line = [pixel_of((305, y, 0), MODEL, pose)[0] for y in (900, -900)]
    within = columns[max(0, math.ceil(line[0])) : min(319, math.floor(line[1]))]
    assert len(within) > 100
    assert within.max() < 205


def test_a_floor_keeps_its_colours():
    seen = render([ground(plain(200, 20, 30))], MODEL, CameraPose(0, 0, 100, 0, -45))
    assert tuple(seen[120, 160].tolist()) == (200, 20, 30)


def test_walls_of_different_headings_differ_in_brightness_and_stay_bright_enough_for_tags():
    def brightness(heading):
        turn = math.radians(heading)
        forward = np.array([math.cos(turn), -math.sin(turn), 0])
        left, up = np.array([math.sin(turn), math.cos(turn), 0]), np.array([0, 0, 1])
        corners = [300 * forward + 100 * (i * left + j * up) for i, j in
                   ((1, 1), (-1, 1), (-1, -1), (1, -1))]  # fmt: skip
        wall = Surface(np.array(corners), WHITE)
        return int(render([wall], MODEL, CameraPose(0, 0, 0, heading))[120, 160, 0])

    brightnesses = {brightness(heading) for heading in (0, 90, 180, 270)}
    assert len(brightnesses) == 4
    assert min(brightnesses) > 180


def noisy(seed, sigma=2.0, level=128):
    model = CameraModel(320, 240, 290)
    noise = (np.random.default_rng(seed), sigma)
    return render([], model, AT_ORIGIN, (level, level, level), noise)


def test_the_same_seed_gives_the_same_picture():
    assert np.array_equal(noisy(7), noisy(7))


def test_another_seed_gives_another_picture():
    assert not np.array_equal(noisy(7), noisy(8))


@pytest.mark.parametrize("sigma", [0.5, 2.0, 8.0])
def test_noise_has_the_given_deviation_and_no_bias(sigma):
    error = noisy(1, sigma).astype(float) - 128
    assert pytest.approx(error.mean(), abs=0.02 * sigma) == 0
    assert sigma == pytest.approx(error.std(), rel=0.15 if sigma < 1 else 0.04)


def test_noise_of_deviation_zero_changes_nothing():
    assert np.array_equal(noisy(1, 0.0), render([], MODEL, AT_ORIGIN, (128, 128, 128)))


@pytest.mark.parametrize(("level", "sign"), [(0, 1), (255, -1)])
def test_noise_stops_at_black_and_white(level, sign):
    error = noisy(1, level=level).astype(int) - level
    assert (sign * error).min() == 0
    assert (sign * error).max() < 10


def test_a_moved_surface_shares_its_smaller_textures():
    surface = facing_west(500, texture=np.zeros((64, 64, 3), np.uint8))
    assert surface.moved(surface.corners + 1).mips.level(3) is surface.mips.level(3)


def test_a_moved_surface_is_seen_where_it_is_now():
    moved = facing_west(500).moved(facing_west(1000, y=50).corners)
    there = facing_west(1000, y=50)
    expected = render([there], MODEL, AT_ORIGIN, BLACK)
    assert np.array_equal(expected, render([moved], MODEL, AT_ORIGIN, BLACK))


def test_the_mip_chain_ends_with_a_single_pixel():
    surface = facing_west(500, texture=np.zeros((100, 300, 3), np.uint8))
    assert surface.mips.level(surface.mips.last).shape == (1, 1, 3)


@given(st.integers(0, 2**32 - 1))
def test_the_short_ways_for_plain_and_grey_textures_draw_the_same_picture(seed):
    generator = np.random.default_rng(seed)
    size = (*generator.integers(2, 300, 2), 1)
    plain_floor = np.full((*size[:2], 3), generator.integers(0, 256, 3), np.uint8)
    grey_board = np.repeat(generator.integers(0, 256, size, np.uint8), 3, axis=2)
    # A part of another one has colours.
    coloured = np.array(grey_board)
    row, column = generator.integers(0, size[:2])
    coloured[row : row + 20, column : column + 20] = generator.integers(0, 256, 3)
    surfaces = [ground(plain_floor)] + [
        Surface(random_quad(generator), board) for board in (grey_board, coloured)
    ]
    pose = CameraPose(*generator.uniform(-50, 50, 2), 120, *generator.uniform(-25, 25, 2))
    picture = render(surfaces, MODEL, pose, BLACK)
    with pytest.MonkeyPatch.context() as patches:
        patches.setattr(MipChain, "is_plain", False)
        patches.setattr(MipChain, "_has_colours", lambda *_: True)
        again = [Surface(surface.corners, surface.texture) for surface in surfaces]

        assert np.array_equal(render(again, MODEL, pose, BLACK), picture)


@settings(max_examples=examples(100, gate=30))
@given(seed=st.integers(0, 2**32 - 1), is_exact=st.booleans())
def test_the_short_ways_past_what_is_hidden_or_beside_the_picture_draw_the_same(seed, is_exact):
    generator = np.random.default_rng(seed)
    board = generator.integers(0, 256, (200, 300, 3), np.uint8)
    # A floor, ground beneath it that shows around it, a wall, and what happens to be there.
    below = ground(plain(90, 90, 90), 9000)
    surfaces = [
        ground(board, generator.choice([100, 2000])),
        below.moved(below.corners - (0, 0, 5)),
        facing_west(1000, texture=board, width=2000),
        Surface(random_quad(generator), plain(1, 2, 3)),
    ]
    x, y, heading, pitch = generator.uniform((-500, -500, -180, -90), (500, 500, 180, 20))
    if is_exact:
        # Planes that are parallel to the picture, or at its edge.
        x, y, heading, pitch = round(x, -2), 0, 90 * round(heading / 90), -45 * round(-pitch / 45)
    pose = CameraPose(x, y, generator.integers(20, 200), heading, pitch)
    picture = render(surfaces, MODEL, pose, BLACK)
    with pytest.MonkeyPatch.context() as patches:
        patches.setattr(canvas, "_is_behind", lambda *_: False)
        patches.setattr(canvas, "_is_ahead", lambda *_: False)
        patches.setattr(Facet, "_seen_depths", lambda *_: (0, math.inf))

        assert np.array_equal(render(surfaces, MODEL, pose, BLACK), picture)


def test_a_picture_without_surfaces_is_its_background():
    seen = render([], CameraModel(4, 3, 2), AT_ORIGIN, (1, 2, 3))
    assert np.array_equal(np.full((3, 4, 3), (1, 2, 3), np.uint8), seen)


@pytest.mark.parametrize(
    "corners",
    [
        np.zeros((3, 3)),
        np.zeros((4, 3)),
        np.full((4, 3), np.nan),
        np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0.2), (0, 1, 0)]),
        np.array([(0, 0, 0), (1, 1, 0), (1, 0, 0), (0, 1, 0)], float),
        np.array([(0, 0, 0), (1, 0, 0), (0.2, 0.2, 0), (0, 1, 0)]),
    ],
    ids=["triangle", "point", "nan", "bent", "crossed", "concave"],
)
def test_corners_that_are_not_a_flat_convex_quad_are_refused_by_name(corners):
    with pytest.raises(ValueError, match="`door` has corners"):
        Surface(corners, WHITE, "door")


@pytest.mark.parametrize(
    "texture", [np.zeros((2, 2, 3)), np.zeros((2, 2), np.uint8), np.zeros((0, 2, 3), np.uint8)]
)
def test_a_texture_that_is_not_an_rgb_image_is_refused_by_name(texture):
    with pytest.raises(ValueError, match=r"`door` has a texture .* expected RGB uint8"):
        Surface(facing_west(1).corners, texture, "door")


@pytest.mark.parametrize("values", [(0, 240, 290), (320, -1, 290), (320, 240, 0.0)])
def test_a_lens_without_size_is_refused(values):
    with pytest.raises(ValueError, match="must be above 0"):
        CameraModel(*values)


@settings(max_examples=examples(100, gate=30))
@given(seed=st.integers(0, 10_000))
def test_a_surface_that_fills_the_picture_is_drawn_as_one_that_does_not(seed):
    generator = np.random.default_rng(seed)
    texture = generator.integers(0, 256, (300, 300, 3), dtype=np.uint8)
    model, pose = CameraModel(40, 30, 40), CameraPose(0, 0, 100, generator.uniform(-9, 9), -60)
    # Something small, nearer to the camera, takes its pixels from the floor.
    x, y, z = np.array((0, 0, 100)) + 20 * pose.axes[2]
    near = facing_west(x, y=y, z=z, width=3, height=3, texture=plain(1, 2, 3))
    filled = render([ground(texture)], model, pose, background=(9, 9, 9))
    partly = render([near, ground(texture)], model, pose, background=(9, 9, 9))
    covered = (partly == (1, 2, 3)).all(axis=2)

    assert 0 < covered.sum() < covered.size
    assert (filled[~covered] == partly[~covered]).all()


def test_a_picture_does_not_show_what_was_drawn_into_another_one():
    model, pose = CameraModel(8, 6, 8), CameraPose(0, 0, 100)
    first = render([], model, pose)
    first[:] = 0
    assert (render([], model, pose) == (200, 215, 230)).all()
