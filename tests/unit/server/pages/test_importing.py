"""Messages between page and server about files of the original LearnBlock."""

import base64

from old_projects import examples, main, project, skill
from pages import english


def import_(page, filename, data):
    page.say("ImportOriginal", filename=filename, content=base64.b64encode(data).decode())


def test_a_project_opens_with_its_blocks_in_place_and_a_report(page):
    page.open()
    data = project(main(skill("mover_recto"), skill("subscribe"), place=(12, 34)))
    import_(page, "my robot.blockProject", data)
    assert page.hear("Opened")["name"] == "my robot"
    document = page.hear("Document")
    assert "function.move_straight()" in document["blocktext"]
    (stack,) = document["workspace"]["stacks"]
    assert (stack[0]["type"], stack[0]["x"], stack[0]["y"]) == ("lb_main", 12, 34)
    report = page.hear("OriginalImported")
    assert "now called 'move_straight'" in english(report["changed"][0])
    assert "'subscribe'" in english(report["missing"][0])


def test_projects_of_every_version_open_without_errors(page):
    page.open()
    for number, data in enumerate(examples()):
        import_(page, f"version {number}.blockProject", data)
        assert page.hear("Opened")["name"] == f"version {number}"
        problems = page.hear("Document")["problems"]
        assert [one for one in problems if one.get("severity", "error") == "error"] == []


def test_a_text_of_a_library_opens_as_a_program(page):
    page.open()
    import_(page, "step.lb", b'def step():\n\tprint "a"\nend\n')
    assert page.hear("Opened")["name"] == "step"
    assert 'print("a")' in page.hear("Document")["blocktext"]
