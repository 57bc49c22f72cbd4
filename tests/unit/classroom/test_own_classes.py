"""The teacher's classes without a terminal: a page of the teacher's own LearnBlock has them."""

import itertools
from urllib.parse import parse_qs, urlsplit

import pytest

from classes import Class
from learnblock.classroom.own_classes import OwnClasses
from learnblock.classroom.roster import FILE, Roster, class_folder
from learnblock.project.files.writer import FolderClaim
from pages import TOKEN, english, serving

pytestmark = [pytest.mark.realtime, pytest.mark.slow]

AUTHORIZED = {"cookie": f"learnblock_token_page={TOKEN}"}


@pytest.fixture
def server(tmp_path):
    with serving(tmp_path / "projects", classes=OwnClasses) as server:
        yield server


@pytest.fixture
def page(server):
    with server.visit() as page:
        page.hear("Welcome")
        yield page


class Started(Class):
    """A class that the page has started."""

    def __init__(self, wall):
        address = urlsplit(wall)
        self.port, self.key = address.port, parse_qs(address.query)["key"][0]
        self.folder = class_folder("7b")
        self.word = Roster(self.folder, "7b").word
        self._devices = itertools.count(1)


def test_a_class_starts_beside_a_file_that_is_named_as_learnblock_is(page, tmp_path, monkeypatch):
    (tmp_path / "learnblock.py").write_text("raise SystemExit('not LearnBlock')\n")
    monkeypatch.chdir(tmp_path)
    page.say("StartClass", title="7b", request=1)
    assert page.hear("ClassOpened")["wall"]


def classes(page):
    page.say("ListClasses")
    return page.hear("Classes")["classes"]


def test_a_class_is_started_with_its_lesson_and_blocks_closed_and_deleted_from_the_page(page):
    page.say(
        "StartClass",
        title="7b",
        lesson="1-01-first-drive",
        project="A drive",
        blocks="first-steps",
        request=1,
    )
    wall = page.hear("ClassOpened")["wall"]
    assert [(each["title"], each["wall"]) for each in classes(page)] == [("7b", wall)]
    room = Started(wall)
    with room.pupil("Ana").page() as pupil:
        assert pupil.hear("Opened")["name"] == "A drive"
        assert pupil.hear("LessonShown")
        pupil.say("New", name="mine")
        assert pupil.hear("BlocksShown")["set"]["name"] == "first-steps"
    page.say("DeleteClass", title="7b")
    assert "open already" in english(page.hear("Failed", refused="DeleteClass")["message"])
    page.say("CloseClass", title="7b")
    [closed] = page.hear("Classes")["classes"]
    assert (closed["pupils"], closed.get("wall")) == (1, None)
    page.say("DeleteClass", title="7b")
    assert page.hear("Classes")["classes"] == []


def test_a_class_that_a_terminal_has_opened_is_shown_and_can_be_closed_too(page, own_home):
    room = Class(own_home)
    [entry] = classes(page)
    assert urlsplit(entry["wall"]).port == room.port
    page.say("StartClass", title="7b")
    assert page.hear("ClassOpened")["wall"] == entry["wall"]
    assert page.hear("Classes")["classes"] == [entry]
    page.say("CloseClass", title="7b")
    assert page.hear("Classes")["classes"][0].get("wall") is None
    assert room._gone() == 0


def test_a_class_that_crashed_is_closed(page, own_home):
    room = Class(own_home)
    room.kill()
    assert [each.get("wall") for each in classes(page)] == [None]


def test_a_class_is_downloaded_deleted_and_opened_again_from_its_file(page, server):
    folder = class_folder("7b")
    pupil, _ = Roster(folder, "7b").add("Ana")
    work = folder / "pupils" / pupil.id / "projects" / ".history" / "mine" / "1.json"
    work.parent.mkdir(parents=True)
    work.write_text("{}")
    file = server.get("/classes/7b.lbclass", **AUTHORIZED).body
    before = (folder / FILE).read_bytes()
    taken = server.post("/classes", file, **AUTHORIZED)
    assert b"class-exists" in taken.body
    page.say("DeleteClass", title="7b")
    page.hear("Classes")
    assert server.post("/classes", file, **AUTHORIZED).body == b'"7b"'
    assert ((folder / FILE).read_bytes(), work.read_text()) == (before, "{}")


def test_only_a_page_at_the_computer_itself_has_classes(server):
    with server.visit(additional_headers={"x-forwarded-for": "192.0.2.1"}) as page:
        for kind in ("ListClasses", "StartClass", "CloseClass", "DeleteClass"):
            page.say(kind, **({} if kind == "ListClasses" else {"title": "7b"}))
            assert page.hear("Failed", refused=kind)["message"]["code"] == (
                "server-classes-only-here"
            )
    away = {**AUTHORIZED, "x-forwarded-for": "192.0.2.1"}
    assert b"only-here" in server.get("/classes/7b.lbclass", **away).body
    assert b"only-here" in server.post("/classes", b"", **away).body
    assert server.get("/classes/7b.lbclass").status == 403


def test_a_damaged_class_is_listed_with_what_is_wrong(page):
    folder = class_folder("7b")
    folder.mkdir(parents=True)
    (folder / FILE).write_text("{")
    [entry] = classes(page)
    assert entry["problem"]["code"] == "class-damaged"


def test_the_file_of_an_open_class_is_not_written_by_who_only_reads_it():
    folder = class_folder("7b")
    Roster(folder, "7b").add("Ana")
    reader = Roster(folder, "7b")
    Roster(folder, "7b").add("Leo")
    assert len(Roster(folder, "7b").pupils) == 2
    assert len(reader.pupils) == 1


def test_a_description_without_the_key_shows_no_wall():
    folder = class_folder("7b")
    Roster(folder, "7b")
    with FolderClaim(folder) as writer:
        assert writer.claim()
        writer.describe("http://192.0.2.1", "another key")
        assert OwnClasses().entries()[0].wall == ""
