"""Messages between page and server about block sets."""

import json

import pytest

from pages import english

LESSON = {"name": "lesson", "title": {"en": "A lesson"}, "show": {"blocks": ["lb_main"]}}
HOSTILE = [
    {"name": "x", "show": {"blocks": ["y"] * 1001}},
    {"name": "x", "show": {"blocks": [""]}},
    {"name": "x", "show": {"blocks": ["y" * 201]}},
    {"name": "x", "title": {"en": "y" * 101}},
    {"name": "x", "title": {f"l{one}": "y" for one in range(51)}},
    {"name": "x", "more": 1},
    {"name": 3},
    "lesson",
]


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    return tmp_path / "home"


def told(page, kind, **values):
    page.say("ListBlockSets", **values)
    return page.hear(kind)


def saved(projects, name="program"):
    return json.loads((projects / f"{name}.learnblock").read_text("utf-8"))


def test_a_new_project_shows_everything(page):
    page.open()
    assert page.last["BlocksShown"]["set"]["name"] == "everything"


def test_every_page_of_a_project_shows_the_set_chosen_by_one(server, page):
    page.open()
    with server.visit() as other:
        other.say("Open", name="program")
        other.hear("Document")
        page.say("ChooseBlockSet", set=LESSON)
        for one in (page, other):
            assert one.hear("BlocksShown", set=LESSON)["carried"] == [LESSON]


def test_a_set_is_saved_in_its_project_and_restored_after_others(server, page, projects):
    page.open()
    page.say("ChooseBlockSet", set=LESSON)
    page.hear("BlocksShown", set=LESSON)
    ours = told(page, "BlockSets")["ours"]
    page.say("ChooseBlockSet", set=ours[0])
    assert page.hear("BlocksShown", set=ours[0])["carried"] == [LESSON]
    page.say("Export", format="learnblock")
    exercise = page.hear("File")["text"]
    assert json.loads(exercise)["shown"] == "first-steps"
    page.say("Import", filename="exercise.learnblock", text=exercise)
    page.hear("Opened", name="exercise")
    shown = page.hear("BlocksShown")
    assert (shown["set"], shown["carried"]) == (ours[0], [LESSON])


def test_a_project_that_shows_everything_does_not_store_that(page):
    page.open()
    page.say("Export", format="learnblock")
    assert {"shown", "block_sets"} & json.loads(page.hear("File")["text"]).keys() == set()


def test_a_project_with_an_unknown_set_opens_with_all_blocks(page):
    text = json.dumps({"learnblock": 1, "blocktext": [], "shown": "tuesday"})
    page.say("Import", filename="a.learnblock", text=text)
    page.hear("Opened")
    assert page.hear("BlocksShown")["set"]["name"] == "everything"
    assert "There is no block set 'tuesday'" in english(page.hear("Failed")["message"])


def test_sets_are_saved_listed_exported_read_and_deleted(page, own_home):
    page.open()
    page.say("SaveBlockSet", set=LESSON)
    assert page.hear("BlockSets")["own"] == [LESSON]
    page.say("SaveBlockSet", set=LESSON)
    assert "already" in english(page.hear("Failed")["message"])
    page.say("ExportBlockSet", set=LESSON)
    file = page.hear("File")
    assert file["filename"] == "lesson.toml"
    page.say("DeleteBlockSet", name="lesson")
    assert page.hear("BlockSets")["own"] == []
    page.say("ReadBlockSet", filename="lesson.toml", text=file["text"])
    assert page.hear("BlockSetRead")["set"] == LESSON
    assert list(own_home.rglob("*.toml")) == []


@pytest.mark.parametrize("wrong", HOSTILE, ids=lambda one: json.dumps(one)[:40])
@pytest.mark.parametrize("kind", ["ChooseBlockSet", "SaveBlockSet", "ExportBlockSet"])
def test_a_broken_set_is_refused(kind, wrong, page):
    page.open()
    page.say(kind, set=wrong)
    assert english(page.hear("Failed")["message"])
    page.pulse()


@pytest.mark.parametrize("name", ["../x", "/etc/x", "", "everything", "first-steps", "a\0b"])
def test_a_name_that_is_a_path_or_built_in_is_refused(name, page, own_home):
    page.open()
    for kind in ("ChooseBlockSet", "SaveBlockSet"):
        page.say(kind, set={**LESSON, "name": name})
        assert page.hear("Failed")["refused"] == kind
    page.say("DeleteBlockSet", name=name or "x")
    assert page.hear("Failed")["refused"] == "DeleteBlockSet"
    assert list(own_home.rglob("*.toml")) == []


def test_the_number_of_sets_in_a_project_is_limited(page):
    page.open()
    for number in range(10):
        page.say("ChooseBlockSet", set={**LESSON, "name": f"lesson {number}"})
        shown = page.hear("BlocksShown")
        while shown["set"]["name"] != f"lesson {number}":
            shown = page.hear("BlocksShown")
    assert [one["name"] for one in shown["carried"]] == [
        f"lesson {number}" for number in range(9, 1, -1)
    ]


def test_a_text_that_would_take_long_to_read_is_refused(page):
    page.open()
    page.say("ReadBlockSet", filename="deep.toml", text="a." * 40_000 + "b = 1")
    assert "nested" in english(page.hear("Failed")["message"])
