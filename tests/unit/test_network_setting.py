import tomllib

import pytest

from learnblock.errors import SettingsError
from learnblock.running import (
    allow_network,
    folder_on_network,
    forbid_network,
    may_use_network,
    move_network,
)


@pytest.fixture
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "home").mkdir()
    return tmp_path / "home"


def test_no_program_may_use_the_network_by_default(home, tmp_path):
    assert not may_use_network(tmp_path / "program.py")


def test_a_program_or_a_folder_named_in_the_settings_may_use_it(home, tmp_path):
    named = [str(tmp_path / "one.py"), str(tmp_path / "online")]
    (home / "settings.toml").write_text(f"[network]\nallowed = {named}\n")
    assert may_use_network(tmp_path / "one.py")
    assert may_use_network(tmp_path / "online" / "weather.py")
    assert not may_use_network(tmp_path / "two.py")
    assert not may_use_network(tmp_path / "online2" / "weather.py")


def test_only_a_folder_above_a_program_is_reported_as_allowing_it(home, tmp_path):
    named = [str(tmp_path / "one.py"), str(tmp_path / "online")]
    (home / "settings.toml").write_text(f"[network]\nallowed = {named}\n")
    assert folder_on_network(tmp_path / "online" / "weather.py") == named[1]
    assert folder_on_network(tmp_path / "one.py") is None


def test_allowing_and_forbidding_keeps_the_other_settings(home, tmp_path):
    before = {"network": {"allowed": ["/elsewhere"]}, "robots": {"cozmo": {"volume": 30}}}
    (home / "settings.toml").write_text(
        '[network]\nallowed = ["/elsewhere"]\n[robots.cozmo]\nvolume = 30\n'
    )
    allow_network(tmp_path / "one.py")
    assert may_use_network(tmp_path / "one.py")
    assert saved(home)["robots"] == before["robots"]
    forbid_network(tmp_path / "one.py")
    assert not may_use_network(tmp_path / "one.py")
    assert saved(home) == before


def test_allowing_twice_names_a_program_once(home, tmp_path):
    allow_network(tmp_path / "one.py")
    allow_network(tmp_path / "folder" / ".." / "one.py")
    assert saved(home) == {"network": {"allowed": [str(tmp_path / "one.py")]}}


def test_forbidding_what_is_not_allowed_writes_nothing(home, tmp_path):
    forbid_network(tmp_path / "one.py")
    assert not (home / "settings.toml").exists()


@pytest.mark.parametrize("allowed", [True, False])
def test_a_moved_program_keeps_its_own_permission_and_takes_no_other(home, tmp_path, allowed):
    one, two = tmp_path / "one.py", tmp_path / "two.py"
    (allow_network if allowed else forbid_network)(one)
    allow_network(two)
    move_network(one, two)
    assert (may_use_network(one), may_use_network(two)) == (False, allowed)


def test_a_mistake_in_the_settings_allows_nothing_and_is_not_overwritten(home, tmp_path):
    (home / "settings.toml").write_text("[network]\nallowed = 3\n")
    with pytest.raises(SettingsError, match="must be a list"):
        allow_network(tmp_path / "one.py")
    assert (home / "settings.toml").read_text() == "[network]\nallowed = 3\n"


def saved(home):
    return tomllib.loads((home / "settings.toml").read_text("utf-8"))
