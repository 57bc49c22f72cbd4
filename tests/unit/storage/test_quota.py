"""A person's folder may hold so much."""

import pytest

from learnblock.errors import LearnBlockError
from learnblock.storage import quota
from learnblock.storage.files import save

MEGABYTE = 1024 * 1024


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv(quota.VARIABLE, quota.setting(2 * MEGABYTE, tmp_path))
    return tmp_path


def test_a_full_folder_takes_no_new_file(folder):
    save(folder / "one", bytes(MEGABYTE))
    save(folder / "below" / "two", bytes(MEGABYTE - 100))
    with pytest.raises(OSError, match="may hold 2 MB") as refused:
        save(folder / "three", bytes(200))
    assert isinstance(refused.value, LearnBlockError)
    assert refused.value.phrase.code == "file-quota"
    assert not (folder / "three").exists()


def test_work_on_what_exists_goes_on_in_a_full_folder(folder):
    (folder / "old").write_bytes(bytes(3 * MEGABYTE))
    save(folder / "old", b"less")
    (folder / "program").write_bytes(bytes(3 * MEGABYTE))
    save(folder / "program", bytes(MEGABYTE))
    assert (folder / "program").stat().st_size == MEGABYTE


def test_what_is_there_already_counts(folder):
    (folder / "there").write_bytes(bytes(2 * MEGABYTE))
    with pytest.raises(quota.FolderFullError):
        save(folder / "new", b"x")


def test_there_is_no_limit_without_the_variable(tmp_path, monkeypatch):
    monkeypatch.delenv(quota.VARIABLE, raising=False)
    save(tmp_path / "large", bytes(3 * MEGABYTE))
