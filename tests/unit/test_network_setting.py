import pytest

from learnblock.running import may_use_network


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
