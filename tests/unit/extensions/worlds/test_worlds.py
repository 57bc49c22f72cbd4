"""The user's own worlds: shared as one file, imported, renamed and deleted."""

import io
import zipfile
from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import UnknownNameError, WorldError
from learnblock.extensions import worlds
from learnblock.extensions.worlds import PackedWorld
from learnblock.robots.simulated import find_world
from shared_worlds import MAT, OTHER_ROOM, ROOM, png


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "home" / "worlds").mkdir(parents=True)
    return tmp_path / "home" / "worlds"


def zipped(**files):
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w") as archive:
        for name, content in files.items():
            archive.writestr(name.replace("__", "."), content)
    return target.getvalue()


def test_an_installed_world_keeps_its_text(own_home):
    assert worlds.install(PackedWorld("room", ROOM)) == "room"
    assert (own_home / "room.toml").read_text() == ROOM


def test_a_world_comes_back_with_its_picture(own_home):
    worlds.install(PackedWorld("mat", MAT, png(20, 10)))
    assert (own_home / "mat.png").read_bytes() == png(20, 10)
    packed = worlds.find("mat")
    assert worlds.unpack(*worlds.pack(packed)) == packed


@given(st.text("ab c-_ñ", min_size=1, max_size=20).map(worlds.plain_name).filter(bool))
def test_a_shared_file_has_the_world_under_its_name(name):
    for packed in (PackedWorld(name, ROOM), PackedWorld(name, MAT, png(4, 4))):
        assert worlds.unpack(*worlds.pack(packed)) == packed


def test_the_same_world_is_installed_once(own_home):
    for _ in range(3):
        assert worlds.install(PackedWorld("room", ROOM)) == "room"
    assert [path.name for path in own_home.iterdir()] == ["room.toml"]


def test_another_world_of_the_same_name_stays_as_it_is(own_home):
    worlds.install(PackedWorld("room", ROOM))
    assert worlds.install(PackedWorld("room", OTHER_ROOM)) == "room-2"
    assert worlds.install(PackedWorld("room", OTHER_ROOM)) == "room-2"
    assert (own_home / "room.toml").read_text() == ROOM
    assert find_world("room-2").title == "Room 2"
    assert find_world("room-2").wall[0].points[1] == (400, 0)


def test_another_picture_of_the_same_name_stays_as_it_is(own_home):
    worlds.install(PackedWorld("mat", MAT, png(20, 10)))
    assert worlds.install(PackedWorld("mat", MAT, png(30, 10))) == "mat-2"
    assert (own_home / "mat.png").read_bytes() == png(20, 10)
    assert find_world("mat-2").floor.picture == "mat-2.png"
    assert (own_home / "mat-2.png").read_bytes() == png(30, 10)


def test_a_built_in_world_is_not_hidden_by_an_imported_one():
    assert worlds.install(PackedWorld("line", ROOM)) == "line-2"


@pytest.mark.parametrize(
    "packed",
    [
        PackedWorld("room", "wall = 3\n"),
        PackedWorld("room", "not TOML"),
        PackedWorld("../room", ROOM),
        PackedWorld("con", ROOM),
        PackedWorld("room", MAT),
        PackedWorld("room", MAT, b"no picture"),
        PackedWorld("room", MAT.replace("mat.png", "../mat.png"), png(4, 4)),
        PackedWorld("room", MAT.replace("mat.png", "/etc/mat.png"), png(4, 4)),
        PackedWorld("room", MAT.replace("mat.png", "a\\u0000b.png"), png(4, 4)),
    ],
)
def test_an_invalid_world_is_refused_and_nothing_is_written(packed, own_home):
    with pytest.raises(WorldError):
        worlds.install(packed)
    assert list(own_home.rglob("*")) == []
    assert [path.name for path in own_home.parent.iterdir()] == ["worlds"]


def test_a_picture_never_takes_the_name_of_a_world(own_home):
    text = MAT.replace("mat.png", "room.toml")
    worlds.install(PackedWorld("mat", text, png(4, 4)))
    assert sorted(path.name for path in own_home.iterdir()) == ["mat.png", "mat.toml"]


@pytest.mark.parametrize(
    ("filename", "content", "code"),
    [
        ("room.txt", b"", "unknown-file"),
        ("room.toml", b"\xff", "not-utf-8"),
        ("room.toml", b" " * 300_000, "too-large"),
        ("room.zip", b"no zip", "no-zip"),
        ("room.zip", zipped(a__png=b""), "no-world"),
        ("room.zip", zipped(a__toml=ROOM, b__toml=ROOM), "no-world"),
        ("room.zip", zipped(**{f"a{i}__toml": "" for i in range(30)}), "too-many-files"),
        ("room.zip", b" " * 13_000_000, "too-large"),
    ],
)
def test_a_file_that_is_no_world_is_refused(filename, content, code):
    with pytest.raises(WorldError) as caught:
        worlds.unpack(filename, content)
    assert [one.code for one in caught.value.diagnostics] == [code]


def test_a_zip_that_unpacks_to_too_much_is_refused():
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a.toml", ROOM)
        archive.writestr("big.png", b"\0" * 20_000_000)
    with pytest.raises(WorldError, match="at most 12 MB"):
        worlds.unpack("a.zip", target.getvalue())


def test_a_zip_of_a_folder_is_read():
    packed = worlds.unpack("any.zip", zipped(**{"mat/mat__toml": MAT, "mat/mat__png": b"x"}))
    assert packed == PackedWorld("mat", MAT, b"x")


@given(st.binary(max_size=200) | st.text(max_size=200).map(str.encode))
def test_any_bytes_are_a_world_or_an_error(content):
    for filename in ("a.toml", "a.zip"):
        with suppress(WorldError):
            name = worlds.install(worlds.unpack(filename, content))
            assert find_world(name).name == name


def test_a_renamed_world_keeps_its_name_for_programs(own_home):
    worlds.install(PackedWorld("room", ROOM))
    worlds.rename("room", "Ana's room")
    assert find_world("room").title == "Ana's room"
    assert find_world("room").wall == find_world("room").wall
    assert [path.name for path in own_home.iterdir()] == ["room.toml"]


def test_a_deleted_world_can_be_restored(own_home):
    worlds.install(PackedWorld("room", ROOM))
    worlds.delete("room")
    assert worlds.own_names() == ()
    worlds.restore("room")
    assert (own_home / "room.toml").read_text() == ROOM


def test_a_restored_world_replaces_no_other(own_home):
    worlds.install(PackedWorld("room", ROOM))
    worlds.delete("room")
    worlds.install(PackedWorld("room", OTHER_ROOM))
    with pytest.raises(WorldError, match="already have a world 'room'"):
        worlds.restore("room")
    assert (own_home / "room.toml").read_text() == OTHER_ROOM


@pytest.mark.parametrize("change", [worlds.delete, worlds.restore, lambda n: worlds.rename(n, "x")])
@pytest.mark.parametrize("name", ["line", "../room", "nothing"])
def test_only_the_users_own_worlds_are_changed(change, name):
    with pytest.raises(UnknownNameError):
        change(name)
