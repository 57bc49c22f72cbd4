"""Tag names on the command line."""

import json

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.perception.tag_names import tag_names


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def told(*arguments, code=0):
    result = CliRunner().invoke(main, arguments)
    assert result.exit_code == code, result.output
    return result.output


def test_a_name_is_given_listed_and_removed():
    told("tags", "set", "ball", "3")
    told("tags", "set", "red door", "12")
    assert told("tags") == "  3  ball\n 12  red door\n"
    told("tags", "remove", "ball")
    assert json.loads(told("tags", "--json")) == {"red door": 12}


@pytest.mark.parametrize("name", ["tags.csv", "names.toml"])
def test_exported_names_can_be_imported(name):
    told("tags", "set", "ball", "3")
    told("tags", "export", name)
    told("tags", "remove", "ball")
    told("tags", "set", "goal", "4")
    assert told("tags", "import", name) == f"Imported one tag name from {name}\n"
    assert tag_names() == {"goal": 4, "ball": 3}
    told("tags", "import", name, "--replace")
    assert tag_names() == {"ball": 3}


def test_tags_can_be_printed(own_home):
    told("tags", "set", "ball", "3")
    told("tags", "print", "ball", "12", "--side", "40", "--output", "mine.html")
    page = (own_home / "mine.html").read_text("utf-8")
    assert "3 ball</figcaption>" in page
    assert "12</figcaption>" in page


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        (("set", "ball", "587"), 1, "from 0 to 586"),
        (("set", "12", "3"), 1, "is a number"),
        (("remove", "bal"), 2, "There is no tag 'bal'"),
        (("print", "bal"), 2, "There is no tag 'bal'"),
        (("import", "nothing.toml"), 2, "No such file"),
    ],
)
def test_an_invalid_request_is_reported_in_a_sentence(arguments, code, message):
    assert message in told("tags", *arguments, code=code)


@pytest.mark.parametrize("name", ["tags.toml", "tags.csv"])
def test_names_that_are_not_utf_8_are_refused(own_home, name):
    (own_home / name).write_bytes(b"\xf1 = 1")
    assert "Save the file as UTF-8." in told("tags", "import", name, code=1)
    assert json.loads(told("tags", "--json")) == {}
