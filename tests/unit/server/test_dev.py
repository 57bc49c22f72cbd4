"""`learnblock dev` reports what it needs."""

import pytest

from learnblock.errors import LearnBlockError
from learnblock.server import dev


def test_it_works_only_in_a_checkout(tmp_path, monkeypatch):
    monkeypatch.setattr(dev, "PACKAGE", tmp_path / "site-packages" / "learnblock")
    with pytest.raises(LearnBlockError, match="needs the sources"):
        dev.develop(5173)
