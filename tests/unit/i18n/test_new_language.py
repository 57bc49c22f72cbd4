"""A language is files of words: a complete one, made up here, needs no change in the code."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from places import ROOT

#: Where words are.
COPIED = ("i18n", "blocks", "project/help", "why/words")
#: How one asks *why?* in it.
QUESTIONS = """
[words]
right = "dekstr*"

[forms]
line = ["linio"]
at = ["je"]

[translated]
ruga = "red"
"""
FIRST_LINE = re.compile(r"# Not translated yet.*\n")


@pytest.fixture(scope="module")
def repository(tmp_path_factory):
    """A copy of the repository with a complete language, whose texts end in an exclamation mark."""
    root = tmp_path_factory.mktemp("repository")
    package = root / "src" / "learnblock"
    source = ROOT / "src" / "learnblock"
    for folder in COPIED:
        shutil.copytree(source / folder, package / folder)
    link_rest(source, package)
    for link in ("scripts", "pyproject.toml"):
        (root / link).symlink_to(ROOT / link)
    (root / "frontend").mkdir()
    shutil.copytree(ROOT / "frontend" / "src", root / "frontend" / "src")
    (root / "frontend" / "node_modules").symlink_to(ROOT / "frontend" / "node_modules")
    made = run(root, "scripts/translations", "--add", "eo")
    for line in made.splitlines():
        if line.startswith("made "):
            translate(Path(line.removeprefix("made ")))
    (package / "why" / "words" / "eo.toml").write_text(QUESTIONS, "utf-8")
    return root


def link_rest(source: Path, copy: Path) -> None:
    """Everything that was not copied."""
    for path in source.iterdir():
        place = copy / path.name
        if not place.exists():
            place.symlink_to(path)
        elif place.is_dir():
            link_rest(path, place)


def translate(file: Path) -> None:
    text = file.read_text("utf-8")
    if file.suffix == ".json":
        words = json.dumps(exclaimed(json.loads(text)), ensure_ascii=False)
        file.write_text(words, "utf-8")
    elif file.suffix == ".ftl":
        words = re.sub(
            r"^((?:help|set)-[\w-]+ = .+)$", r"\1!", FIRST_LINE.sub("", text), flags=re.MULTILINE
        )
        file.write_text(words, "utf-8")


def exclaimed(words: Any) -> Any:
    if isinstance(words, dict):
        return {name: exclaimed(text) for name, text in words.items()}
    return f"{words}!"


def run(root: Path, *command: str) -> str:
    """What a Python program prints that imports LearnBlock from a copy."""
    environment = {**os.environ, "PYTHONPATH": str(root / "src"), "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(
        [sys.executable, *command],
        cwd=root,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stderr == ""
    return done.stdout


def test_it_is_a_language_of_the_command_line(repository):
    said = run(repository, "-m", "learnblock", "--language", "eo", "--help")
    assert said.startswith("Usage!: learnblock [OPTIONS]! COMMAND [ARGS]...!")
    assert "Language of the output" in said
    assert "Check programs for mistakes without running them.!" in said


def test_it_is_the_language_of_a_system_that_has_it(repository):
    code = "from learnblock.i18n.reader import system_language as of; print(of())"
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LEARNBLOCK_LANGUAGE", "eo_XX.UTF-8")
        assert run(repository, "-c", code) == "eo\n"


def test_skills_and_palette_have_its_words(repository):
    code = (
        "from learnblock.blocks import builtin; from learnblock.blocks.palette import palette\n"
        "made = palette(builtin(), 'eo')\n"
        "print(made['messages']['LB_MAIN'], builtin()['stop_bot'].languages['EO'])"
    )
    assert run(repository, "-c", code) == "when Run is pressed! stop driving!\n"


def test_block_sets_have_its_titles(repository):
    code = (
        "from learnblock.blocks.block_sets import built_in\n"
        "print(built_in()['first-steps'].title['eo'])"
    )
    assert run(repository, "-c", code) == "First steps!\n"


def test_a_number_has_its_unit_on_the_block_and_its_singular_in_a_sentence(repository):
    code = (
        "from learnblock.blocks import builtin; from learnblock.blocks.labels import spoken\n"
        "from learnblock.blocks.palette import palette\n"
        "made = palette(builtin(), 'eo')\n"
        "wait = next(one for one in made['definitions'] if one['type'] == 'lb_skill_sleep')\n"
        "print(wait['args0'][0]['unit'], made['units']['seconds!'])\n"
        "print(spoken(builtin()['sleep'], 'eo', {'seconds': 1}))"
    )
    assert run(repository, "-c", code) == "seconds! second!\nwait 1 second!\n"


def test_questions_about_a_run_are_read_in_it(repository):
    code = (
        "from learnblock.why.mentions import root; from learnblock.why.spans import take_span\n"
        "from learnblock.why.vocabulary import concept, forms\n"
        "print(concept('dekstren'), root('ruga'), take_span('turn je 3.5')[0].time)\n"
        "print('linio' in forms('line'), concept('right'))"
    )
    assert run(repository, "-c", code) == "right red 3.5\nTrue right\n"


def test_the_catalogue_misses_nothing_of_it(repository):
    said = run(repository, "scripts/translations", str(repository))
    assert [line for line in said.splitlines() if "eo" in re.findall(r"\w+", line)] == []


def test_the_page_takes_the_words_of_blockly(repository):
    words = repository / "frontend/src/views/blocks/words/eo.ts"
    assert words.read_text("utf-8") == 'export * from "blockly/msg/eo";\n'
