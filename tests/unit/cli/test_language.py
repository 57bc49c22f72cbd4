"""The reader's language on the command line."""

import pytest

from learnblock.cli import main
from learnblock.cli.language import language
from learnblock.runtime.containment.driver import in_own_thread


@pytest.fixture(autouse=True)
def english_system(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_LANGUAGE", "en")


def test_the_thread_of_a_run_speaks_the_language_of_its_command():
    with main.make_context("learnblock", ["--language", "es", "run", "square.bt"]):
        assert in_own_thread(language) == "es"


def test_the_next_command_speaks_its_own_language():
    with main.make_context("learnblock", ["--language", "es", "run", "square.bt"]):
        pass
    assert language() == "en"
