"""Messages between page and server about files of the original LearnBlock."""

import base64

from learnblock.extensions import libraries
from old_projects import LIBRARY, Old, examples, main, project, skill
from pages import english

STEP = b'def step():\n\tprint "a"\nend\n'


def base64_of(data):
    return base64.b64encode(data).decode()


def import_(page, filename, data, **texts):
    found = {name: base64_of(text) for name, text in texts.items()}
    page.say("ImportOriginal", filename=filename, content=base64_of(data), libraries=found)


def convert(page, text, **others):
    files = {name: base64_of(data) for name, data in others.items()}
    page.say("ConvertLibrary", filename="step.lb", content=base64_of(text), **files)


def test_a_project_opens_with_its_blocks_in_place_and_a_report(page):
    page.open()
    data = project(main(skill("mover_recto"), skill("subscribe"), place=(12, 34)))
    import_(page, "my robot.blockProject", data)
    assert page.hear("Opened")["name"] == "my robot"
    document = page.hear("Document")
    assert "function.move_straight()" in document["blocktext"]
    stack = document["workspace"]["stacks"][0]
    assert (stack[0]["type"], stack[0]["x"], stack[0]["y"]) == ("lb_main", 12, 34)
    report = page.hear("OriginalImported")
    assert "now called 'move_straight'" in english(report["changed"][0])
    assert any("'when message = function.received()'" in english(one) for one in report["changed"])
    assert "when message = function.received():" in document["blocktext"]


def test_projects_of_every_version_open_without_errors(page):
    page.open()
    for number, data in enumerate(examples()):
        import_(page, f"version {number}.blockProject", data)
        assert page.hear("Opened")["name"] == f"version {number}"
        problems = page.hear("Document")["problems"]
        assert [one for one in problems if one.get("severity", "error") == "error"] == []


def test_a_text_of_a_library_opens_as_a_program(page):
    page.open()
    import_(page, "step.lb", STEP)
    assert page.hear("Opened")["name"] == "step"
    assert 'print("a")' in page.hear("Document")["blocktext"]


def test_a_project_gets_the_functions_of_the_libraries_that_are_sent_with_it(page):
    page.open()
    data = project(main(Old("step", LIBRARY)), libraries=["C:\\Users\\ana\\step", "other"])
    import_(page, "a.blockProject", data, step=STEP)
    assert "def step():\n    print" in page.hear("Document")["blocktext"]
    report = page.hear("OriginalImported")
    assert ["library 'other' is not" in english(one) for one in report["missing"]] == [True]


def test_a_damaged_library_of_a_project_is_named(page):
    page.open()
    data = project(main(Old("step", LIBRARY)), libraries=["step"])
    import_(page, "a.blockProject", data, step=b"def step(:\n")
    assert "Line 1" in english(page.hear("Failed")["message"])


def test_a_library_of_three_files_becomes_a_file_that_can_be_imported(page):
    page.open()
    words = b'[{"name": "step", "type": "library", "languages": {"EN": "take a step"}}]'
    convert(page, STEP, configuration=words, python=b"def other(lbot): pass\n")
    made = page.hear("LibraryConverted")
    library = libraries.unpack(base64.b64decode(made["content"]), made["filename"])
    assert library.skills["step"].languages["EN"] == "take a step"
    assert "now has brackets" in english(made["changed"][0])
    assert "other" in english(made["missing"][0])


def test_functions_that_can_only_be_used_in_a_program_become_no_library(page):
    page.open()
    convert(page, STEP + b"main:\nstep()\nend\n")
    assert "Open this file alone" in english(page.hear("Failed")["message"])
