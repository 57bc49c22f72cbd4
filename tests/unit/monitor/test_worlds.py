"""Worlds as the page edits them."""

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gate import examples
from learnblock.errors import LearnBlockError, WorldError
from learnblock.i18n import Phrase
from learnblock.monitor import worlds
from learnblock.robots.simulated import find_world, known_worlds

places = st.floats(-900, 900)
headings = st.floats(-360, 360)
names = st.text(min_size=1, max_size=40)
colours = st.sampled_from(["white", "red"]) | st.lists(st.integers(0, 255), min_size=3, max_size=3)
masses = st.none() | st.floats(0.01, 50)
limits = st.none() | st.floats(0.1, 3600)


def of(**fields):
    return st.fixed_dictionaries(fields)


def several(thing, key=None):
    unique = (lambda one: one[key]) if key else None
    return st.lists(thing, max_size=3, unique_by=unique)


paths = st.lists(
    of(forward=st.floats(1, 500)) | of(turn=st.floats(10, 90), radius=st.floats(10, 500)),
    min_size=1,
    max_size=4,
)
lines = of(name=names, colour=colours, start=st.tuples(places, places, headings), path=paths) | of(
    name=names,
    width=st.floats(2, 500),
    points=st.lists(
        st.tuples(st.integers(-900, 900), st.integers(-900, 900)),
        min_size=2,
        max_size=5,
        unique=True,
    ),
    closed=st.booleans(),
)
edited = of(
    title=st.text(max_size=200),
    ambient_light=st.floats(0, 1023),
    floor=of(
        size=st.tuples(st.floats(1800, 10000), st.floats(1800, 10000)),
        colour=colours,
        border=st.floats(0, 1000),
    ),
    line=several(lines, "name"),
    wall=several(
        of(
            points=st.lists(st.tuples(places, places), min_size=2, max_size=4),
            height=st.floats(1, 1000),
        )
    ),
    box=several(of(x=places, y=places, heading=headings, mass=masses, colour=colours, name=names)),
    cylinder=several(of(x=places, y=places, radius=st.floats(5, 1000), mass=masses)),
    tag=several(of(id=st.integers(0, 586), x=places, y=places, heading=headings)),
    face=several(
        of(emotion=st.sampled_from(["joy", "fear"]), x=places, y=places, heading=headings)
    ),
    light=several(of(x=places, y=places, z=st.floats(50, 5000))),
    start=several(of(x=places, y=places, heading=headings, name=names), "name"),
    goal=of(reach=several(of(x=places, y=places, name=names, time_limit=limits), "name")),
)


@settings(max_examples=examples(150, gate=40))
@given(edited)
def test_a_saved_world_is_read_back_unchanged(values):
    worlds.save_world("mine", values)
    expected = worlds.world_from_values(values)
    assert worlds.world_from_values(worlds.world_values(find_world("mine"))) == expected
    assert worlds.world_lines(find_world("mine")) == worlds.world_lines(expected)


@pytest.mark.parametrize("name", known_worlds())
def test_every_world_of_ours_can_be_edited_and_saved(name):
    values = worlds.world_values(find_world(name))
    worlds.save_world("copy", values)
    assert worlds.world_values(find_world("copy")) == values
    assert worlds.check_world(values) == ()


def test_default_values_are_not_written():
    path = worlds.save_world("plain", worlds.world_values(find_world("empty")))
    assert "ambient_light" not in path.read_text()
    assert "mass" not in path.read_text()


@pytest.mark.parametrize(
    "name",
    ["", ".", "..", "../evil", "a/b", "a\\b", ".hidden", "a.toml", "x" * 41, "a\0", " a", "a\n"],
)
def test_a_world_with_an_invalid_file_name_is_refused(own_home, name):
    with pytest.raises(WorldError, match="wrong-name"):
        worlds.save_world(name, {})
    assert not (own_home / "worlds").exists()


def test_an_invalid_world_is_reported_and_the_file_unchanged():
    path = worlds.save_world("mine", {"title": "good"})
    wrong = {"box": [{"x": 5001, "y": 0}]}
    (problem,) = worlds.check_world(wrong)
    assert "box[1].x" in str(problem)
    assert "5001" in str(problem)
    with pytest.raises(WorldError):
        worlds.save_world("mine", wrong)
    assert path.read_text() == 'title = "good"\n'
    assert [path] == list(path.parent.iterdir())


def test_all_objects_off_the_floor_are_reported_at_once():
    far = {"x": 1500, "y": 0}
    assert len(worlds.check_world({"box": [far], "start": [far]})) == 2


def test_a_world_too_large_to_be_read_is_not_written():
    points = [[i / 7, j / 7] for i in range(20) for j in range(25)]
    line = [{"name": f"line {i}", "points": points} for i in range(50)]
    with pytest.raises(WorldError, match="too-large"):
        worlds.save_world("huge", {"line": line})


@pytest.mark.parametrize("picture", ["../secret.png", "/etc/passwd", "a\0b", "sub/../../x.png"])
def test_a_floor_picture_is_in_the_folder_of_the_world(own_home, picture):
    (own_home / "secret.png").write_bytes(b"\x89PNG\r\n\x1a\n" + bytes(20))
    (problem,) = worlds.check_world({"floor": {"picture": picture}})
    assert problem == Phrase("world-picture-outside", picture=picture)


json = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(
            st.text(max_size=3)
            | st.sampled_from(["x", "y", "id", "points", "path", "reach", "name"]),
            inner,
            max_size=3,
        )
    ),
    max_leaves=12,
)


@settings(max_examples=examples(300, gate=75))
@given(
    st.dictionaries(
        st.sampled_from(["title", "floor", "line", "box", "tag", "goal", "start", "wall", "?"]),
        json | st.lists(json, max_size=2),
        max_size=3,
    )
)
def test_any_values_from_the_page_are_a_world_or_reported_as_invalid(values):
    for problem in worlds.check_world(values):
        assert str(problem)


@pytest.mark.parametrize(
    "picture", [lambda: worlds.tag_picture(5), lambda: worlds.face_picture("joy")]
)
def test_pictures_for_walls_are_square_png_files(picture):
    image = cv2.imdecode(np.frombuffer(picture(), np.uint8), cv2.IMREAD_COLOR)
    assert image.shape[0] == image.shape[1] > 100


@pytest.mark.parametrize(
    "ask",
    [
        lambda: worlds.tag_picture(587),
        lambda: worlds.face_picture("boredom"),
        lambda: worlds.floor_picture("nowhere"),
    ],
)
def test_a_missing_picture_raises_our_own_error(ask):
    with pytest.raises(LearnBlockError):
        ask()


def test_the_picture_of_a_floor_is_the_file_itself(own_home):
    folder = own_home / "worlds"
    folder.mkdir()
    file = cv2.imencode(".png", np.zeros((4, 4, 3), np.uint8))[1].tobytes()
    (folder / "ground.png").write_bytes(file)
    worlds.save_world("mine", {"floor": {"picture": "ground.png"}})
    assert worlds.floor_picture("mine") == file
    assert worlds.floor_picture("empty") is None


def test_a_name_may_have_letters_of_any_language():
    name = "Pista ñandú 2"
    assert worlds.save_world(name, {}).stem == name
    assert find_world(name).name == name
