import pytest


@pytest.fixture(autouse=True)
def english(monkeypatch):
    """Run the commands in English, in every locale."""
    monkeypatch.setenv("LEARNBLOCK_LANGUAGE", "en")
