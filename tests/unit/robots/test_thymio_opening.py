"""What is said when no Thymio can be reached names what to start."""

import socket

import pytest

from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots.thymio import finding
from learnblock.robots.thymio.opening import open_link
from learnblock.robots.thymio.settings import ThymioSettings

pytest.importorskip("tdmclient")
pytest.importorskip("thymiodirect")


@pytest.fixture
def closed():
    """A port at which nothing answers."""
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        yield taken.getsockname()[1]


@pytest.mark.parametrize(
    ("connection", "code", "named"),
    [
        ("auto", "thymio-not-found", ("cable", "dongle", "Thymio Suite", "asebaswitch")),
        ("tcp", "thymio-no-listener", ("asebaswitch", "playground")),
        ("suite", "thymio-no-suite", ("Thymio Suite",)),
    ],
)
def test_a_missing_program_is_named(closed, monkeypatch, connection, code, named):
    monkeypatch.setattr(finding, "serial_devices", list)
    settings = ThymioSettings(connection=connection, port=closed, suite_port=closed)
    with pytest.raises(RobotConnectionError) as error:
        open_link(settings)
    assert error.value.phrase == Phrase(code, place=f"127.0.0.1:{closed}")
    assert [name for name in named if name not in str(error.value)] == []
