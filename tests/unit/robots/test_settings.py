"""The settings of a real robot: typed, saved in the user's folder, refused by name."""

from typing import Annotated

import pytest
from msgspec import Meta

from learnblock.errors import SettingsError, UnknownNameError
from learnblock.robots import settings
from learnblock.robots.settings import Address, Port, RobotSettings


class Mine(RobotSettings, frozen=True):
    address: Address = "127.0.0.1"
    port: Port = 5551
    wheels: Annotated[tuple[str, ...], Meta(max_length=4, description="motors")] = ("B", "D")
    wheel: Annotated[float, Meta(ge=1, le=500, description="radius of a wheel, mm")] = 30.0


@pytest.fixture(autouse=True)
def _home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))


def test_without_a_file_all_settings_have_their_defaults():
    assert settings.load("mine", Mine) == Mine()


def test_a_changed_setting_is_saved_and_the_rest_of_the_file_is_unchanged():
    settings.file().write_text("[robots.other]\nx = 1\n[page]\ny = 2\n")
    settings.change("mine", Mine, "port", "6000")
    settings.change("mine", Mine, "wheels", '["A", "C"]')
    settings.change("mine", Mine, "address", "10.0.0.7")
    assert settings.load("mine", Mine) == Mine(port=6000, wheels=("A", "C"), address="10.0.0.7")
    text = settings.file().read_text()
    assert "x = 1" in text
    assert "y = 2" in text


def test_a_setting_is_reset_to_its_default():
    settings.change("my-robot", Mine, "port", "6000")
    settings.change("my-robot", Mine, "port", None)
    assert settings.load("my-robot", Mine) == Mine()
    assert "port" not in settings.file().read_text()


def test_chosen_settings_override_the_file():
    settings.change("mine", Mine, "port", "6000")
    assert settings.load("mine", Mine, {"address": "me"}) == Mine(port=6000, address="me")


def test_an_invalid_value_is_refused_by_name_and_changes_nothing():
    settings.change("mine", Mine, "port", "6000")
    with pytest.raises(SettingsError, match="'port' is 70000, but must be a whole number"):
        settings.change("mine", Mine, "port", "70000")
    with pytest.raises(
        SettingsError, match="'port' is \"six\", but must be a whole number from 1 to"
    ):
        settings.change("mine", Mine, "port", "six")
    assert settings.load("mine", Mine).port == 6000


def test_an_unknown_setting_is_reported_with_the_nearest_one():
    with pytest.raises(UnknownNameError, match=r"Did you mean 'port'\?"):
        settings.change("mine", Mine, "prot", "1")
    with pytest.raises(SettingsError, match=r"Did you mean 'port'\?"):
        settings.load("mine", Mine, {"prot": 1})


def test_a_mistake_in_the_file_is_reported_with_its_line():
    settings.file().write_text("[robots.mine]\naddress = 'x'\nport = 0\n")
    with pytest.raises(SettingsError, match=r"'robots\.mine\.port' is 0") as caught:
        settings.load("mine", Mine)
    assert caught.value.diagnostics[0].line == 3


def test_every_setting_is_described():
    settings.change("mine", Mine, "port", "6000")
    told = {one.name: one for one in settings.describe("mine", Mine)}
    assert (told["port"].value, told["port"].default) == (6000, 5551)
    assert str(told["wheel"].allowed) == "a number from 1 to 500 (radius of a wheel, mm)"
