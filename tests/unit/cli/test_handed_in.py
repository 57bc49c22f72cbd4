"""Pupils get the names that teachers and learning platforms give to files and folders."""

import zipfile

import pytest

from gradings import GOOD
from learnblock.cli.handed_in import read_all

#: What is in a zip, and for each pupil whether there is a program, or the reason why not.
ZIPS = {
    "Moodle, in folders": (
        (
            "Ana Gil_12_assignsubmission_file_/square.bt",
            "Bo Li_7_assignsubmission_file_/essay.pdf",
            "Cy Ott_9_assignsubmission_file_/a.bt",
            "Cy Ott_9_assignsubmission_file_/b.bt",
            "Cy Ott_9_assignsubmission_onlinetext_/onlinetext.html",
        ),
        {"Ana Gil": True, "Bo Li": "grade-no-program", "Cy Ott": "grade-many-programs"},
    ),
    "Moodle, without folders": (
        ("Ana Gil_12_assignsubmission_file_square.bt", "Bo Li_7_assignsubmission_file_essay.pdf"),
        {"Ana Gil": True, "Bo Li": "grade-no-program"},
    ),
    "Moodle, two of one name": (
        (
            "Ana Gil_12_assignsubmission_file_/square.bt",
            "Ana Gil_8_assignsubmission_file_/square.bt",
            "Ana Gil_8_assignsubmission_onlinetext_/onlinetext.html",
        ),
        {"Ana Gil (12)": True, "Ana Gil (8)": True},
    ),
    "Moodle, one pupil": (
        ("Ana Gil_12_assignsubmission_file_/inner/a.bt",),
        {"Ana Gil": True},
    ),
    "Google Classroom": (
        ("Square/Ana Gil - Square.bt", "Square/Bo Li - Square.py", "Square/notes.txt"),
        {"Ana Gil": True, "Bo Li": True},
    ),
    "Google Classroom, two of one pupil": (
        ("Square/Ana Gil - a.bt", "Square/Ana Gil - b.bt", "Square/Bo Li - a.bt"),
        {"Ana Gil - a": True, "Ana Gil - b": True, "Bo Li": True},
    ),
    "a folder for each": (
        ("ana/square.bt", "bo/square.bt", "__MACOSX/ana/._square.bt"),
        {"ana": True, "bo": True},
    ),
    "a folder": (("ana/square.bt",), {"ana": True}),
}


@pytest.mark.parametrize("kind", ZIPS)
def test_a_zip_gives_each_pupil_a_row(tmp_path, kind):
    names, expected = ZIPS[kind]
    with zipfile.ZipFile(tmp_path / "class.ZIP", "w") as archive:
        for name in names:
            archive.writestr(name, GOOD if name.endswith(".bt") else "")
    found = read_all([tmp_path / "class.ZIP"], tmp_path / "out")
    assert {one.pupil: one.reason.code if one.reason else True for one in found} == expected


def test_a_folder_that_the_teacher_has_unpacked_gives_the_same_names(tmp_path):
    for name in ("Ana Gil_12_assignsubmission_file_a.bt", "Bo Li_7_assignsubmission_file_b.bt"):
        (tmp_path / name).write_text(GOOD)
    assert [one.pupil for one in read_all([tmp_path], tmp_path)] == ["Ana Gil", "Bo Li"]
