from pathlib import Path

import pytest

from learnblock.i18n.phrase import translate
from learnblock.simulator import load_world, unreachable_goals, world_names
from learnblock.simulator.reachability import Unreachable

START = "[[start]]\nx = -600\ny = 0\n"
FINISH = '[[goal.reach]]\nname = "finish"\nx = 600\ny = 0\nradius = 100\n'
WALL = "[[wall]]\npoints = [[0, -1000], [0, 1000]]\n"


def found(tmp_path: Path, *texts: str, radius: float = 60) -> list[str]:
    """Return the reasons in English."""
    return [translate(goal.reason, "en") for goal in unreachable(tmp_path, *texts, radius=radius)]


def unreachable(tmp_path: Path, *texts: str, radius: float) -> tuple[Unreachable, ...]:
    (tmp_path / "w.toml").write_text("\n".join(texts))
    return unreachable_goals(load_world(tmp_path / "w.toml"), radius)


def test_nothing_is_said_about_goals_with_a_way_to_them(tmp_path: Path) -> None:
    assert found(tmp_path, START, FINISH) == []


def test_a_goal_behind_a_wall_is_named_with_the_wall(tmp_path: Path) -> None:
    assert found(tmp_path, START, FINISH, WALL) == [
        "The goal 'finish' cannot be reached: a wall is in the way."
    ]


@pytest.mark.parametrize(
    ("thing", "told"),
    [
        ("[[box]]\nx = 600\ny = 0\nlength = 400\nwidth = 400", "a box is"),
        ("[[cylinder]]\nx = 600\ny = 0\nradius = 300", "a cylinder is"),
        (
            '[[prop]]\nkind = "house"\nx = 600\ny = 0\nscale = 3\nsolid = true',
            "solid decoration is",
        ),
        (
            "[[tag]]\nid = 1\nx = 0\ny = 0\nheading = 0\nsize = 2000",
            "a tag or a face is",
        ),
    ],
)
def test_every_sort_of_obstacle_is_named(tmp_path: Path, thing: str, told: str) -> None:
    assert found(tmp_path, START, FINISH, thing) == [
        f"The goal 'finish' cannot be reached: {told} in the way."
    ]


def test_two_sorts_of_obstacle_are_several_things(tmp_path: Path) -> None:
    box = "[[box]]\nx = 600\ny = 0\nlength = 400\nwidth = 400"

    assert found(tmp_path, START, FINISH, WALL, box) == [
        "The goal 'finish' cannot be reached: several things are in the way."
    ]


def test_decoration_and_what_can_be_pushed_are_no_obstacles(tmp_path: Path) -> None:
    crate = '[[prop]]\nkind = "house"\nx = 600\ny = 0\nscale = 4'
    box = "[[box]]\nx = 600\ny = 0\nlength = 400\nwidth = 400\nmass = 0.2"

    assert found(tmp_path, START, FINISH, crate, box) == []


def test_a_goal_outside_the_floor_is_outside(tmp_path: Path) -> None:
    far = '[[goal.stop]]\nname = "far"\nx = 3000\ny = 0'

    assert found(tmp_path, START, far) == [
        "The goal 'far' cannot be reached: it is outside the floor."
    ]


def test_a_goal_in_the_corner_may_be_too_close_to_the_border(tmp_path: Path) -> None:
    corner = '[[goal.stop]]\nname = "corner"\nx = 995\ny = 995\nradius = 10'

    assert found(tmp_path, START, corner) == [
        "The goal 'corner' cannot be reached: it is too close to the wall around the floor."
    ]
    assert found(tmp_path, "[floor]\nborder = 0", START, corner) == []


def test_a_gap_lets_narrow_robots_through_and_stops_wide_ones(tmp_path: Path) -> None:
    gap = "[[wall]]\npoints = [[0, -1000], [0, -100]]\n[[wall]]\npoints = [[0, 100], [0, 1000]]\n"

    assert found(tmp_path, START, FINISH, gap, radius=80) == []
    assert found(tmp_path, START, FINISH, gap, radius=120) != []


def test_the_front_of_a_tag_has_to_be_reached(tmp_path: Path) -> None:
    tag = "[[tag]]\nid = 4\nx = {x}\ny = 0\nheading = 0"
    visit = "[[goal.visit]]\nid = 4\ndistance = 300"

    assert found(tmp_path, START, visit, tag.format(x=0)) == []
    # Before its front, there is only the border.
    assert found(tmp_path, START, visit, tag.format(x=980)) != []


def test_a_line_needs_as_much_of_it_as_its_goal_wants(tmp_path: Path) -> None:
    line = "[[line]]\npoints = [[-600, 0], [600, 0]]"
    follow = "[[goal.follow]]\nfraction = {fraction}\ndistance = 50"

    assert found(tmp_path, START, line, WALL, follow.format(fraction=0.4)) == []
    assert found(tmp_path, START, line, WALL, follow.format(fraction=0.9)) != []


def test_each_place_of_a_tour_counts(tmp_path: Path) -> None:
    tour = "[[goal.tour]]\npoints = [[-300, 0], {second}]"

    assert found(tmp_path, START, WALL, tour.format(second="[-300, 300]")) == []
    assert found(tmp_path, START, WALL, tour.format(second="[300, 300]")) != []


def test_a_robot_on_a_blocked_start_is_put_beside_it(tmp_path: Path) -> None:
    box = "[[box]]\nx = -600\ny = 0\nlength = 200\nwidth = 200"

    assert found(tmp_path, START, FINISH, box) == []


def test_any_start_will_do(tmp_path: Path) -> None:
    assert found(tmp_path, START, '[[start]]\nname = "b"\nx = 600\ny = 300', FINISH, WALL) == []


def test_a_world_full_of_obstacles_has_no_way(tmp_path: Path) -> None:
    full = "[[box]]\nx = 0\ny = 0\nlength = 2000\nwidth = 2000"

    assert found(tmp_path, START, FINISH, full) == [
        "The goal 'finish' cannot be reached: a box is in the way."
    ]


def test_a_goal_is_found_by_its_kind_and_number(tmp_path: Path) -> None:
    (goal,) = unreachable(tmp_path, START, FINISH, WALL, radius=60)

    assert (goal.kind, goal.index) == ("reach", 0)


@pytest.mark.parametrize("name", world_names())
def test_the_goals_of_every_built_in_world_can_be_reached(name: str) -> None:
    assert unreachable_goals(load_world(name), 75) == ()
