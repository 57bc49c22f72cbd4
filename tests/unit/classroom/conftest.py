"""A class that is open."""

import pytest

from classes import opened


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
