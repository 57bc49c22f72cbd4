"""Every message has words in each language, and all words are used: scripts/translations."""

import io
import json
import runpy
import subprocess
import sys
from collections.abc import Callable
from contextlib import redirect_stdout
from functools import cache
from pathlib import Path
from unittest.mock import patch

import pytest

from places import ROOT

SCRIPT = ROOT / "scripts" / "translations"
MESSAGES = "src/learnblock/i18n"


def run(root: Path, *options: str) -> tuple[int, list[str]]:
    """Call the script in this process."""
    said = io.StringIO()
    with patch.object(sys, "argv", [str(SCRIPT), *options, str(root)]), redirect_stdout(said):
        code = main()()
    return code, said.getvalue().splitlines()


@cache
def main() -> Callable[[], int]:
    return runpy.run_path(str(SCRIPT))["main"]


@pytest.fixture
def write(tmp_path):
    """Add a file to a repository, by its path and text."""

    def write(path: str, *lines: str) -> Path:
        file = tmp_path / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("\n".join(lines) + "\n", "utf-8")
        return file

    write(f"{MESSAGES}/en/robot.ftl", "robot-lost = No answer from { $address }.")
    write("src/robot.py", 'raise LinkError("robot-lost", address=address)')
    return write


def test_english_and_spanish_are_complete_and_every_word_is_used():
    done = subprocess.run(
        [sys.executable, SCRIPT], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_a_code_that_english_lacks_is_an_error(write, tmp_path):
    write("src/check.py", "", 'Phrase("check-loop")')
    assert run(tmp_path) == (1, ["src/check.py:2: en lacks check-loop"])


def test_values_must_be_those_of_the_text(write, tmp_path):
    write("src/wire.py", 'raise LinkError("robot-lost", name=name, port=port)')
    assert run(tmp_path) == (
        1,
        ["src/wire.py:1: robot-lost is given name, port, but its text shows address"],
    )


def test_values_that_come_in_a_dictionary_are_not_compared(write, tmp_path):
    write("src/wire.py", 'Phrase("robot-lost", **values)')
    assert run(tmp_path) == (0, [])


def test_a_message_shows_the_values_of_messages_in_it(write, tmp_path):
    write(
        f"{MESSAGES}/en/wire.ftl", "wire-cut = Cut at { $at }.", "wire-why = { wire-cut } { $why }"
    )
    write("src/wire.py", 'Phrase("wire-cut", at=3)', 'Phrase("wire-why", at=3, why="")')
    assert run(tmp_path) == (0, [])


def test_a_message_that_cannot_be_read_is_an_error(write, tmp_path):
    write(f"{MESSAGES}/en/wire.ftl", "wire-cut = Cut.", "wire-why = Cut at { $at")
    write("src/wire.py", 'Phrase("wire-cut")')
    assert run(tmp_path) == (1, ['en/wire.ftl:2: Expected token: "}"'])


def test_codes_begin_with_the_name_of_their_file(write, tmp_path):
    write(f"{MESSAGES}/en/wire.ftl", "robot-slow = Slow.")
    write(f"{MESSAGES}/en/page/bar.ftl", "page-bar-run = Run", "page-run = Run")
    write("src/wire.py", 'Phrase("robot-slow")', 'Phrase("page-bar-run")', 'Phrase("page-run")')
    assert run(tmp_path) == (
        1,
        [
            "en/page/bar.ftl: page-run does not begin with page-bar-",
            "en/wire.ftl: robot-slow does not begin with wire-",
        ],
    )


def test_a_code_is_defined_once(write, tmp_path):
    text = "robot-lost = No answer from { $address }."
    write(f"{MESSAGES}/en/robot.ftl", text, text)
    assert run(tmp_path) == (1, ["en/robot.ftl: robot-lost is there twice"])


def test_a_word_of_the_page_that_english_lacks_is_an_error(write, tmp_path):
    write(f"{MESSAGES}/en/page/bar.ftl", "page-bar-run = Run")
    write("frontend/src/bar.tsx", 't("page-bar-run"); const WORDS = { off: "page-bar-off" };')
    assert run(tmp_path) == (1, ["frontend/src/bar.tsx: en lacks page-bar-off"])


def test_a_composed_code_uses_every_matching_word(write, tmp_path):
    words = [
        "page-bar-state-idle = Idle",
        "page-bar-state-ended = Ended",
        "page-bar-run-tip = Run",
    ]
    write(f"{MESSAGES}/en/page/bar.ftl", *words)
    write("frontend/src/bar.tsx", "t(`page-bar-state-${state}`); t(`page-bar-${name}-tip`)")
    assert run(tmp_path) == (0, [])


def test_a_composed_code_of_python_uses_every_matching_word(write, tmp_path):
    write(f"{MESSAGES}/en/wire.ftl", "wire-cut-why = Cut.", "wire-cut-how = Cut.")
    write("src/wire.py", 'Phrase(f"wire-{reason}-why")')
    assert run(tmp_path) == (0, ["wire-cut-how is not used"])


def test_an_unused_word_is_listed(write, tmp_path):
    write(f"{MESSAGES}/en/wire.ftl", "wire-cut = Cut.")
    assert run(tmp_path) == (0, ["wire-cut is not used"])


def test_a_code_in_a_table_is_used(write, tmp_path):
    write(f"{MESSAGES}/en/wire.ftl", "wire-cut = Cut.")
    write("src/wire.py", 'REASONS = {"cut": "wire-cut"}')
    assert run(tmp_path) == (0, [])


def test_missing_and_additional_words_of_another_language_are_listed(write, tmp_path):
    write(f"{MESSAGES}/fr/robot.ftl", "robot-near = Proche.")
    assert run(tmp_path) == (0, ["fr lacks robot-lost", "fr alone has robot-near"])


def test_a_translation_that_forgets_a_value_is_listed(write, tmp_path):
    write(f"{MESSAGES}/fr/robot.ftl", "robot-lost = Pas de réponse.")
    assert run(tmp_path) == (0, ["fr shows other values in robot-lost"])


def test_words_of_blocks_are_compared_too(write, tmp_path):
    where = "src/learnblock/blocks/translations"
    write(f"{where}/en.json", '{"LB_MAIN": "main", "group": {"a": "%1"}}')
    write(f"{where}/fr.json", '{"group": {"a": "%2"}}')
    assert run(tmp_path) == (
        0,
        [f"{where}: fr lacks LB_MAIN", f"{where}: fr shows other values in group.a"],
    )


def test_words_of_skills_are_compared_too(write, tmp_path):
    where = "src/learnblock/blocks/configurations/words"
    write(f"{where}/en.json", json.dumps({"turn": {"label": "turn {angle.direction}"}}))
    write(f"{where}/fr.json", json.dumps({"turn": {"label": "tourner"}, "stop": {"label": "stop"}}))
    assert run(tmp_path) == (
        0,
        [f"{where}: fr alone has stop.label", f"{where}: fr shows other values in turn.label"],
    )


def test_a_file_that_is_still_english_is_listed(write, tmp_path):
    where = "src/learnblock/project/help"
    for language in ("en", "fr"):
        write(f"{where}/{language}.json", '{"variable": "A variable."}')
    assert run(tmp_path) == (0, [f"{where}: fr.json is not translated yet"])


def test_a_new_language_begins_with_the_english_words(write, tmp_path):
    write(f"{MESSAGES}/en/page/bar.ftl", "page-bar-run = Run")
    write("frontend/src/bar.tsx", 't("page-bar-run")')
    write("src/learnblock/project/help/en.json", '{"variable": "A variable."}')
    code, lines = run(tmp_path, "--add", "fr")
    files = [tmp_path / MESSAGES / "fr" / name for name in ("page/bar.ftl", "robot.ftl")]
    help_file = tmp_path / "src/learnblock/project/help/fr.json"
    assert code == 0
    assert lines == [
        *(f"made {path.as_posix()}" for path in (*files, help_file)),
        "fr/page/bar.ftl is not translated yet",
        "fr/robot.ftl is not translated yet",
        "src/learnblock/project/help: fr.json is not translated yet",
    ]
    assert files[0].read_text("utf-8").splitlines()[1] == "page-bar-run = Run"


def test_a_language_that_was_begun_keeps_its_words(write, tmp_path):
    own = write(f"{MESSAGES}/fr/robot.ftl", "robot-lost = Pas de réponse de { $address }.")
    assert run(tmp_path, "--add", "fr") == (0, [])
    assert own.read_text("utf-8") == "robot-lost = Pas de réponse de { $address }.\n"
