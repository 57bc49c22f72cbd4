"""The keys of a lesson's step are pressed in a run that is watched; else the pupil does it."""

import pytest

from learnblock.lessons.packing import pack
from learnblock.lessons.reading import read_files
from lesson_files import MAIN, files

pytestmark = pytest.mark.realtime

STEERED = """when forward = function.is_key_pressed("up"):
    function.drive_distance(100, 150)
end
"""
CHECK = 'kind = "drives"\nat_least = 80'
KEYS = 'seconds = 4\nkeys = [{ key = "up", at = 1 }]'


@pytest.fixture(autouse=True)
def lesson(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    main = MAIN.partition("[[step.check]]")[0].replace("variants = 1", f"variants = 1\n{KEYS}")
    given = files(f"{main}\n[[step.check]]\n{CHECK}\n", programs__start_bt=STEERED)
    folder = tmp_path / "home" / "lessons"
    folder.mkdir(parents=True)
    (folder / "keyed.lblesson").write_bytes(pack(read_files("keyed", given)))


def state_after(page, kind, **values):
    page.say("SetSpeed", factor=None)
    page.say(kind, **values)
    while (goals := page.hear("LessonGoals")).get("live"):
        pass
    return goals["goals"][0]["state"]


def test_keys_are_pressed_where_a_run_is_watched_and_left_to_the_pupil_else(page):
    page.say("StartLesson", lesson="keyed", name="Keyed", again=False)
    page.hear("LessonShown")
    assert state_after(page, "ShowVariant", robot="sim-ebo", variant=1) == "met"
    assert state_after(page, "Run") == "failed"
