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
    assert "1 program, tried once. 2 pupils have handed in no program." in text
    assert "No two programs miss the same checks" in text
    row = re.search(r"<tr><th scope=\"row\"><a [^>]*>dan</a>.*?</tr>", text)[0]
    assert {*re.findall(r'class="(\w+)"', row)} == {"open"}
    assert "Has not begun this step." in row
    assert re.search(r'class="pupil open"><summary>dan · Has not begun', text)


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
