"""A file is written completely or not at all, even by several writers at once."""

import errno
import os
import stat
import threading

import pytest

from gate import examples
from learnblock.storage.files import save

LENGTH = 50_000


def test_readers_of_a_file_with_two_writers_never_see_half_of_it(tmp_path):
    file = tmp_path / "program"
    save(file, b"0" * LENGTH)
    over = threading.Event()
    failed = []

    def write(byte):
        try:
            while not over.is_set():
                save(file, byte * LENGTH)
        except OSError as error:
            failed.append(error)

    writers = [threading.Thread(target=write, args=(byte,)) for byte in (b"1", b"2")]
    for writer in writers:
        writer.start()
    try:
        seen = [file.read_bytes() for _ in range(examples(2000, gate=500))]
    finally:
        over.set()
        for writer in writers:
            writer.join()
    assert failed == []
    assert {(len(data), len(set(data))) for data in seen} == {(LENGTH, 1)}
    assert [one.name for one in tmp_path.iterdir()] == ["program"]


def test_a_disk_that_is_full_keeps_the_old_file_and_nothing_of_the_new_one(tmp_path, monkeypatch):
    file = tmp_path / "program"
    save(file, b"old")

    def full(_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space"):
        save(file, b"new")
    assert [one.name for one in tmp_path.iterdir()] == ["program"]
    assert file.read_bytes() == b"old"


@pytest.mark.skipif(os.name == "nt", reason="Windows has other rights")
def test_a_private_file_can_be_read_by_its_owner_only(tmp_path):
    save(tmp_path / "token", b"secret", private=True)
    assert stat.S_IMODE((tmp_path / "token").stat().st_mode) == 0o600


def test_a_file_that_is_not_wanted_any_more_leaves_the_old_one(tmp_path):
    path = tmp_path / "file"
    path.write_bytes(b"old")
    assert save(path, b"new", still_wanted=lambda: False) is None
    assert [one.read_bytes() for one in tmp_path.iterdir()] == [b"old"]


def test_saving_tells_the_status_of_the_new_file(tmp_path):
    path = tmp_path / "file"
    status = save(path, b"new", still_wanted=lambda: True)
    assert (status.st_ino, status.st_mtime_ns) == (path.stat().st_ino, path.stat().st_mtime_ns)
