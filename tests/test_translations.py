"""The script that lists what translations lack."""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
SCRIPT = ROOT / "scripts" / "translations"


def run(root: Path) -> tuple[int, list[str]]:
    done = subprocess.run(
        [sys.executable, SCRIPT, root],
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )
    assert done.stderr == ""
    return done.returncode, done.stdout.splitlines()


def page(root: Path, source: str, **languages: dict[str, str]) -> Path:
    """A page whose one source is `source`, with words for the area `bar` in each language."""
    folder = root / "frontend" / "src"
    for language, words in languages.items():
        file = folder / "i18n" / language / "bar.json"
        file.parent.mkdir(parents=True)
        file.write_text(json.dumps(words), "utf-8")
    (folder / "bar.tsx").write_text(source, "utf-8")
    return root


def test_english_and_spanish_are_complete_and_nothing_is_there_in_vain():
    assert run(ROOT) == (0, [])


def test_a_word_that_english_lacks_fails(tmp_path):
    root = page(tmp_path, 't("bar.run"); t("bar.stop")', en={"run": "Run"})
    assert run(root) == (1, ["en lacks bar.stop, which the page uses"])


def test_a_word_of_an_area_that_is_not_there_fails(tmp_path):
    root = page(tmp_path, 't("bar.run"); t("baz.run")', en={"run": "Run"})
    assert run(root) == (1, ["en lacks baz.run, which the page uses"])


def test_a_word_in_a_table_is_used(tmp_path):
    root = page(tmp_path, 'const WORDS = { run: "bar.run", off: "bar.off" };', en={"run": "Run"})
    assert run(root) == (1, ["en lacks bar.off, which the page uses"])


def test_a_name_that_is_put_together_uses_every_word_that_begins_so(tmp_path):
    words = {"state_idle": "Ready", "state_ended": "Ended"}
    assert run(page(tmp_path, "t(`bar.state_${state}`)", en=words)) == (0, [])


def test_a_file_is_no_word(tmp_path):
    root = page(tmp_path, 't("bar.run"); save("bar.csv"); import "./bar.css";', en={"run": "Run"})
    assert run(root) == (0, [])


def test_what_another_language_lacks_is_listed_and_no_failure(tmp_path):
    root = page(tmp_path, 't("bar.run")', en={"run": "Run"}, fr={"halt": "Arrêter"})
    assert run(root) == (0, ["fr lacks bar.run", "fr alone has bar.halt"])


def test_a_text_that_forgets_a_value_is_listed(tmp_path):
    words = {"en": {"run": "Run {name}"}, "es": {"run": "Ejecutar"}}
    root = page(tmp_path, 't("bar.run", { name })', **words)
    assert run(root) == (0, ["es has other places for values in bar.run"])


def test_a_word_that_nobody_uses_is_listed(tmp_path):
    root = page(tmp_path, 't("bar.run")', en={"run": "Run", "halt": "Stop"})
    assert run(root) == (0, ["nobody uses bar.halt"])


def test_words_of_blocks_are_compared_too(tmp_path):
    root = page(tmp_path, 't("bar.run")', en={"run": "Run"})
    folder = root / "src" / "learnblock" / "blocks" / "translations"
    folder.mkdir(parents=True)
    (folder / "en.json").write_text('{"LB_MAIN": "main", "group": {"a": "%1"}}', "utf-8")
    (folder / "fr.json").write_text('{"group": {"a": "%2"}}', "utf-8")
    where = "src/learnblock/blocks/translations"
    assert run(root) == (
        0,
        [f"{where}: fr lacks LB_MAIN", f"{where}: fr has other places for values in group.a"],
    )
