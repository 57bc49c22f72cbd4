"""The pages on cameras and components: their code runs, and their tables match the code."""

import re

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.perception.robocomp import COMPONENTS
from learnblock.perception.robocomp.labels import EMOTIONS
from learnblock.perception.sources import TABLE
from places import ROOT
from shown_pictures import a_tag
from videos import record

DOCS = ROOT / "docs"
PAGES = ("cameras.md", "robots/components.md")


def page(name):
    return (DOCS / name).read_text(encoding="utf-8")


def test_the_python_about_cameras_runs(tmp_path, capsys):
    TABLE.change("video", str(record(tmp_path / "tag.avi", [a_tag(8)])))
    sources = page("cameras.md").partition("## When detectors run")[0]
    (code,) = re.findall(r"```python\n(.*?)```", sources, re.DOTALL)
    names = {}
    exec(code, names)  # noqa: S102 - our own page
    names["robot"].stop()
    assert "Tag(id=8" in capsys.readouterr().out


def test_the_python_about_components_runs(capsys):
    (code,) = re.findall(r"```python\n(.*?)```", page("robots/components.md"), re.DOTALL)
    names = {}
    exec(code, names)  # noqa: S102 - our own page
    names["robot"].stop()
    assert capsys.readouterr().out.startswith("2 (")


@pytest.mark.parametrize(
    "command",
    [
        command
        for name in PAGES
        for command in re.findall(r"^learnblock (perception .+)$", page(name), re.MULTILINE)
    ],
)
def test_a_command_of_the_pages_works(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "lesson.mp4").write_bytes(b"")
    result = CliRunner().invoke(main, command.split(), input="y\n")
    assert result.exit_code == 0, result.output


def test_every_setting_is_listed_with_its_default():
    shown = dict(
        re.findall(r"^\| `(\w+)` \| `(.+?)` \| ", page("cameras.md").partition("## Settings")[2],
                   re.MULTILINE)
    )  # fmt: skip
    plain = {True: "true", False: "false"}
    assert shown == {
        one.name: f'"{one.default}"' if isinstance(one.default, str)
        else plain.get(one.default, str(one.default))
        for one in TABLE.describe()
    }  # fmt: skip


def test_every_component_is_listed_with_its_port_and_words():
    text = page("robots/components.md")
    for name, kind in COMPONENTS.items():
        assert f"{kind.port} for `{name}`" in text
    for label in EMOTIONS:
        assert f"`{label}`" in text
