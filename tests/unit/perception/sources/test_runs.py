"""Runs whose robot sees through a component, or through a camera with emotions off."""

import re
import subprocess
import sys

import pytest
from click.testing import CliRunner

from ice_runtime import components
from learnblock.cli import main
from learnblock.emulators import emulate
from learnblock.ice.robocomp import Layout
from learnblock.perception.robocomp import serve
from learnblock.perception.sources import TABLE
from learnblock.robots import connect
from runs import run_file
from shown_pictures import a_face
from videos import record
from waiting import wait_for

pytestmark = pytest.mark.realtime

#: A user's own robot: a real one, without a camera.
MINE = """
from learnblock.devices import Base
from learnblock.robots.real import RealRobot
from learnblock.robots.settings import RobotSettings


class Robot(RealRobot[RobotSettings]):
    settings_type = RobotSettings

    def connect(self):
        self.add(Base(lambda adv, rot: None))
"""


@pytest.fixture
def mine(own_home):
    (own_home / "robots").mkdir()
    (own_home / "robots" / "mine.py").write_text(MINE)
    return "mine"


def run(folder, robot, *lines, **options):
    """Run a program of these lines, and return what it printed."""
    program = folder / "program.py"
    program.write_text("\n".join(["from learnblock.robots.sim_ebo import Robot", "",
                                  "robot = Robot()", *lines, ""]))  # fmt: skip
    finished = run_file(program, robot, **options)
    return finished.report, [line["print"] for line in finished.entries("print")]


def test_a_simulated_robot_sees_through_a_third_party_component(tmp_path):
    with components(tmp_path, Layout.TOOL, "apriltag", quiet=True) as running:
        TABLE.change("apriltag", f"127.0.0.1:{running.ports[0]}")
        TABLE.change("patience", "10")
        report, printed = run(
            tmp_path, "sim-ebo",
            "print(robot.is_tag(8), robot.tag_on_the_center(8), robot.is_tag(3))",
            world="empty",
        )  # fmt: skip
    assert report.ended == "finished"
    # It finds that tag in every picture.
    assert printed == ["True True False"]


def test_a_missing_component_ends_a_run_with_a_phrase(tmp_path):
    TABLE.change("apriltag", "127.0.0.1:1")
    report, _ = run(tmp_path, "sim-ebo", "robot.stop_bot()", "robot.is_any_tag()")
    assert report.ended == "error"
    message = report.error["message"]
    assert message.code == "perception-component-unreachable"
    assert message.values["address"] == "127.0.0.1:1"
    assert report.error["line"] == 5


def test_another_process_can_search_the_pictures(tmp_path):
    command = [sys.executable, "-m", "learnblock", "component", "apriltag", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        port = re.search(r"-p (\d+)", process.stdout.readline())[1]
        TABLE.change("apriltag", f"localhost:{port}")
        program = (
            "print(robot.is_any_tag())",
            "robot.turn(135)",
            "print(robot.is_any_tag(), robot.is_tag(2), robot.tag_on_the_center(2))",
        )
        seen = run(tmp_path, "sim-ebo", *program, world="tags")
        process.terminate()
        process.wait(10)
    TABLE.change("apriltag", None)
    ours = run(tmp_path, "sim-ebo", *program, world="tags")
    assert [report.ended for report, _ in (seen, ours)] == ["finished"] * 2
    assert seen[1] == ours[1] == ["False", "True True True"]


def test_a_component_searches_the_pictures_of_a_real_robot():
    adapter, port = serve("apriltag", port=0)
    TABLE.change("apriltag", f"127.0.0.1:{port}")
    with (
        adapter,
        emulate("rcis", "tags") as emulation,
        connect("rcis", **emulation.settings) as robot,
    ):
        with emulation.twin.body() as body:
            x, y, _ = body.pose
            body.place(x, y, 135)
        wait_for(lambda: robot.is_tag(2), "it sees the tag")
        assert robot.detect("emotions") is None


def test_on_a_real_robot_emotions_have_no_effect_until_they_are_switched_on(mine, tmp_path):
    TABLE.change("video", str(record(tmp_path / "face.avi", [a_face("joy")] * 5)))
    look = "print(robot.is_there_face(), robot.is_any_face_happy())"
    report, printed = run(tmp_path, mine, look)
    assert printed == ["True False"]
    assert [(one["skill"], one["device"]) for one in report.no_effect] == [
        ("is_any_face_happy", "Detector:emotions")
    ]
    TABLE.change("emotions_on_cameras", "true")
    report, printed = run(tmp_path, mine, look)
    assert (printed, report.no_effect) == (["True True"], ())


def test_the_report_says_why_emotions_had_no_effect(mine, tmp_path):
    TABLE.change("video", str(record(tmp_path / "face.avi", [a_face("joy")] * 5)))
    program = tmp_path / "look.bt"
    program.write_text("main:\n    print(function.is_any_face_happy())\nend\n")
    result = CliRunner().invoke(main, ["run", str(program), "--robot", mine])
    assert (
        "no effect  is_any_face_happy: mine's camera does not recognise emotions."
        " See: learnblock perception" in result.stderr
    )


def test_on_a_real_robot_no_picture_goes_to_a_component_for_emotions_before_that(mine, tmp_path):
    TABLE.change("video", str(record(tmp_path / "face.avi", [a_face("joy")] * 5)))
    found = {"found": [[10, 10, 50, 50, "Happy"]]}
    with components(tmp_path, Layout.ROBOT, ("emotionrecognition", found)) as running:
        TABLE.change("emotionrecognition", f"127.0.0.1:{running.ports[0]}")
        look = "print(robot.is_any_face_happy())"
        assert run(tmp_path, mine, look)[1] == ["False"]
        assert running.has_told_nothing()
        TABLE.change("emotions_on_cameras", "true")
        assert run(tmp_path, mine, look)[1] == ["True"]
        assert running.told()[:4] == ["processimage", 240, 320, 3]


def test_a_trace_has_the_perception_settings_but_no_addresses(tmp_path):
    TABLE.change("apriltag", "127.0.0.1:1")
    program = tmp_path / "stop.py"
    program.write_text("from learnblock.robots.sim_ebo import Robot\n\nRobot().stop_bot()\n")
    finished = run_file(program, "sim-ebo")
    (line,) = finished.entries("run")
    assert line["run"]["perception"] == ["apriltag"]
    assert b"127.0.0.1" not in finished.trace
