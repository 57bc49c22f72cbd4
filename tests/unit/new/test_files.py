"""New files replace no existing ones."""

import pytest

from learnblock.errors import FileTakenError
from learnblock.new.files import write_new


def test_all_files_are_written_or_none(tmp_path):
    (tmp_path / "b").write_text("mine")
    files = {tmp_path / "a": "new", tmp_path / "b": "new"}
    with pytest.raises(FileTakenError, match=r"already exist: \S+b\. .* --force"):
        write_new(files)
    assert not (tmp_path / "a").exists()
    assert (tmp_path / "b").read_text() == "mine"


def test_force_replaces_files(tmp_path):
    (tmp_path / "b").write_text("mine")
    write_new({tmp_path / "deep" / "a": "ñ", tmp_path / "b": "new"}, force=True)
    assert (tmp_path / "deep" / "a").read_text(encoding="utf-8") == "ñ"
    assert (tmp_path / "b").read_text() == "new"
