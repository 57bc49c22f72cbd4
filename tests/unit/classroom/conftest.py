"""A class that is open."""

import pytest

from classes import opened
from learnblock.classroom import pins


@pytest.fixture(autouse=True, scope="session")
def quick_pins():
    """Hash PINs at the least cost, as these tests make hundreds; the value is the real cost."""
    with pytest.MonkeyPatch.context() as monkeypatch:
        real = pins.COST
        monkeypatch.setattr(pins, "COST", {**real, "n": 2})
        yield real


@pytest.fixture(scope="module")
def room(tmp_path_factory):
    """A class shared by the tests of a file."""
    with opened(tmp_path_factory.mktemp("teacher")) as one:
        yield one


@pytest.fixture
def own_room(tmp_path):
    """A class for one test."""
    with opened(tmp_path) as one:
        yield one
