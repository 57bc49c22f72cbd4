"""Pupils get the names that teachers and learning platforms give to files and folders."""

import io
import unicodedata
import zipfile
from pathlib import Path

import pytest

from gradings import GOOD
from learnblock.lessons.grading.handed_in import read_all

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
        {
            "Ana Gil": True,
            "Bo Li": "grade-no-program",
            "Cy Ott - a.bt": True,
            "Cy Ott - b.bt": True,
        },
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
    "endings as systems write them": (
        ("ana/SQUARE.BT", "bo/square.bt.txt", "cy/Square.Py.TXT", "di - x.BT", "eva/readme.txt"),
        {"ana": True, "bo": True, "cy": True, "di": True, "eva": "grade-no-program"},
    ),
    "everything below a dot": (("./ana/a.bt", "./bo/b.bt", "./"), {"ana": True, "bo": True}),
    "more programs than anybody hands in": (
        ("ana/a.bt", *(f"bo/{number}.py" for number in range(6))),
        {"ana": True, "bo": "grade-many-programs"},
    ),
}


@pytest.mark.parametrize("kind", ZIPS)
def test_a_zip_gives_each_pupil_a_row(tmp_path, kind):
    names, expected = ZIPS[kind]
    (tmp_path / "class.ZIP").write_bytes(zipped(dict.fromkeys(names, b"")))
    assert graded(tmp_path / "class.ZIP", tmp_path / "out") == expected


def zipped(files):
    """A zip of these files; programs are good ones."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        for name, content in files.items():
            archive.writestr(name, GOOD if ".bt" in name.lower() else content)
    return data.getvalue()


def graded(path, out, report=lambda _: None):
    """Whether there is a program of each pupil, or the reason why not."""
    found = read_all([path], out, report)
    return {one.pupil: one.reason.code if one.reason else True for one in found}


@pytest.mark.parametrize("form", ["NFC", "NFD"])
def test_names_in_utf_8_that_the_zip_does_not_say_so_of_are_right(tmp_path, form):
    name = unicodedata.normalize(form, "José Ñáñez/a.bt")
    zipfile_bytes = zipped({"X" * len(name.encode()): b"", "bo/b.bt": b""})
    # As macOS writes them: in UTF-8, without the flag of UTF-8.
    data = zipfile_bytes.replace(b"X" * len(name.encode()), name.encode())
    (tmp_path / "class.zip").write_bytes(data)
    assert [*graded(tmp_path / "class.zip", tmp_path / "out")] == ["José Ñáñez", "bo"]


def test_names_of_the_first_pcs_stay_what_they_are(tmp_path):
    data = zipped({"JosX/a.bt": b"", "bo/b.bt": b""}).replace(b"JosX", "José".encode("cp437"))
    (tmp_path / "class.zip").write_bytes(data)
    assert [*graded(tmp_path / "class.zip", tmp_path / "out")] == ["José", "bo"]


def test_a_zip_of_a_pupil_is_looked_into(tmp_path):
    inner = zipped({"work/square.bt": b""})
    (tmp_path / "class" / "ana").mkdir(parents=True)
    (tmp_path / "class" / "ana" / "mine.zip").write_bytes(inner)
    (tmp_path / "class" / "Bo Li - Square.ZIP").write_bytes(inner)
    (tmp_path / "class" / "cy.zip").write_bytes(b"no zip")
    (tmp_path / "class" / "di").mkdir()
    for name in ("one.zip", "two.zip"):
        (tmp_path / "class" / "di" / name).write_bytes(inner)
    assert graded(tmp_path / "class", tmp_path / "out") == {
        "Bo Li": True,
        "ana": True,
        "cy": "grade-zip-damaged",
        "di - one/work/square.bt": True,
        "di - two/work/square.bt": True,
    }


def test_a_zip_in_the_zip_of_a_class_is_looked_into(tmp_path):
    inner = zipped({"work/square.bt": b""})
    files = {
        "Ana Gil_12_assignsubmission_file_mine.zip": inner,
        "Bo Li_7_assignsubmission_file_/mine.ZIP": inner,
        "Cy Ott_9_assignsubmission_file_empty.zip": zipped({}),
        "Di Mo_3_assignsubmission_file_broken.zip": b"no zip",
    }
    (tmp_path / "class.zip").write_bytes(zipped(files))
    reports = []
    assert graded(tmp_path / "class.zip", tmp_path / "out", reports.append) == {
        "Ana Gil": True,
        "Bo Li": True,
        "Cy Ott": "grade-no-program",
        "Di Mo": "grade-no-program",
    }
    assert [one.values["names"] for one in reports] == [
        ("Di Mo_3_assignsubmission_file_broken.zip",)
    ]


@pytest.mark.parametrize(
    ("bad", "why"),
    [
        ("Leo/a.bt/b.bt", "below a file"),
        ("/".join(["x" * 200] * 25) + "/b.bt", "a path too long for the system"),
        ("x/" * 2000 + "b.bt", "too many folders"),
    ],
)
def test_what_no_system_can_unpack_is_named_and_left_out(tmp_path, bad, why):
    (tmp_path / "class.zip").write_bytes(zipped({"Leo/a.bt": b"", bad: b"", "bo/b.bt": b""}))
    for _ in ("unpacked", "known from before"):
        reports = []
        found = graded(tmp_path / "class.zip", tmp_path / "out", reports.append)
        assert {name: found[name] for name in ("Leo", "bo")} == {"Leo": True, "bo": True}, why
        [report] = reports
        assert (report.code, report.values["names"]) == ("grade-left-out", (bad[:200],))


def test_a_program_with_a_second_ending_is_read_and_its_copy_repeats_it(tmp_path):
    (tmp_path / "class").mkdir()
    (tmp_path / "class" / "ana.bt.txt").write_text(GOOD)
    [found] = read_all([tmp_path / "class"], tmp_path / "out", lambda _: None)
    assert (found.pupil, found.text, found.file.endswith("/ana.bt")) == ("ana", GOOD, True)
    [again] = read_all([Path(found.file)], tmp_path / "out", lambda _: None)
    assert again == found


def test_a_pupil_without_a_program_is_absent_and_one_with_a_mistake_is_not(tmp_path):
    (tmp_path / "ana").mkdir()
    (tmp_path / "bo.bt").write_text("main: what")
    found = read_all([tmp_path], tmp_path / "out", lambda _: None)
    assert [(one.pupil, one.absence) for one in found] == [("ana", "nothing handed in"), ("bo", "")]


def test_a_folder_that_the_teacher_has_unpacked_gives_the_same_names(tmp_path):
    for name in ("Ana Gil_12_assignsubmission_file_a.bt", "Bo Li_7_assignsubmission_file_b.bt"):
        (tmp_path / name).write_text(GOOD)
    assert [*graded(tmp_path, tmp_path / "out")] == ["Ana Gil", "Bo Li"]
