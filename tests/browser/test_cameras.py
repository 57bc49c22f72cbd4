"""A real robot with emotion recognition off: the result explains why it has no effect."""

import pytest
from playwright.sync_api import expect

from browser.conftest import Server
from shown_pictures import a_face
from videos import record

#: A real robot without a camera, which uses the video of the settings.
MINE = """
from learnblock.devices import Base
from learnblock.robots.real import RealRobot
from learnblock.robots.settings import RobotSettings


class Robot(RealRobot[RobotSettings]):
    settings_type = RobotSettings

    def connect(self):
        self.add(Base(lambda adv, rot: None))
"""
LOOKING = """\
main:
    print("a face:", function.is_there_face())
    print("happy:", function.is_any_face_happy())
end
"""


@pytest.fixture
def watched(tmp_path):
    """A server with this robot and a video of a happy face."""
    (tmp_path / "robots").mkdir()
    (tmp_path / "robots" / "mine.py").write_text(MINE)
    record(tmp_path / "face.avi", [a_face("joy")] * 5)
    (tmp_path / "settings.toml").write_text('[perception]\nvideo = "face.avi"\n')
    server = Server(tmp_path)
    yield server
    server.stop()


def test_the_result_says_why_emotions_had_no_effect(sit_down, watched):
    pupil = sit_down(watched, empty=True)
    pupil.choose("Robot", "mine (real)")
    pupil.show("Block-Text", "Python")
    pupil.write("blocktext", LOOKING)
    pupil.sees("python", "robot.is_any_face_happy()", "learnblock_home.robots.mine")
    pupil.press("Run")
    pupil.tab("Result")
    result = pupil.page.get_by_role("tabpanel", name="Result")
    expect(result).to_contain_text(
        "is_any_face_happy: emotions are not recognised on this camera."
        " In the stage Coder, Camera recognition in the menu says why."
    )
    pupil.picture("result")
    console = pupil.tab("Console").inner_text()
    assert "a face: True" in console
    assert "happy: False" in console
