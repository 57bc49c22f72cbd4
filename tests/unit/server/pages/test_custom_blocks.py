"""Messages between page and server about custom blocks."""

import json

import pytest

from pages import TOKEN, english

pytestmark = pytest.mark.realtime

WALTZ = '''\
from learnblock.devices import Base


def waltz(robot, times: int = 2) -> None:
    """Dance a waltz."""
    base = robot.device(Base)
    if base is None:
        return
    for _ in range(times):
        base.move(0, 30)
        robot.clock.sleep(1)
    base.stop()
'''
DANCING = "main:\n    function.waltz(1)\nend\n"
COLOUR = '[{"type": "motor", "category": "Ball room", "name": "waltz", "shape": ["blockVertical"]}]'


def save(page, source=WALTZ, name="dance", **more):
    page.say("SaveCustomBlock", name=name, source=source, **more)
    return page.hear("CustomBlockSaved")["name"]


def listed(page):
    # Earlier messages do not count.
    page.pulse()
    page.say("ListCustomBlocks")
    return {one["name"]: one for one in page.hear("CustomBlocks")["blocks"]}


def checked(page, source=WALTZ, **more):
    page.say("CheckCustomBlock", **{"request": 7, "name": "dance", "source": source, **more})
    return page.hear("CustomBlockChecked", request=7)


def codes(told):
    return [(one["part"], one["code"], one.get("line", 0)) for one in told.get("problems", ())]


def types(server, language="en"):
    path = f"/palette/{language}.json"
    palette = json.loads(server.get(path, Cookie=f"learnblock_token={TOKEN}").body)
    return [one["type"] for one in palette["definitions"]]


def healthy(page):
    """Return the next document without problems."""
    while page.hear("Document").get("problems"):
        continue


def test_a_block_is_in_the_palette_and_in_programs_as_soon_as_it_is_saved(server, page):
    page.open(text=DANCING)
    assert "unknown-skill" == page.last["Document"]["problems"][0]["code"]
    assert "lb_skill_waltz" not in types(server)

    assert "dance" == save(page, configuration=COLOUR)
    healthy(page)
    page.hear("PaletteChanged")
    (told,) = page.hear("CustomBlocks")["blocks"]
    assert (["waltz"], "Ball room") == (told["blocks"], told["category"])
    assert "lb_skill_waltz" in types(server)
    assert "finished" == page.run()["ended"]


def test_every_page_of_every_project_is_notified(server, page):
    page.open("one")
    with server.visit() as other:
        other.open("two", text=DANCING)
        save(page)
        healthy(other)
        assert {"PaletteChanged", "CustomBlocks"} <= other.heard.keys()
        other.say("Complete", request=1, notation="blocktext", line=2, column=16)
        assert "waltz" in [one["label"] for one in other.hear("Completions")["options"]]


def test_a_block_is_checked_and_shown_before_it_is_saved(page):
    page.open()
    told = checked(page, configuration=COLOUR, language="es")

    assert [] == codes(told)
    (preview,) = told["previews"]
    assert ("waltz", "lb_skill_waltz") == (preview["name"], preview["definition"]["type"])
    assert {"times": {"shadow": {"type": "math_number", "fields": {"NUM": 2}}}} == (
        preview["block"]["inputs"]
    )
    (complete,), (chosen,) = json.loads(told["configuration"]), json.loads(told["chosen"])
    assert {"EN": "Dance a waltz."} == complete["tooltip"]
    assert ({}, "Ball room") == (chosen["tooltip"], chosen["category"])


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("def waltz(robot:\n", ("source", "syntax-error", 1)),
        ("x = 1\ndef turn(robot): ...\n", ("source", "name-taken", 2)),
        ("import nothing_of_the_sort\ndef f(robot): ...\n", ("source", "unknown-import", 1)),
    ],
)
def test_an_invalid_block_is_not_saved_and_reported_with_its_line(page, own_home, source, expected):
    page.open()
    page.say("SaveCustomBlock", name="dance", source=source)
    assert [expected] == codes(page.hear("CustomBlockChecked", request=0))
    assert [expected] == codes(checked(page, source))
    assert not (own_home / "skills").exists()


def test_a_function_is_tried_on_the_robot_without_being_saved(page, own_home):
    page.open()
    page.say("SetSpeed", factor=None)
    source = (
        WALTZ + "\n\ndef count(robot, to: int = 2) -> int:\n    robot.waltz(1)\n    return to + 1\n"
    )
    page.say("TryCustomBlock", name="dance", source=source, function="count", arguments=[4])
    ended = page.hear("Ended")
    assert ("finished", True, 1.0) == (ended["ended"], ended["tried"], round(ended["time"], 1))
    assert "5\n" == page.last["Printed"]["text"]
    assert not (own_home / "skills").exists()
    page.say("ListHistory")
    assert [] == page.hear("History")["runs"]


def test_an_error_in_a_tried_function_has_the_line_of_its_source(page):
    page.open()
    page.say("TryCustomBlock", name="dance", source="def f(robot):\n    x = 0\n    1 / x\n")
    ended = page.hear("Ended")
    assert ("error", "dance", 3) == (ended["ended"], ended["custom_block"], ended["custom_line"])
    assert ended["message"]["values"]["error"] == "ZeroDivisionError: division by zero"


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"source": "def f(robot: ..."}, "Line 1: This is not valid Python"),
        ({"source": "x = 1\n"}, "no function that takes the robot"),
        ({"source": WALTZ, "function": "walz"}, "Did you mean 'waltz'"),
        (
            {"source": WALTZ, "arguments": [1, 2]},
            "The function 'waltz' takes 0 to 1 values, but got 2",
        ),
        ({"source": WALTZ, "arguments": [{}]}, "A block can only use numbers, text"),
    ],
)
def test_a_block_that_cannot_be_tried_is_refused(page, values, message):
    page.open()
    page.say("TryCustomBlock", name="dance", **values)
    assert message in english(page.hear("Failed", refused="TryCustomBlock")["message"])


def test_an_error_in_a_block_is_reported_with_its_line_and_the_calling_block(page):
    page.open(text=DANCING)
    save(page, WALTZ.replace("base.stop()", "base.halt()"))
    healthy(page)
    page.say("SetSpeed", factor=None)
    ended = page.run()
    assert ("error", "dance", 12) == (ended["ended"], ended["custom_block"], ended["custom_line"])
    assert page.last["Document"]["places"][1][0] == ended["block"]
    assert "halt" in str(ended["message"])


def test_an_endless_block_is_stopped_and_reported_with_its_line(page):
    page.open(text=DANCING)
    save(page, "def waltz(robot, times):\n    while True:\n        times += 1\n")
    healthy(page)
    page.say("Run")
    page.hear("RunState", state="running")
    page.say("Stop")
    assert "stopped" == page.hear("Ended")["ended"]
    page.type("main:\n    print(1)\nend\n")
    assert "finished" == page.run()["ended"]


def test_a_block_that_waits_forever_is_paused_and_stopped(page):
    page.open(text=DANCING)
    save(page, "def waltz(robot, times):\n    while True:\n        robot.clock.sleep(0.1)\n")
    healthy(page)
    page.say("Run")
    page.hear("RunState", state="running")
    page.say("Pause")
    page.hear("RunState", state="paused")
    page.say("Resume")
    page.hear("RunState", state="running")
    page.say("Stop")
    assert "stopped" == page.hear("Ended")["ended"]


def test_a_broken_file_in_the_folder_does_not_affect_others(page, own_home, server):
    page.open(text=DANCING)
    (own_home / "skills").mkdir()
    (own_home / "skills" / "bad.py").write_text("def rumba(robot):\n    (\n")
    (own_home / "skills" / "raising.py").write_text("def tango(robot): ...\n1 / 0\n")
    (own_home / "skills" / "dance.py").write_text(WALTZ)
    found = listed(page)
    assert ("syntax-error", 2) == (
        found["bad"]["problems"][0]["code"],
        found["bad"]["problems"][0]["line"],
    )
    assert {"lb_skill_waltz", "lb_skill_tango"} <= {*types(server)}
    page.say("SetSpeed", factor=None)
    assert "finished" == page.run()["ended"]
    page.type("main:\n    function.rumba()\nend\n")
    message = page.last["Document"]["problems"][0]["message"]
    assert ("check-skill-with-error", "rumba") == (message["code"], message["values"]["name"])
    assert english(message["values"]["reason"]).startswith("bad.py, line 2")
    page.type("main:\n    function.tango()\nend\n")
    ended = page.run()
    assert ("raising", 2) == (ended["custom_block"], ended["custom_line"])


@pytest.mark.certain
def test_a_block_is_renamed_copied_deleted_and_restored(page, own_home):
    page.open()
    save(page, configuration=COLOUR)
    assert "ball" == save(page, name="ball", configuration=COLOUR, replaces="dance")
    assert ["ball"] == [*listed(page)]
    page.say("DuplicateCustomBlock", name="ball", new="hop")
    assert "hop" == page.hear("CustomBlockSaved")["name"]
    assert ["hop"] == listed(page)["hop"]["blocks"]
    page.say("DeleteCustomBlock", name="ball")
    assert ["hop"] == [*listed(page)]
    page.say("RestoreCustomBlock", name="ball")
    assert "ball" == page.hear("CustomBlockSaved")["name"]
    assert "Ball room" == listed(page)["ball"]["category"]


def test_a_block_is_exported_and_imported(page):
    page.open()
    save(page, configuration=COLOUR)
    page.say("ExportCustomBlock", name="dance")
    file = page.hear("File")
    assert "dance.block.json" == file["filename"]
    page.say("ImportCustomBlock", content=file["text"])
    assert "already have a block 'dance'" in english(page.hear("Failed")["message"])
    before = listed(page)
    page.say("ImportCustomBlock", content=file["text"], replace=True)
    page.hear("CustomBlockSaved")
    assert before == listed(page)


@pytest.mark.parametrize("name", ["../evil", "a/b", ".hidden", "", "con", "x" * 90])
def test_a_name_never_leaves_the_folder(page, own_home, name):
    page.open()
    page.say("SaveCustomBlock", name=name, source=WALTZ)
    page.hear("Failed")
    for kind in ("DeleteCustomBlock", "ExportCustomBlock", "RestoreCustomBlock"):
        page.say(kind, name=name)
        page.hear("Failed")
    assert not [*own_home.rglob("*.py")]
