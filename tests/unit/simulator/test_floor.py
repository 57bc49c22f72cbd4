import gc
import subprocess
import sys
from pathlib import Path
from weakref import ref

import cv2
import numpy as np
import pytest

from learnblock.simulator import World, load_world
from learnblock.simulator.colours import reflectance


def world(tmp_path: Path, text: str) -> World:
    (tmp_path / "w.toml").write_text(text)
    return World(load_world(tmp_path / "w.toml"))


def test_a_white_floor_is_bright_and_its_black_line_dark() -> None:
    line = World(load_world("line"))

    assert line.floor_at(0, 0) > 90
    assert line.floor_at(-60, -500) < 10


def test_red_and_blue_lines_are_dark_for_a_ground_sensor() -> None:
    lines = World(load_world("lines"))

    assert lines.floor_at(0, -500) < 50
    assert lines.floor_at(-800, -600) < 50


def test_outside_the_floor_it_is_dark() -> None:
    assert World(load_world("empty")).floor_at(1001, 0) == 0


def test_on_a_crossing_the_later_line_is_on_top(tmp_path: Path) -> None:
    crossing = world(
        tmp_path,
        '[[line]]\nname = "a"\npoints = [[-500, 0], [500, 0]]\n'
        '[[line]]\nname = "b"\ncolour = "red"\npoints = [[0, -500], [0, 500]]\n',
    )

    assert crossing.floor_at(0, 0) == pytest.approx(reflectance((215, 25, 25)))


@pytest.mark.parametrize("name", ["line", "lines", "labyrinth"])
def test_the_floor_is_as_bright_as_its_picture(name: str) -> None:
    # Ground sensors compute distances and cameras see the drawn raster; the results must agree.
    shown = World(load_world(name))
    image = shown.floor.image.astype(np.float64)
    for x in range(-990, 990, 55):
        for y in range(-990, 990, 55):
            row, column = round(999.5 - y), round(999.5 + x)
            around = image[row - 2 : row + 3, column - 2 : column + 3].reshape(-1, 3)
            if np.ptp(around, axis=0).max() == 0:
                expected = reflectance(tuple(around[0]))
                assert shown.floor_at(x, y) == pytest.approx(expected, abs=1e-6)


def test_a_spot_half_on_the_line_is_half_dark() -> None:
    line = World(load_world("line"))
    dark, bright = line.floor_at(-60, -500), line.floor_at(-60, -400)

    half = line.floor.reflectance(-60, -480, spot=10)

    assert half == pytest.approx((dark + bright) / 2)


def test_a_picture_covers_the_floor_with_north_up(tmp_path: Path) -> None:
    picture = np.full((10, 10, 3), 255, np.uint8)
    picture[:5, :5] = 0
    cv2.imwrite(str(tmp_path / "map.png"), picture)
    pictured = world(tmp_path, '[floor]\nsize = [1000, 1000]\npicture = "map.png"')

    assert pictured.floor_at(-250, 250) == pytest.approx(0, abs=1)
    assert pictured.floor_at(250, 250) == pytest.approx(100, abs=1)
    assert pictured.floor_at(-250, -250) == pytest.approx(100, abs=1)


def test_a_large_floor_is_drawn_coarser(tmp_path: Path) -> None:
    assert world(tmp_path, "").floor.image.shape == (2000, 2000, 3)
    assert world(tmp_path, "[floor]\nsize = [8000, 8000]").floor.image.shape == (2000, 2000, 3)


def test_a_world_without_a_camera_does_not_need_opencv() -> None:
    program = (
        "import sys\n"
        "from learnblock.simulator import World, load_robot, load_world\n"
        "world = World(load_world('line'))\n"
        "robot = world.add_robot(load_robot('thymio'))\n"
        "robot.drive(100, 0)\n"
        "world.step(); robot.ground(); robot.distances()\n"
        "print('cv2' in sys.modules)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)

    assert done.stdout.split() == [b"False"]


LINE = "[[line]]\nwidth = {width}\npoints = [[-500, 0], [500, 0]]\n"


def test_worlds_with_the_same_floor_draw_it_once(tmp_path: Path) -> None:
    drawn = world(tmp_path, LINE.format(width=40)).floor
    same = world(tmp_path, LINE.format(width=40) + "[floor]\nslip = 0.1").floor
    wider = world(tmp_path, LINE.format(width=50)).floor

    assert same.image is drawn.image
    assert not np.array_equal(wider.image, drawn.image)


def test_a_floor_that_is_no_longer_used_is_not_kept(tmp_path: Path) -> None:
    drawn = ref(world(tmp_path, LINE.format(width=41)).floor.mips)
    gc.collect()

    assert drawn() is None


def test_a_picture_that_has_changed_is_read_again(tmp_path: Path) -> None:
    shades = []
    for shade in (0, 255):
        cv2.imwrite(str(tmp_path / "map.png"), np.full((10, 10, 3), shade, np.uint8))
        floor = world(tmp_path, '[floor]\npicture = "map.png"').floor
        shades.append(floor.image.mean())

    assert shades == [0, 255]
