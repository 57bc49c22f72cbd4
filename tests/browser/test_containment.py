"""What programs may do, on the page."""

import tomllib

import pytest
from playwright.sync_api import expect

from browser.conftest import Server
from browser.test_accessibility import faults

pytestmark = pytest.mark.certain

#: Lets the survey of the server find that nothing contains programs, as on another system.
UNCONTAINED = """\
from learnblock.runtime.containment import survey

survey._refused = survey._refused_to_driver = frozenset
"""
NETWORK = 'Programs of the project "weather" may use the network'


@pytest.fixture
def class_server(tmp_path, monkeypatch):
    """A server that other computers can use, on a computer that contains nothing."""
    (tmp_path / "sitecustomize.py").write_text(UNCONTAINED)
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    server = Server(tmp_path / "home", "--host=0.0.0.0")
    server.address = f"http://127.0.0.1:{server.port}/?{server.address.partition('?')[2]}"
    yield server
    server.stop()


def show(pupil):
    pupil.command("Settings and help", "Coder")
    pupil.command("Settings and help", "What programs may do…")
    expect(pupil.dialog().get_by_role("row")).to_have_count(11)


def test_the_dialog_lists_each_attempt_with_its_result_and_reason(sit_down, own_server, axe):
    pupil = sit_down(own_server)
    show(pupil)
    row = pupil.dialog().get_by_role("row", name="See your environment variables")
    expect(row).to_contain_text("Refused")
    expect(row).to_contain_text("programs get a clean environment")
    pupil.picture("dialog")
    assert faults(pupil, axe, "dialog[open]") == []


def test_a_user_at_the_server_allows_a_project_the_network_and_forbids_it(sit_down, own_server):
    pupil = sit_down(own_server)
    pupil.begin("weather")
    show(pupil)
    box = pupil.dialog().get_by_role("checkbox", name=NETWORK)
    expect(box).not_to_be_checked()
    box.check()
    file = own_server.home / "projects" / "weather.learnblock"
    pupil.page.keyboard.press("Escape")
    show(pupil)
    expect(box).to_be_checked()
    assert settings(own_server) == {"network": {"allowed": [str(file)]}}
    box.uncheck()
    pupil.page.keyboard.press("Escape")
    show(pupil)
    expect(box).not_to_be_checked()
    assert settings(own_server) == {"network": {}}


def test_a_teacher_who_starts_a_class_is_warned_once(sit_down, class_server, axe):
    printed = [class_server.process.stdout.readline() for _ in range(3)]
    assert "Use the network" in "".join(printed)
    pupil = sit_down(class_server)
    warning = pupil.expect_note("programs can get past LearnBlock's limits")
    pupil.picture("warning")
    warning.get_by_role("button", name="Show details").click()
    row = pupil.dialog().get_by_role("row", name="Start other programs").first
    expect(row).to_contain_text("Allowed")
    pupil.picture("dialog")
    assert faults(pupil, axe, "dialog[open]") == []
    pupil.page.keyboard.press("Escape")
    pupil.page.reload()
    show(pupil)
    expect(warning).to_have_count(0)


def settings(server):
    return tomllib.loads((server.home / "settings.toml").read_text("utf-8"))
