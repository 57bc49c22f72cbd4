"""Pictures of projects: only small JPEG files are kept."""

from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import ProjectError
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.picture import (
    LARGEST_PICTURE,
    LARGEST_SIDE,
    PictureError,
    check_picture,
)
from learnblock.project.files.project import Project


def jpeg(width=480, height=270, *, before=b"\xff\xe0\x00\x04ab", size=0):
    """Return the start of a JPEG, filled up to a size."""
    sides = height.to_bytes(2) + width.to_bytes(2)
    head = b"\xff\xd8" + before + b"\xff\xc0\x00\x0b\x08" + sides + b"\x01\x01\x01\x00"
    return head.ljust(size, b"\0")


@pytest.fixture
def folder(tmp_path):
    folder = ProjectFolder(tmp_path / "projects")
    folder.write(Project("p"))
    return folder


@pytest.mark.parametrize(
    "picture",
    [
        b"",
        b"\xff\xd8",
        b"GIF89a",
        b"<svg/>",
        b"\x89PNG\r\n\x1a\n",
        jpeg()[:20],
        jpeg(width=0),
        jpeg(width=LARGEST_SIDE + 1),
        jpeg(height=65_535),
        jpeg(size=LARGEST_PICTURE + 1),
        jpeg(before=b"\xff\xe0\x00\x00"),
    ],
)
def test_what_is_no_small_jpeg_is_refused_and_not_kept(folder, picture):
    with pytest.raises(PictureError):
        folder.keep_picture("p", picture)
    assert folder.picture("p") is None


@given(st.binary(max_size=200))
def test_any_bytes_are_a_picture_or_refused(data):
    for given_bytes in (data, b"\xff\xd8\xff" + data):
        with suppress(PictureError):
            check_picture(given_bytes)


def test_a_picture_is_listed_with_its_project(folder):
    assert folder.entries()[0].picture == 0
    folder.keep_picture("p", jpeg())
    assert folder.entries()[0].picture > 0
    assert folder.picture("p") == jpeg()


def test_a_picture_is_renamed_copied_and_deleted_with_its_project(folder):
    folder.keep_picture("p", jpeg())
    folder.rename("p", "q")
    assert (folder.picture("p"), folder.picture("q")) == (None, jpeg())
    folder.write(Project("copy"))
    folder.copy_picture("q", "copy")
    assert folder.picture("copy") == jpeg()
    folder.delete("q")
    assert folder.picture("q") is None
    assert len([*folder.path.glob(".trash/*/history/picture.jpg")]) == 1


def test_a_copy_of_a_project_without_a_picture_has_none(folder):
    folder.copy_picture("p", "copy")
    assert folder.picture("copy") is None


def test_a_file_that_another_program_has_put_there_is_no_picture(folder):
    folder.keep_picture("p", jpeg())
    (folder.path / ".history" / "p" / "picture.jpg").write_bytes(b"<script>")
    assert folder.picture("p") is None


@pytest.mark.parametrize("name", ["../p", "", "a/b", ".history"])
def test_a_picture_outside_the_folder_is_not_read(folder, name):
    with pytest.raises(ProjectError):
        folder.picture(name)


def test_in_a_read_only_folder_no_picture_is_kept(folder):
    reading = ProjectFolder(folder.path, read_only=True)
    with pytest.raises(ProjectError):
        reading.keep_picture("p", jpeg())
    assert folder.picture("p") is None
