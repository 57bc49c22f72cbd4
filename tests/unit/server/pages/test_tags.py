"""Messages between page and server about tag names."""

import pytest

from pages import english

pytestmark = pytest.mark.realtime


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "home").mkdir()
    return tmp_path / "home"


def test_a_page_receives_the_names_with_its_project(page, own_home):
    (own_home / "tags.toml").write_text("ball = 3\n")
    page.say("New")
    assert page.hear("Tags")["names"] == {"ball": 3}


def test_an_invalid_file_of_tag_names_is_reported_and_the_page_works(page, own_home):
    (own_home / "tags.toml").write_text("ball = 1000\n")
    page.say("New")
    tags = page.hear("Tags")
    assert tags["names"] == {}
    assert english(tags["problem"]).startswith("Line 1: ")
    assert page.run()["ended"] == "finished"


def test_the_page_works_with_an_unreadable_file_of_tag_names(page, own_home):
    (own_home / "tags.toml").mkdir()
    page.say("New")
    assert page.hear("Tags")["problem"]
    assert page.run()["ended"] == "finished"


def test_every_page_receives_new_names(server, page, own_home):
    page.open()
    with server.visit() as other:
        other.open("other")
        page.say("SaveTags", names={"ball": 3})
        for one in (page, other):
            one.hear("Tags", names={"ball": 3})
    assert (own_home / "tags.toml").read_text("utf-8") == "ball = 3\n"


@pytest.mark.parametrize("format_", ["toml", "csv"])
def test_names_are_exported_and_imported(format_, page):
    page.open()
    page.say("SaveTags", names={"ball": 3})
    page.hear("Tags", names={"ball": 3})
    page.say("ExportTags", format=format_)
    file = page.hear("File")
    assert file["filename"] == f"tags.{format_}"
    page.say("ReadTags", filename=file["filename"], text=file["text"])
    assert page.hear("TagsRead")["names"] == {"ball": 3}


def test_tags_can_be_printed(page):
    page.open()
    page.say("SaveTags", names={"<b>": 3})
    page.hear("Tags", names={"<b>": 3})
    page.say("ExportTags", format="html")
    assert "3 &lt;b&gt;</figcaption>" in page.hear("File")["text"]


@pytest.mark.parametrize(
    "names",
    [
        {"ball": 587},
        {"ball": -1},
        {"12": 3},
        {" ": 3},
        {"a\nb": 3},
        {"x" * 101: 3},
        {"ball": "3"},
        {"ball": 1.5},
        {"ball": None},
        {f"x{one}": 1 for one in range(2001)},
    ],
    ids=lambda names: str(names)[:30],
)
def test_an_invalid_dictionary_is_not_saved(names, page, own_home):
    page.open()
    page.say("SaveTags", names=names)
    assert english(page.hear("Failed")["message"])
    assert not (own_home / "tags.toml").exists()
    page.pulse()
