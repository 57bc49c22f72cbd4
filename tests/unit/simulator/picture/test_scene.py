import math
import re
from xml.etree import ElementTree

import cv2
import numpy as np
import pytest

from learnblock.simulator.drawing import PenStroke
from learnblock.simulator.goal_description import Goals, Reach
from learnblock.simulator.picture import DrivenRun, PictureScene, draw_png, draw_svg
from learnblock.simulator.picture.palette import GREEN, ORANGE, RED
from learnblock.simulator.robot_description import load_robot
from learnblock.simulator.world_description import WorldDescription
from learnblock.simulator.world_files import load_world, world_names

BODY = load_robot("ebo").body
SVG = "{http://www.w3.org/2000/svg}"
HOSTILE = "</text><script>alert(1)</script>&amp;\x00\ud800\u202e"


def spiral(points: int = 400) -> tuple[tuple[float, float, float, float], ...]:
    angles = np.linspace(0, 6 * math.pi, points).tolist()
    return tuple(
        (20 * a / (6 * math.pi), 30 * a * math.cos(a), 30 * a * math.sin(a), -math.degrees(a))
        for a in angles
    )


def scene(world: str = "line", title: str = "square.bt", **changes: object) -> PictureScene:
    marks = (
        (0.0, "emotion", "joy", 0.0, 0.0),
        (10.0, "goal", "a lap: reached", 200.0, 100.0),
        (20.0, "end", "completed", 565.0, 0.0),
    )
    values: dict[str, object] = {"path": spiral(), "marks": marks}
    drive = DrivenRun(body=BODY, **(values | changes))
    return PictureScene(world=load_world(world), drives=(drive,), title=title)


def parsed(svg: str) -> ElementTree.Element:
    return ElementTree.fromstring(svg.encode())  # noqa: S314 - we wrote it ourselves


def texts(svg: str) -> list[str]:
    return [element.text or "" for element in parsed(svg).iter(f"{SVG}text")]


def pixels(data: bytes) -> np.ndarray:
    return cv2.cvtColor(cv2.imdecode(np.frombuffer(data, np.uint8), 1), cv2.COLOR_BGR2RGB)


def test_a_drawing_is_shown_in_its_colours_and_the_path_is_thin():
    stroke = PenStroke("robot", (1, 200, 3), 8.0, [(0.0, 0.0), (200.0, 0.0)])
    lines = list(parsed(draw_svg(scene(strokes=(stroke,)))).iter(f"{SVG}polyline"))
    drawn = [line for line in lines if line.get("stroke") == "#01c803"]
    assert len(drawn) == 1
    assert any(line.get("stroke-dasharray") == "1 5" for line in lines)


def test_a_dot_of_a_pen_is_drawn():
    dot = PenStroke("robot", (1, 200, 3), 8.0, [(0.0, 0.0)])
    assert "#01c803" in draw_svg(scene(strokes=(dot,)))


@pytest.mark.parametrize("world", world_names())
def test_every_shipped_world_can_be_drawn(world):
    assert "square.bt" in texts(draw_svg(scene(world)))


def test_the_png_is_1200_pixels_wide():
    assert 1200 == pixels(draw_png(scene())).shape[1]


def test_the_same_scene_gives_the_same_bytes():
    assert draw_svg(scene()) == draw_svg(scene())
    assert draw_png(scene()) == draw_png(scene())


def test_a_picture_that_follows_the_theme_is_the_same_one_and_dark_around_its_world():
    themed = draw_svg(scene(), follows_theme=True)
    style = re.search("<style>@media .prefers-color-scheme: dark.{(.*)}</style>\n", themed)
    page = re.findall('<g class="page">(.*?)</g>', themed)
    # The paper comes first, and what is written below last; nothing of the floor is among them.
    assert 'fill="#fdfcf9"' in page[0]
    assert "LearnBlock" in page[-1]
    assert '.page [fill="#fdfcf9"]{fill:#181b22}' in style[1]
    light = themed.replace(style[0], "").replace('<g class="page">', "").replace("</g>", "")
    assert light == draw_svg(scene())


def test_a_picture_is_self_contained():
    root = parsed(draw_svg(scene("faces")))
    links = [value for one in root.iter() for key, value in one.items() if "href" in key]
    assert len(load_world("faces").face) == len(links)
    assert all(link.startswith("data:image/png;base64,") for link in links)
    assert not list(root.iter(f"{SVG}script"))


def test_hostile_texts_are_shown_as_text():
    marks = ((1.0, "emotion", HOSTILE, 0.0, 0.0), (2.0, HOSTILE, HOSTILE, 9.0, 9.0))
    svg = draw_svg(scene(title=HOSTILE, marks=marks))
    assert not list(parsed(svg).iter(f"{SVG}script"))
    assert texts(svg)[0].startswith("</text><script>alert(1)</script>&amp;")
    assert draw_png(scene(title=HOSTILE, marks=marks))


def test_the_title_the_world_and_the_path_are_shown():
    title, subtitle, *_ = texts(draw_svg(scene()))
    assert "square.bt" == title
    assert subtitle.startswith("A closed black line with left and right curves · 5.3")
    assert subtitle.endswith(" m in 20.0 s")


def test_marks_are_labelled_with_their_times():
    shown = texts(draw_svg(scene()))
    for label in ("joy · 0.0 s", "a lap: reached · 10.0 s", "completed · 20.0 s"):
        assert label in shown


def test_a_goal_is_named_until_a_mark_shows_it():
    assert "a lap" not in texts(draw_svg(scene()))
    assert "a lap" in texts(draw_svg(scene(marks=())))


@pytest.mark.parametrize(
    ("marks", "ring"),
    [
        ((), ORANGE),
        (((5.0, "goal", "home: 1: reached", 0.0, 0.0),), GREEN),
        (((5.0, "goal", "home: 1: failed", 0.0, 0.0),), RED),
        (((5.0, "goal", "home: reached", 0.0, 0.0),), ORANGE),
    ],
)
def test_the_ring_of_a_goal_has_the_colour_of_its_outcome(marks, ring):
    goal = Reach(name="home: 1", x=500, y=0, radius=100)
    world = WorldDescription(goal=Goals(reach=[goal]))
    drive = DrivenRun(body=load_robot("thymio").body, marks=marks)
    drawn = parsed(draw_svg(PictureScene(world=world, drives=(drive,)))).iter(f"{SVG}circle")
    [edge] = [one.get("stroke") for one in drawn if one.get("stroke-dasharray")]
    assert edge == "#{:02x}{:02x}{:02x}".format(*ring)


def test_a_reached_goal_has_a_golden_star_and_an_open_one_an_empty_one():
    gold = "#ffc933"
    assert gold in draw_svg(scene())
    assert gold not in draw_svg(scene(marks=()))


def test_a_missed_goal_is_marked_in_red():
    marks = ((5.0, "goal", "a lap: failed", 0.0, 0.0),)
    assert "#c83030" in draw_svg(scene(marks=marks))
    assert "#c83030" not in draw_svg(scene())


def test_a_long_title_is_shrunk_until_it_fits():
    [first, *_] = parsed(draw_svg(scene(title="a" * 100))).iter(f"{SVG}text")
    assert "a" * 100 == first.text
    assert float(first.get("font-size", "0")) < 30


def test_hundreds_of_marks_leave_the_picture_readable():
    marks = tuple((t, "emotion", "joy", x, y) for t, x, y, _ in spiral(500))
    labels = [text for text in texts(draw_svg(scene(marks=marks))) if text.startswith("joy")]
    assert 5 < len(labels) < 25


def test_a_world_without_a_path_can_be_drawn():
    svg = draw_svg(PictureScene(world=load_world("obstacles")))
    assert "Boxes and cylinders; some can be pushed" == texts(svg)[0]
    assert "time" not in texts(svg)


def test_a_robot_that_never_moved_can_be_drawn():
    assert draw_png(scene("empty", path=((0.0, 5.0, 5.0, 90.0),), marks=()))


def test_a_robot_that_fell_off_the_floor_is_still_in_the_picture():
    path = ((0.0, 0.0, 0.0, 0.0), (9.0, 2500.0, 0.0, 0.0))
    image = pixels(draw_png(scene("empty", path=path, marks=())))
    latest = np.abs(image.astype(int) - (250, 155, 60)).sum(axis=2) < 40
    assert latest.any()


def test_a_long_run_makes_a_small_file():
    assert len(draw_svg(scene(path=spiral(100_000)))) < 150_000


def test_the_scale_bar_has_the_length_of_its_label():
    root = parsed(draw_svg(scene("empty", path=(), marks=())))
    assert "200 mm" in [one.text for one in root.iter(f"{SVG}text")]
    lines = [one for one in root.iter(f"{SVG}polyline") if one.get("stroke-width") == "2"]
    left, *_, right = (float(p.split(",")[0]) for p in lines[-1].get("points", "").split())
    grid = [one for one in root.iter(f"{SVG}polyline") if one.get("opacity") == "0.07"]
    first, second = (float(one.get("points", "").split(",")[0]) for one in grid[:2])
    assert right - left == pytest.approx(second - first, abs=0.02)
