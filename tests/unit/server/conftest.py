"""A server and its pages."""

import pytest

from pages import serving


@pytest.fixture
def projects(tmp_path):
    return tmp_path / "projects"


@pytest.fixture
def server(projects):
    with serving(projects, static=projects.parent / "static") as running:
        yield running


@pytest.fixture
def page(server):
    with server.visit() as visitor:
        yield visitor
