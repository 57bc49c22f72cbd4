import contextlib
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from learnblock.errors import FileError, RobotDescriptionError, UnknownNameError, WorldError
from learnblock.simulator import World, load_robot, load_world
from learnblock.simulator.world_files import SHIPPED_WORLDS
from learnblock.storage.toml_source import MAXIMUM_FILE_SIZE
from places import TESTS

MALFORMED = TESTS / "malformed"
WORLDS = sorted((MALFORMED / "worlds").glob("*.toml"))
ROBOTS = sorted((MALFORMED / "robots").glob("*.toml"))


def report(error: FileError) -> str:
    """Return what a person reads: each finding, and then the lines with carets."""
    pointed = [diagnostic.pointed(error.source) for diagnostic in error.diagnostics]
    return "\n".join([*str(error).splitlines(), *pointed]) + "\n"


def test_there_are_enough_examples_of_mistakes() -> None:
    assert len(WORLDS) >= 15
    assert len(ROBOTS) >= 10


@pytest.mark.parametrize("file", WORLDS, ids=lambda file: file.stem)
def test_an_invalid_world_is_reported_with_key_value_and_line(file: Path) -> None:
    with pytest.raises(WorldError) as caught:
        load_world(file)

    assert file.with_suffix(".txt").read_text(encoding="utf-8") == report(caught.value)


@pytest.mark.parametrize("file", ROBOTS, ids=lambda file: file.stem)
def test_an_invalid_robot_is_reported_with_key_value_and_line(file: Path) -> None:
    with pytest.raises(RobotDescriptionError) as caught:
        load_robot(file)

    assert file.with_suffix(".txt").read_text(encoding="utf-8") == report(caught.value)


def test_a_file_that_is_not_utf_8_is_refused(tmp_path: Path) -> None:
    (tmp_path / "w.toml").write_bytes(b'title = "\xff"')

    with pytest.raises(WorldError, match="Byte 9 of the file is not UTF-8"):
        load_world(tmp_path / "w.toml")


def test_a_byte_order_mark_is_ignored(tmp_path: Path) -> None:
    (tmp_path / "w.toml").write_bytes(b'\xef\xbb\xbftitle = "mine"')

    assert load_world(tmp_path / "w.toml").title == "mine"


def test_a_huge_file_is_refused_without_reading_it(tmp_path: Path) -> None:
    (tmp_path / "w.toml").write_text("#" * (MAXIMUM_FILE_SIZE + 1))

    with pytest.raises(WorldError, match="can have at most 262,144"):
        load_world(tmp_path / "w.toml")


def test_too_deeply_nested_brackets_are_refused(tmp_path: Path) -> None:
    (tmp_path / "w.toml").write_text("x = " + "[" * 100_000)

    with pytest.raises(WorldError, match="invalid-toml"):
        load_world(tmp_path / "w.toml")


def test_a_picture_may_not_be_reached_through_a_link_out_of_the_folder(tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    folder.mkdir()
    (tmp_path / "secret.png").write_bytes((MALFORMED / "worlds" / "wide.png").read_bytes())
    try:
        (folder / "map.png").symlink_to(tmp_path / "secret.png")
    except OSError:
        pytest.skip("this system makes no symbolic links")
    (folder / "w.toml").write_text('[floor]\npicture = "map.png"')

    with pytest.raises(WorldError, match="has to be in the same folder as the world's file"):
        load_world(folder / "w.toml")


def test_an_unknown_world_is_answered_with_a_near_name() -> None:
    with pytest.raises(UnknownNameError, match="Did you mean 'labyrinth'"):
        load_world("labyrint")


@pytest.mark.parametrize("name", ["", ".", "..", "../worlds/line", "x" * 300, "line\0", "line/"])
def test_what_can_be_no_name_is_an_unknown_world(name: str) -> None:
    with pytest.raises(UnknownNameError):
        load_world(name)


def test_an_unknown_robot_is_answered_with_a_near_name() -> None:
    with pytest.raises(UnknownNameError, match="Did you mean 'thymio'"):
        load_robot("tymio")


def test_a_path_without_a_file_is_an_unknown_world(tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match="There is no world"):
        load_world(tmp_path / "nowhere.toml")


SLIPS = (
    "nan",
    "-1",
    "1e999",
    "[]",
    "[[0, 0]]",
    "{}",
    "true",
    '"x"',
    "9" * 20,
    "[[]]",
    "2020-01-01",
)
LINES = [
    line for file in SHIPPED_WORLDS.glob("*.toml") for line in file.read_text("utf-8").splitlines()
]


@settings(max_examples=150, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_any_file_loads_or_is_refused_with_a_world_error(
    data: st.DataObject, tmp_path: Path
) -> None:
    lines = data.draw(st.lists(st.sampled_from(sorted(LINES)), max_size=12))
    slip = data.draw(st.sampled_from(SLIPS))
    keys = [number for number, line in enumerate(lines) if "=" in line]
    for number in data.draw(st.lists(st.sampled_from(keys), max_size=2)) if keys else []:
        lines[number] = lines[number].partition("=")[0] + "= " + slip
    (tmp_path / "w.toml").write_text("\n".join(lines), encoding="utf-8")
    with contextlib.suppress(WorldError):
        World(load_world(tmp_path / "w.toml")).step()
