"""A server and its pages."""

import pytest

from learnblock.server.runs import playing
from pages import SOON, serving


@pytest.fixture(autouse=True, scope="session")
def no_memory_given_back():
    """Leave the memory of a run to Python, whose search takes long among all tests' objects."""
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setattr(playing, "give_back_memory", lambda is_freed: None)
        yield


@pytest.fixture
def projects(tmp_path):
    return tmp_path / "projects"


@pytest.fixture
def periods():
    """How long an open project waits; a test that needs others parametrizes it."""
    return SOON


@pytest.fixture
def server(projects, periods):
    with serving(projects, static=projects.parent / "static", periods=periods) as running:
        yield running


@pytest.fixture
def page(server):
    with server.visit() as visitor:
        yield visitor
