"""Settings of robots on the page."""

import re
import tomllib

import pytest
from playwright.sync_api import expect

from emulated import settle
from learnblock.emulators import emulate


@pytest.fixture
def pupil(sit_down, own_server):
    return sit_down(own_server, empty=True)


def test_robot_settings_are_saved_and_an_invalid_value_is_reported_at_its_field(pupil, own_server):
    open_dialog(pupil)
    pupil.dialog().get_by_role("combobox", name="Robot").select_option("ev3")
    field(pupil, "Address").fill("192.168.1.7")
    field(pupil, "Maximum speed").fill("5")
    save(pupil)
    expect(pupil.dialog()).to_contain_text(re.compile("full_speed.* is 5, but must be"))
    pupil.picture("wrong")
    assert saved(own_server) == {}
    field(pupil, "Maximum speed").fill("900")
    pupil.dialog().get_by_role("combobox", name="Gyroscope").select_option("2")
    save(pupil)
    expect(pupil.dialog().get_by_text("Saved", exact=True)).to_be_visible()
    assert saved(own_server)["robots"]["ev3"] == {
        "address": "192.168.1.7", "full_speed": 900, "gyroscope": "2",
    }  # fmt: skip
    pupil.dialog().get_by_role("button", name="Default").first.click()
    save(pupil)
    expect(pupil.dialog().get_by_text("Saved", exact=True)).to_be_visible()
    assert "address" not in saved(own_server)["robots"]["ev3"]


def test_the_saved_settings_of_a_robot_are_tested_and_a_robot_that_is_missing_is_named(
    pupil, own_server, monkeypatch
):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(own_server.home))
    with emulate("ebo", "empty") as emulation:
        settle("ebo", {**emulation.settings, "patience": 15.0})
        open_dialog(pupil)
        pupil.dialog().get_by_role("combobox", name="Robot").select_option("ebo")
        test = pupil.dialog().get_by_role("button", name="Test", exact=True)
        test.click()
        expect(pupil.dialog().get_by_text("EBO answers. Programs can use it.")).to_be_visible()
        pupil.picture("answered")
        field(pupil, "Timeout").fill("1")
        # What is tested is what programs use.
        expect(test).to_be_disabled()
        save(pupil)
    test.click()
    expect(pupil.dialog().get_by_text("Can't reach EBO's wheels at 127.0.0.1")).to_be_visible()
    pupil.picture("missing")
    # Its connection is not held: another robot can be tested.
    expect(test).to_be_enabled()


def open_dialog(pupil):
    pupil.menu("Robot").click()
    pupil.page.get_by_role("menuitem", name="Robot settings…", exact=True).click()


def field(pupil, name):
    return pupil.dialog().get_by_label(name, exact=True)


def save(pupil):
    pupil.dialog().get_by_role("button", name="Save", exact=True).click()


def saved(server):
    file = server.home / "settings.toml"
    return tomllib.loads(file.read_text("utf-8")) if file.exists() else {}
