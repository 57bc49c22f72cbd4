"""A server and its pages."""

import pytest

from pages import SOON, serving


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
