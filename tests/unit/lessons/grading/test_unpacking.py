"""Of a zip only its programs are unpacked, always into one folder, and never outside of it."""

import zipfile

import pytest

from learnblock.errors import LearnBlockError
from learnblock.lessons.grading import unpacking
from learnblock.lessons.grading.unpacking import unpacked


@pytest.fixture
def zipped(tmp_path):
    """A function that makes a zip of texts by their names."""

    def make(**files):
        with zipfile.ZipFile(tmp_path / "class.zip", "w", zipfile.ZIP_DEFLATED) as archive:
            for name, content in files.items():
                archive.writestr(name, content)
        return tmp_path / "class.zip"

    return make


def test_only_programs_are_unpacked_and_of_the_rest_the_folders(zipped, tmp_path):
    file = zipped(**{"ana/a.bt": "a", "bo/film.mp4": "x", "__MACOSX/ana/._a.bt": "x", "c.py": "c"})
    assert contents(unpacked(file, tmp_path / "out").folder) == {
        "ana/a.bt": "a",
        "bo": None,
        "c.py": "c",
    }


def test_a_file_that_moodle_gives_without_folders_gets_that_of_its_pupil(zipped, tmp_path):
    file = zipped(**{"Ana M. Gil_12_assignsubmission_file_my.bt": "a"})
    folder = "Ana M. Gil_12_assignsubmission_file_"
    assert contents(unpacked(file, tmp_path / "out").folder) == {f"{folder}/my.bt": "a"}


@pytest.mark.parametrize(
    ("name", "instead"),
    [
        ("/root.bt", "root.bt"),
        ("c:\\d.bt", "c__d.bt"),
        (" . /e?.bt", "_/e_.bt"),
        (f"{'ñ' * 200}.bt", f"{'ñ' * 100}.bt"),
    ],
)
def test_no_name_leaves_the_folder_or_is_one_that_a_system_refuses(zipped, tmp_path, name, instead):
    assert contents(unpacked(zipped(**{name: "x"}), tmp_path / "out").folder) == {instead: "x"}
    assert sorted(one.name for one in tmp_path.iterdir()) == ["class.zip", "out"]


def test_hidden_files_and_ways_out_of_the_folder_are_left_out(zipped, tmp_path):
    file = zipped(**{"../up.bt": "x", "a/../../b.bt": "x", ".c.bt": "x", "d.bt": "x"})
    assert contents(unpacked(file, tmp_path / "out").folder) == {"d.bt": "x"}


def test_names_that_become_the_same_are_two_files(zipped, tmp_path):
    found = contents(unpacked(zipped(**{"a?.bt": "1", "a*.bt": "2"}), tmp_path / "out").folder)
    assert sorted(found.values()) == ["1", "2"]


def test_the_same_zip_is_unpacked_once_and_another_one_elsewhere(zipped, tmp_path):
    first = unpacked(zipped(**{"a.bt": "1"}), tmp_path / "out").folder
    (first / "a.bt").write_text("changed")
    assert unpacked(zipped(**{"a.bt": "1"}), tmp_path / "out").folder == first
    assert contents(first) == {"a.bt": "changed"}
    assert contents(unpacked(zipped(**{"a.bt": "2"}), tmp_path / "out").folder) == {"a.bt": "2"}


@pytest.mark.parametrize("damage", [lambda data: b"no zip", lambda data: data[:40] + data[41:]])
def test_a_damaged_zip_is_refused_and_leaves_nothing(zipped, tmp_path, damage):
    file = zipped(**{"a.bt": "main: " * 50})
    file.write_bytes(damage(file.read_bytes()))
    with pytest.raises(LearnBlockError) as refused:
        unpacked(file, tmp_path / "out")
    assert refused.value.phrase.code == "grade-zip-damaged"
    assert [*(tmp_path / "out").iterdir()] == []


def test_a_damaged_entry_is_left_out_and_the_others_are_unpacked(zipped, tmp_path):
    file = zipped(**{"ana/a.bt": "main: " * 50, "bo/b.bt": "b"})
    data = bytearray(file.read_bytes())
    data[40] ^= 255
    file.write_bytes(data)
    found = unpacked(file, tmp_path / "out")
    assert (found.left_out, (found.folder / "bo" / "b.bt").read_text()) == (("ana/a.bt",), "b")


@pytest.mark.parametrize("limit", ["MOST_ENTRIES", "LARGEST_CLASS", "LARGEST_PROGRAM"])
def test_a_zip_bomb_is_refused_or_cut_off(zipped, tmp_path, monkeypatch, limit):
    monkeypatch.setattr(unpacking, limit, 2)
    file = zipped(**{f"{number}.bt": "xxxx" for number in range(3)})
    if limit == "LARGEST_PROGRAM":
        assert {*contents(unpacked(file, tmp_path / "out").folder).values()} == {"xxx"}
        return
    with pytest.raises(LearnBlockError) as refused:
        unpacked(file, tmp_path / "out")
    assert refused.value.phrase.code == "grade-zip-too-large"


def contents(folder):
    """The files in a folder with their texts, and empty folders with None."""
    return {
        path.relative_to(folder).as_posix(): path.read_text() if path.is_file() else None
        for path in folder.rglob("*")
        if path.is_file() or not any(path.iterdir())
    }
