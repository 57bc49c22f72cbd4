"""A class as one file: hostile ones are refused, and leave nothing behind."""

import io
import stat
import zipfile

import pytest

from learnblock.classroom.checking import runs_folder
from learnblock.classroom.class_file import ClassFileError, pack, unpack
from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.roster import FILE, Roster
from learnblock.errors import LearnBlockError
from learnblock.lessons.grading.journal import NAME
from learnblock.server.messages import GivenProgram, GivenWork


@pytest.fixture
def folder(tmp_path):
    """A class with a pupil."""
    Roster(tmp_path / "home" / "7b", "7b").add("Ana")
    return tmp_path / "home" / "7b"


@pytest.fixture
def school(own_home):
    """The folder of classes at school."""
    return own_home / "classes"


def rewritten(folder, tmp_path, change):
    """The file of the class with another content."""
    target = tmp_path / "class.lbclass"
    pack(folder, target)
    with zipfile.ZipFile(target) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    changed = io.BytesIO()
    with zipfile.ZipFile(changed, "w", zipfile.ZIP_DEFLATED) as archive:
        change(files, archive)
        for name, content in files.items():
            archive.writestr(name, content)
    target.write_bytes(changed.getvalue())
    return target


def link(_, archive):
    info = zipfile.ZipInfo("pupils/abcdefghij/projects/link")
    info.external_attr = (stat.S_IFLNK | 0o777) << 16
    archive.writestr(info, "/etc/passwd")


CHANGES = {
    "leads out": lambda files, _: files.update({"../evil": b""}),
    "another folder": lambda files, _: files.update({"server.key": b""}),
    "another folder of a pupil": lambda files, _: files.update({"pupils/abcdefghij/tmp/x": b""}),
    "the class's lock": lambda files, _: files.update({".writer.json": b"{}"}),
    "no class": lambda files, _: files.pop(FILE),
    "a bomb": lambda files, _: files.update({"pupils/abcdefghij/home/x": b"0" * 10_000_000}),
    "a mark of nobody": lambda files, _: files.update({"hand-ins/x/1-03-square.4.json": b"{}"}),
    "a mark beside": lambda files, _: files.update({"hand-ins/abcdefghij/../x.4.json": b"{}"}),
    "other files of a check": lambda files, _: files.update({"checks/1-03-square.4/x": b""}),
    "a link": link,
    "damaged": lambda files, _: files.update({FILE: b"{"}),
    "another title": lambda files, _: files.update(
        {FILE: files[FILE].replace(b'"title":"7b"', b'"title":"../../x"')}
    ),
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_a_hostile_file_is_refused_and_leaves_nothing_behind(folder, school, tmp_path, change):
    file = rewritten(folder, tmp_path, change)
    with pytest.raises(LearnBlockError):
        unpack(file)
    assert list(school.iterdir()) == []


def test_what_is_no_zip_is_refused(tmp_path):
    file = tmp_path / "class.lbclass"
    file.write_bytes(b"no zip")
    with pytest.raises(ClassFileError, match="not the file of a class"):
        unpack(file)


def test_neither_a_key_of_tls_nor_temporary_files_go_into_the_file(folder, tmp_path):
    (folder / "key.pem").write_text("secret")
    [pupil] = Roster(folder, "7b").pupils
    for name in ("tmp/x", "projects/mine.learnblock"):
        file = folder / "pupils" / pupil.id / name
        file.parent.mkdir(parents=True)
        file.write_text("")
    target = tmp_path / "class.lbclass"
    pack(folder, target)
    assert zipfile.ZipFile(target).namelist() == [
        FILE,
        f"pupils/{pupil.id}/projects/mine.learnblock",
    ]


def test_what_was_handed_in_and_the_finished_runs_of_checks_come_along(folder, school, tmp_path):
    [ana] = Roster(folder, "7b").pupils
    shelf = HandInShelf(folder)
    shelf.add(ana.id, GivenWork("1-03-square", 4, GivenProgram("main:\nend\n")))
    shelf.say(ana.id, "1-03-square", 4, note="Well done", mark="10")
    runs = runs_folder(folder, "1-03-square", 4)
    runs.mkdir(parents=True)
    (runs / NAME).write_bytes(b"")
    (runs / ".grading.lock").write_bytes(b"")
    pack(folder, tmp_path / "class.lbclass")
    unpack(tmp_path / "class.lbclass")
    there = HandInShelf(school / "7b")
    assert there.read(ana.id, "1-03-square", 4) == shelf.read(ana.id, "1-03-square", 4)
    assert [file.name for file in runs_folder(school / "7b", "1-03-square", 4).iterdir()] == [NAME]
