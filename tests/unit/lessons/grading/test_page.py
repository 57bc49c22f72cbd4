"""The page shows what happened, runs nothing, and takes every name for text."""

import re
from html.parser import HTMLParser
from io import StringIO

import pytest

from gradings import GOOD, SHORT, handed_in, plan
from learnblock.i18n import Phrase
from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.html import escaped
from learnblock.lessons.grading.journal import opened_journal
from learnblock.lessons.grading.page import Page
from learnblock.lessons.grading.values import (
    CheckResult,
    HandedIn,
    HintResult,
    Result,
    packed,
)

HOSTILE = '"><script>alert(1)</script><img src=x onerror=alert(2)>\u202etxt.exe\x00'
MISSED = Result(
    checks=(CheckResult("failed", 1.0, {"en": HOSTILE}), CheckResult("met"), CheckResult("open")),
    ended="finished",
    path=((0, 0), (100, 50)),
    hints=(HintResult(HOSTILE, ({"en": HOSTILE, "es": "Mira"},), {"en": "because"}),),
)


class Tags(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags, self.attributes = [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += attrs


@pytest.fixture
def page(tmp_path):
    def made(programs, result=MISSED, language="en"):
        with opened_journal(tmp_path) as journal:
            wanted = plan(programs)
            for one in programs:
                for key, _ in wanted.pieces(one):
                    journal.add(key, packed(result))
            file = StringIO()
            Page(Grading(wanted, journal), language, "drive").write(file)
        return file.getvalue()

    return made


def test_hostile_names_programs_and_texts_are_text(page):
    programs = (HandedIn(HOSTILE, HOSTILE, f"# {HOSTILE}\n{GOOD}"), HandedIn("bo", "bo.bt", SHORT))
    found = Tags(page(programs))
    assert not {"script", "img", "iframe", "link", "base", "form"} & {*found.tags}
    assert not [name for name, _ in found.attributes if name.startswith("on") or name == "style"]


def test_the_page_loads_nothing_and_its_policy_forbids_it(page):
    text = page(handed_in(ana=GOOD))
    found = Tags(text)
    [policy] = [value for name, value in found.attributes if name == "content" and "src" in value]
    assert policy.startswith("default-src 'none'; style-src 'sha256-")
    outside = [value for name, value in found.attributes if name in {"src", "href"}]
    assert all(value.startswith(("#", "data:image/")) for value in outside)
    assert not re.search(r"url\(|@import", text)


def test_programs_with_like_mistakes_are_together(page):
    text = page(handed_in(ana=GOOD, bo=SHORT))
    assert "2 programs miss:" in text


def test_pupils_without_a_program_are_grey_and_have_no_mistakes(page):
    absent = [
        HandedIn(name, name, reason=Phrase("grade-not-begun"), absence="not begun")
        for name in ("dan", "eva")
    ]
    text = page((*absent, *handed_in(ana=SHORT)))
    assert re.findall(
        r"<div class=\"card\"><p>(.*?)</p><p><strong>(\d+)</strong> (.*?)</p>", text
    ) == [
        ("Programs", "1", "tried once"),
        ("Step done", "0", "of 1"),
        ("No program", "2", ""),
        ("Missed most often", "1", "Drive at least 100 mm."),
    ]
    assert "No two programs miss the same checks" in text
    row = re.search(r"<tr><th scope=\"row\"><a [^>]*>dan</a>.*?</tr>", text)[0]
    assert {*re.findall(r'class="(\w+)"', row)} == {"open", "mark"}
    assert "Has not begun this step." in row
    assert re.search(r'class="card pupil open"><summary>dan <[^>]*>Has not begun', text)


def test_the_overview_begins_with_what_a_teacher_has_to_look_at(page, tmp_path):
    absent = HandedIn("dan", "dan", reason=Phrase("grade-not-begun"), absence="not begun")
    met = Result(checks=(CheckResult("met"),) * 3, ended="finished")
    with opened_journal(tmp_path) as journal:
        good, short = handed_in(ana=GOOD, bo=SHORT)
        wanted = plan((absent, good, short))
        for program, result in ((good, met), (short, MISSED)):
            for key, _ in wanted.pieces(program):
                journal.add(key, packed(result))
        file = StringIO()
        Page(Grading(wanted, journal), "en", "drive").write(file)
    rows = re.findall(
        r"<th (?:scope=\"row\"><a [^>]*|scope=\"rowgroup\"[^>]*)>(.*?)</", file.getvalue()
    )
    assert rows == ["To look at · 1", "bo", "Step done · 1", "ana", "No program · 1", "dan"]


def test_a_way_is_drawn_where_it_was_driven(page):
    text = page(handed_in(ana=GOOD))
    picture = re.search(r'<figure><svg viewBox="([^"]*)"', text)[1].split()
    world = re.search(
        r'<use href="#world-0" x="(\d+)" y="(\d+)" width="(\d+)" height="(\d+)"', text
    )
    assert [*world.groups()] == picture


def test_programs_that_are_the_same_are_shown_side_by_side(page):
    assert "ana, bo</summary>" not in page(handed_in(ana=GOOD, bo=SHORT))
    text = page(handed_in(ana=GOOD, bo="# mine\n" + GOOD))
    assert "<summary>ana, bo: same</summary>" in text


def test_the_page_says_that_no_mark_is_final_and_how_to_repeat_a_result(page):
    text = page(handed_in(ana=GOOD))
    assert "No mark is final: you decide." in text
    assert "learnblock grade ana.bt --lesson drive --step 1 --robots sim-ebo" in text


def test_the_page_speaks_spanish(page):
    text = page(handed_in(ana=GOOD), language="es")
    assert "Ninguna nota es definitiva" in text
    assert "Mira" in text


def test_control_characters_and_marks_of_direction_are_not_shown():
    assert escaped("a\x00\u202e<b>") == "a\ufffd\ufffd&lt;b&gt;"
