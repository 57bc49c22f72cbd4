"""Messages between page and server about links: what a link proves, and what differs."""

import base64

import pytest

from learnblock.project.files.share_link import read_link
from page_files import content_of
from pages import english, serving

PROGRAM = "main:\n    function.drive_distance(100)\nend\n"
#: The same, and a bit farther.
FARTHER = PROGRAM.replace("100", "120")


@pytest.fixture
def elsewhere(tmp_path, page):
    """A page of another LearnBlock, with a projects folder of its own."""
    # Both are in this process, and worlds are read for the first time in one thread.
    page.hear("Welcome")
    with serving(tmp_path / "elsewhere") as server, server.visit() as visitor:
        yield visitor


def imported(page, text=PROGRAM, filename="square.bt"):
    page.say("Import", filename=filename, text=text)
    page.hear("Opened")


def run(page):
    """Run the program at full speed, and return how it ended."""
    page.say("SetSpeed", factor=None)
    page.say("Run")
    return page.hear("Ended")


def link_of(page):
    page.say("MakeLink", request=7)
    return page.hear("ShareLink", request=7)


def test_a_link_carries_the_run_and_another_learnblock_says_that_its_run_is_the_same(
    page, elsewhere
):
    imported(page)
    ended = run(page)
    answer = link_of(page)
    assert answer["trace_sha256"] == ended["trace_sha256"]
    elsewhere.say("OpenLink", link=f"http://127.0.0.1:8421/#share={answer['link']}")
    assert elsewhere.hear("Opened")["name"] == "square"
    assert "Run compares" in english(elsewhere.hear("Noted")["message"])
    run(elsewhere)
    compared = elsewhere.hear("RunCompared")
    assert (compared["same"], compared["trace_sha256"]) == (True, ended["trace_sha256"])


def test_after_a_change_of_the_program_it_says_what_differs(page, elsewhere):
    imported(page)
    run(page)
    elsewhere.say("OpenLink", link=link_of(page)["link"])
    elsewhere.hear("Opened")
    elsewhere.type(FARTHER)
    run(elsewhere)
    compared = elsewhere.hear("RunCompared")
    first, time = map(english, compared["differences"])
    assert not compared["same"]
    assert first == "The program has changed since it was shared."
    assert time.startswith("The shared run took ")


def test_a_project_of_a_link_is_compared_after_learnblock_was_started_again(page, tmp_path):
    imported(page)
    run(page)
    link = link_of(page)["link"]
    with serving(tmp_path / "later") as server, server.visit() as visitor:
        visitor.say("OpenLink", link=link)
        visitor.hear("Opened")
    with serving(tmp_path / "later") as server, server.visit() as visitor:
        visitor.say("Open", name="square")
        visitor.hear("Opened")
        run(visitor)
        assert visitor.hear("RunCompared")["same"]


def test_the_same_link_opens_the_same_project_until_that_is_changed(page, elsewhere):
    imported(page)
    link = link_of(page)["link"]
    for name in ("square", "square"):
        elsewhere.say("OpenLink", link=link)
        assert elsewhere.hear("Opened")["name"] == name
    elsewhere.type(FARTHER)
    elsewhere.say("OpenLink", link=link)
    assert elsewhere.hear("Opened")["name"] == "square 2"


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (PROGRAM, "Run the program to its end"),
        ('main:\n    print(input("?"))\nend\n', "depended on keys, answers"),
    ],
)
def test_without_a_run_that_can_be_repeated_a_link_says_why_it_proves_nothing(page, text, reason):
    imported(page, text)
    if "input" in text:
        page.say("Run")
        page.hear("InputWanted")
        page.say("Answer", text="7")
        page.hear("Ended")
    answer = link_of(page)
    assert reason in english(answer["problem"])
    assert read_link(answer["link"]).run is None


def test_a_run_of_an_older_program_is_not_what_a_link_proves(page):
    imported(page)
    run(page)
    page.type(FARTHER)
    assert "Run it again" in english(link_of(page)["problem"])


def test_a_stopped_run_is_not_what_a_link_proves(page):
    imported(page, "main:\n    while True:\n        function.sleep(1)\n    end\nend\n")
    page.say("Run")
    page.hear("RunState", state="running")
    page.say("Stop")
    page.hear("Ended")
    assert "was stopped" in english(link_of(page)["problem"])


def test_a_link_brings_the_variant_of_the_world(page, elsewhere):
    imported(page)
    page.say("ChooseWorld", name="line", variant=3)
    page.hear("Settings", world="line")
    run(page)
    elsewhere.say("OpenLink", link=link_of(page)["link"])
    elsewhere.hear("Opened", world="line")
    run(elsewhere)
    assert elsewhere.hear("RunCompared")["same"]


def test_a_project_too_large_for_a_link_says_so(page):
    lines = "".join(f'    print("{number**9}")\n' for number in range(3000))
    imported(page, f"main:\n{lines}end\n")
    answer = link_of(page)
    assert answer["link"] == ""
    assert "Share the file instead" in english(answer["problem"])


def test_a_damaged_link_is_refused_and_opens_nothing(page):
    page.say("OpenLink", link="http://127.0.0.1:8421/#share=1.AAAA")
    assert "damaged or cut off" in english(page.hear("Failed")["message"])
    page.say("ListProjects")
    assert page.hear("Projects")["projects"] == []


def test_the_last_run_is_exported_as_a_page_in_its_language(page):
    imported(page)
    run(page)
    page.say("ExportRun", language="es")
    exported = page.hear("RunExported")
    assert exported["filename"] == "square.html"
    content = content_of(base64.b64decode(exported["content"]).decode())
    [robot] = content["robots"]
    assert (content["language"], content["pupil"], robot["blocktext"]) == ("es", "", PROGRAM)
    assert robot["timeline"]["end"] > 1


def test_a_run_of_several_robots_is_exported_with_all_of_them_and_the_name_that_is_wished(page):
    imported(page)
    page.say("AddTab", robot="sim-ev3")
    page.hear("TabOpened")
    page.type(FARTHER)
    page.say("SetSpeed", factor=None)
    page.say("Run")
    page.hear("RunState", state="starting")
    while any(tab["state"] != "ended" for tab in page.hear("Tabs")["tabs"]):
        pass
    page.say("ExportRun", pupil=" Ada ")
    content = content_of(base64.b64decode(page.hear("RunExported")["content"]).decode())
    assert content["pupil"] == "Ada"
    robots = {robot["name"]: (robot["robot"], robot["blocktext"]) for robot in content["robots"]}
    assert list(robots.values()) == [("sim-ebo", PROGRAM), ("sim-ev3", FARTHER)]
    assert set(robots) == {robot["name"] for robot in content["states"][0][1]}


def test_a_run_of_another_program_is_not_exported(page):
    imported(page)
    page.say("ExportRun")
    assert "nothing to look back at" in english(page.hear("Failed")["message"]).lower()
    run(page)
    page.type(FARTHER)
    page.say("ExportRun")
    assert "has changed since this run" in english(page.hear("Failed")["message"])
